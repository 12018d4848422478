package no.hials.crosscom.internal;

/**
 * The characters that functions 0 and 1 can carry: ISO 8859-1
 * (docs/reference/c3-messages.md#strings).
 */
public final class Latin1 {
  private Latin1() {}

  /**
   * Returns whether functions 0 and 1 can carry a text.
   *
   * @param text any
   * @return true if all its characters are ISO 8859-1
   */
  public static boolean has(CharSequence text) {
    for (int i = 0; i < text.length(); i++) {
      if (text.charAt(i) > 0xFF) {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns why functions 0 and 1 cannot carry a text.
   *
   * @param text a text for which {@link #has} returns false
   * @return the rule, expected and actual
   */
  public static String violation(CharSequence text) {
    int index = 0;
    while (text.charAt(index) <= 0xFF) {
      index++;
    }
    return "must be ISO 8859-1 unless the server is C3 Bridge Interface, has U+"
        + String.format("%04X", (int) text.charAt(index))
        + " at index "
        + index
        + ": "
        + text;
  }

  /**
   * Returns whether a text that function 0 returned may stand for another. C3 Bridge sends Windows
   * code page 1252, where 80 to 9F are characters beyond ISO 8859-1
   * (docs/reference/c3-messages.md#code-pages); that it sends a question mark for other characters
   * is assumed.
   *
   * @param text any
   * @return true if a read in UTF-16 may return another text
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
