package no.hials.crosscom.internal.exchange;

import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The length of a value as a controller prints it. */
public final class PrintedLength {
  /** The length of the longest number, such as -2.22039314E-12. */
  private static final int NUMBER = 15;

  /** The length of the longest name of a type, with the colon and the blank after it. */
  private static final int TYPE = 24 + 2;

  /** The largest types of position; a KRLFrame can be written to an E6POS. */
  private static final Set<Set<String>> POSITIONS =
      Set.of(
          Set.of("X", "Y", "Z", "A", "B", "C", "S", "T", "E1", "E2", "E3", "E4", "E5", "E6"),
          Set.of("A1", "A2", "A3", "A4", "A5", "A6", "E1", "E2", "E3", "E4", "E5", "E6"));

  /** A structure without structures or texts in it. */
  private static final Pattern FLAT = Pattern.compile("\\{(?:\\w+:)?([^{}\"]*)}");

  private static final Pattern COMMA = Pattern.compile(",");

  private PrintedLength() {}

  /**
   * Returns the length of the longest text that a controller prints for a value
   * (docs/reference/krl-values.md#real, docs/reference/krl-values.md#structures). A position may
   * have all fields of its largest type, since the controller prints those that were not sent; such
   * fields of other structures are not counted.
   *
   * @param text the value as the client sends it
   */
  public static int longest(String text) {
    int length = missing(text);
    boolean quoted = false;
    boolean start = true;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      quoted ^= c == '"';
      if (start && (Character.isDigit(c) || c == '-' || c == '+' || c == '.')) {
        int end = i + 1;
        while (end < text.length() && " ,}".indexOf(text.charAt(end)) < 0) {
          end++;
        }
        length += Math.max(NUMBER, end - i);
        i = end - 1;
        start = false;
        continue;
      }
      length++;
      if (!quoted && c == '{') {
        length += TYPE;
      } else if (!quoted && c == ',') {
        length++; // a blank
      }
      start = !quoted && (c == ' ' || c == '{' || c == ',');
    }
    return length;
  }

  /** Returns the length of the fields of positions that a text leaves out. */
  private static int missing(String text) {
    int length = 0;
    for (Matcher flat = FLAT.matcher(text); flat.find(); ) {
      Set<String> sent =
          COMMA
              .splitAsStream(flat.group(1))
              .map(field -> field.strip().split(" ", 2)[0].toUpperCase(Locale.ROOT))
              .collect(Collectors.toSet());
      length +=
          POSITIONS.stream()
              .filter(position -> position.containsAll(sent))
              .mapToInt(position -> missing(position, sent))
              .max()
              .orElse(0);
    }
    return length;
  }

  private static int missing(Set<String> position, Set<String> sent) {
    return position.stream()
        .filter(field -> !sent.contains(field))
        .mapToInt(field -> ", ".length() + field.length() + " ".length() + NUMBER)
        .sum();
  }
}
