package no.hials.crosscom.internal;

import no.hials.crosscom.protocol.value.KrlText;

/**
 * The characters that functions 0 and 1 can carry: ISO 8859-1
 * (docs/reference/c3-messages.md#strings).
 */
public final class Latin1 {
  private Latin1() {}

  /** Returns whether functions 0 and 1 can carry a text. */
  public static boolean has(CharSequence text) {
    if (text instanceof KrlText) {
      return true; // always ASCII
    }
    for (int i = 0; i < text.length(); i++) {
      if (text.charAt(i) > 0xFF) {
        return false;
      }
    }
    return true;
  }

  /** Returns why functions 0 and 1 cannot carry a text that {@link #has} refuses. */
  public static String violation(CharSequence text) {
    return "must be ISO 8859-1 unless the server is C3 Bridge Interface, "
        + outside(text)
        + ": "
        + text;
  }

  /** Describes the first character of a text that {@link #has} refuses. */
  public static String outside(CharSequence text) {
    int index = 0;
    while (text.charAt(index) <= 0xFF) {
      index++;
    }
    return String.format("has U+%04X at index %d", (int) text.charAt(index), index);
  }

  /**
   * Returns whether a text that function 0 returned may stand for another. C3 Bridge sends Windows
   * code page 1252, where 80 to 9F are characters beyond ISO 8859-1
   * (docs/reference/c3-messages.md#code-pages); that it sends a question mark for other characters
   * is assumed.
   */
  public static boolean isDoubtful(CharSequence text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '?' || (c >= 0x80 && c <= 0x9F)) {
        return true;
      }
    }
    return false;
  }
}
