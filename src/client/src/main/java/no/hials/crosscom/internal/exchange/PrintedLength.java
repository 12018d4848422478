package no.hials.crosscom.internal.exchange;

/** The length of a value as a controller prints it. */
public final class PrintedLength {
  /** The length of the longest number, such as -2.22039314E-12. */
  private static final int NUMBER = 15;

  /** The length of the longest name of a type, with the colon and the blank after it. */
  private static final int TYPE = 24 + 2;

  private PrintedLength() {}

  /**
   * Returns the length of the longest text that a controller prints for a value
   * (docs/reference/krl-values.md#real, docs/reference/krl-values.md#structures). Fields of a
   * structure that the text leaves out are not counted.
   *
   * @param text the value as the client sends it
   */
  public static int longest(String text) {
    int length = 0;
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
}
