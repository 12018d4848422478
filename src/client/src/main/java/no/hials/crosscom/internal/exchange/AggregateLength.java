package no.hials.crosscom.internal.exchange;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlSyntaxException;

/** Describes the lengths of the parts of an aggregate that is too long. */
public final class AggregateLength {
  private AggregateLength() {}

  /**
   * Describes an aggregate.
   *
   * @param text its text
   * @return such as {@code (SPEED 9, SEAM 19 (X 5, Y 6))} after a blank, where a length counts
   *     name, blank and value; empty if the text is not an aggregate
   */
  public static String describe(String text) {
    KrlScanner scanner = new KrlScanner(text);
    try {
      return " (" + fields(scanner) + ")";
    } catch (KrlSyntaxException e) {
      return ""; // the controller may know better
    }
  }

  private static String fields(KrlScanner scanner) {
    List<String> parts = new ArrayList<>();
    scanner.openStruct();
    int start = scanner.position();
    while (scanner.nextField()) {
      String name = scanner.fieldName();
      String inner = "";
      if (scanner.hasMore() && scanner.text().charAt(scanner.position()) == '{') {
        inner = " (" + fields(scanner) + ")";
      } else {
        scanner.readFieldValue();
      }
      parts.add(name + " " + (scanner.position() - start) + inner);
      start = scanner.position() + 1; // after the comma
    }
    return String.join(", ", parts);
  }
}
