package no.hials.crosscom.mock.internal;

import java.nio.charset.Charset;

/**
 * Translates between the texts of UTF-16 messages and those of the controller, whose CHAR is a byte
 * of the Windows code page 1252 (docs/reference/c3-messages.md#code-pages; assumed, with the euro
 * sign of c3-vectors.tsv, "4 read MYUMLAUT[]", for which the stand-in need not have had a byte). A
 * text of the controller has each byte as the character of that number, as in ISO 8859-1.
 */
final class CodePage {
  private static final int FIRST = 0x80;
  private static final int COUNT = 0x20;

  /** The characters of the bytes from 80 to 9F, which are those in which the two differ. */
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

  /** Gives the text that UTF-16 has for one of the controller. */
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

  /** Gives the controller's text for one in UTF-16; what it has no byte for stays as it is. */
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
