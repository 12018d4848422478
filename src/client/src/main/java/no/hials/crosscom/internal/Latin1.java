package no.hials.crosscom.internal;

/**
 * The characters of the files of a controller: ISO 8859-1 (docs/reference/krl-language.md#files).
 */
public final class Latin1 {
  private Latin1() {}

  /** Returns whether a file can hold a text. */
  public static boolean has(CharSequence text) {
    for (int i = 0; i < text.length(); i++) {
      if (text.charAt(i) > 0xFF) {
        return false;
      }
    }
    return true;
  }

  /** Describes the first character of a text that {@link #has} refuses. */
  public static String outside(CharSequence text) {
    int index = 0;
    while (text.charAt(index) <= 0xFF) {
      index++;
    }
    return String.format("has U+%04X at index %d", (int) text.charAt(index), index);
  }
}
