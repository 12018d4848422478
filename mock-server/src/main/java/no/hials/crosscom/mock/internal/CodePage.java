package no.hials.crosscom.mock.internal;

import java.nio.charset.Charset;

/**
 * Converts between the texts of UTF-16 messages and of the controller. A CHAR of the controller is
 * assumed to be a byte of the Windows code page 1252 (docs/reference/c3-messages.md#code-pages). A
 * text of the controller has the character of the same number for each byte, as in ISO 8859-1.
 */
final class CodePage {
  private static final int FIRST = 0x80;
  private static final int COUNT = 0x20;

  /** The characters of the bytes from 80 to 9F, the only ones in which the code pages differ. */
  private static final String DIFFERENT = different();

  private CodePage() {}

  private static String different() {
    byte[] bytes = new byte[COUNT];
    for (int i = 0; i < COUNT; i++) {
      bytes[i] = (byte) (FIRST + i);
    }
    StringBuilder text = new StringBuilder(new String(bytes, Charset.forName("windows-1252")));
    for (int i = 0; i < COUNT; i++) {
      if (text.charAt(i) == '\uFFFD') {
        text.setCharAt(i, (char) (FIRST + i));
      }
    }
    return text.toString();
  }

  /** Converts a text of the controller to UTF-16. */
  static String widen(String text) {
    StringBuilder out = new StringBuilder(text);
    for (int i = 0; i < out.length(); i++) {
      int index = out.charAt(i) - FIRST;
      if (index >= 0 && index < COUNT) {
        out.setCharAt(i, DIFFERENT.charAt(index));
      }
    }
    return out.toString();
  }

  /** Converts a text in UTF-16 to the controller's. A character without a byte stays. */
  static String narrow(String text) {
    StringBuilder out = new StringBuilder(text);
    for (int i = 0; i < out.length(); i++) {
      int index = DIFFERENT.indexOf(out.charAt(i));
      if (index >= 0) {
        out.setCharAt(i, (char) (FIRST + index));
      }
    }
    return out.toString();
  }
}
