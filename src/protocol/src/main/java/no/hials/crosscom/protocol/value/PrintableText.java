package no.hials.crosscom.protocol.value;

import java.util.Locale;

/**
 * Makes text from outside safe for a line of a terminal or log: values, names, messages of servers.
 *
 * <p>Control characters (C0, DEL, C1), line and paragraph separators, and the characters that
 * change the direction of text become escapes such as {@code \x1B} and {@code \u005Cu202E}. So the
 * text can neither end the line nor change what the terminal shows. A backslash stays as it is.
 */
public final class PrintableText {
  /** The number of characters of a long text that {@link #shortened} keeps at each end. */
  private static final int KEPT = 1000;

  private PrintableText() {}

  /**
   * Escapes the characters that are not safe.
   *
   * @param text any text
   * @return the text on one line
   */
  public static String of(String text) {
    int i = 0;
    while (i < text.length() && isSafe(text.charAt(i))) {
      i++;
    }
    if (i == text.length()) {
      return text;
    }
    StringBuilder line = new StringBuilder(text.length() + 16).append(text, 0, i);
    for (; i < text.length(); i++) {
      char c = text.charAt(i);
      if (isSafe(c)) {
        line.append(c);
      } else {
        line.append(String.format(Locale.ROOT, c <= 0xFF ? "\\x%02X" : "\\u%04X", (int) c));
      }
    }
    return line.toString();
  }

  /**
   * Escapes the characters that are not safe, and leaves out the middle of a long text. For
   * messages and logs, which repeat text from outside.
   *
   * @param text any text
   * @return the text on one line; of more than 2000 characters the first and last 1000, with the
   *     length of the text between them
   */
  public static String shortened(String text) {
    int length = text.length();
    return length <= 2 * KEPT
        ? of(text)
        : of(text.substring(0, KEPT))
            + "... ("
            + length
            + " characters) ..."
            + of(text.substring(length - KEPT));
  }

  private static boolean isSafe(char c) {
    return switch (c) {
      case '\u2028', '\u2029' -> false;
      // marks, embeddings, overrides and isolates of the bidirectional algorithm
      case '\u061C', '\u200E', '\u200F' -> false;
      case '\u202A', '\u202B', '\u202C', '\u202D', '\u202E' -> false;
      case '\u2066', '\u2067', '\u2068', '\u2069' -> false;
      default -> !Character.isISOControl(c);
    };
  }
}
