package no.hials.crosscom.examples;

import java.util.List;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;

/** Parses and prints the texts of KRL values. It needs no controller. */
public final class KrlValues {
  private static final List<String> TEXTS =
      List.of(
          "100",
          "'HFF'",
          "1.5E-05",
          "TRUE",
          "#T1",
          "\"left\"",
          "1.0 2.0 3.0 ",
          "{X 1.5, S 'B010'}");

  private KrlValues() {}

  /**
   * Runs the example.
   *
   * @param args not used
   */
  public static void main(String[] args) {
    for (String text : TEXTS) {
      System.out.println(text + " is a " + describe(KrlValue.parse(text)));
    }

    KrlValue position = KrlValue.parse("{FRAME: X 1000.25, Y 0.0, Z 0.1}");
    if (position instanceof KrlStruct struct) {
      System.out.println("Z in mm: " + struct.get("z").orElseThrow()); // KRL ignores case
      System.out.println("A: " + struct.get("A")); // not initialised, which is not zero
    }
    System.out.println("as a KR C4 prints it: " + position.print());
    System.out.println("to be written: " + position.printShort());
    double exact = KrlReal.of(0.1).value();
    System.out.println("a REAL has 32 bits, so 0.1 is: " + exact);

    try {
      KrlValue.parse("{X 1.0, Y 2.0");
    } catch (KrlSyntaxException e) {
      System.out.println(e.getMessage());
    }
  }

  private static String describe(KrlValue value) {
    if (value instanceof KrlArray array) {
      return "KrlArray of " + array.elements().size();
    }
    return value.getClass().getSimpleName() + ": " + value;
  }
}
