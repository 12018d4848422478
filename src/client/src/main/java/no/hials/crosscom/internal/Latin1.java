package no.hials.crosscom.internal;

/** Says what functions 0 and 1 can carry: ISO 8859-1 (docs/reference/c3-messages.md#strings). */
public final class Latin1 {
  private Latin1() {}

  /**
   * Says whether functions 0 and 1 can carry a text.
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
   * Says why functions 0 and 1 cannot carry a text.
   *
   * @param text one that {@link #has} says no to
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
   * Says whether a text that function 0 gave may stand for another. C3 Bridge gives Windows code
   * page 1252, where 80 to 9F are characters beyond ISO 8859-1
   * (docs/reference/c3-messages.md#code-pages); that it gives a question mark for what the code
   * page has not is assumed.
   *
   * @param text any
   * @return true if a read in UTF-16 may give another text
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
