package no.hials.crosscom.protocol.value;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/**
 * Decodes and encodes KRL files. They do not name their encoding: a controller writes Windows-1252,
 * some editors UTF-8 (docs/reference/krl-language.md#files).
 */
public final class KrlEncoding {
  private static final Charset WINDOWS = Charset.forName("windows-1252");
  private static final char UNDEFINED = '\uFFFD';
  private static final int LAST_BYTE = 0xFF;
  private static final char MARK = '\uFEFF';

  /** A byte order mark of UTF-8 that was read as another encoding. */
  private static final String WRONG_MARK = "\u00EF\u00BB\u00BF";

  private KrlEncoding() {}

  /**
   * Decodes the contents of a file: as UTF-8 if all of it is valid UTF-8, otherwise as
   * Windows-1252.
   *
   * @param contents the bytes of the file
   * @return the text without a byte order mark
   */
  public static String decode(byte[] contents) {
    try {
      CharBuffer text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(contents));
      return withoutMark(text.toString());
    } catch (CharacterCodingException e) {
      return withoutMark(windows(contents));
    }
  }

  /** Decodes Windows-1252; a byte that it does not define is the character of the same number. */
  private static String windows(byte[] contents) {
    char[] text = new String(contents, WINDOWS).toCharArray();
    for (int i = 0; i < text.length; i++) {
      text[i] = text[i] == UNDEFINED ? (char) (contents[i] & 0xFF) : text[i];
    }
    return new String(text);
  }

  /**
   * Encodes the contents of a file, so that {@link #decode} returns them: in Windows-1252 if that
   * is possible, otherwise in UTF-8 with a byte order mark.
   *
   * @param text the text, without a byte order mark
   * @return the bytes of the file
   * @throws CharacterCodingException if a character is half a surrogate pair
   */
  public static byte[] encode(String text) throws CharacterCodingException {
    byte[] windows = windowsBytes(text);
    if (decode(windows).equals(text)) {
      return windows;
    }
    ByteBuffer encoded = StandardCharsets.UTF_8.newEncoder().encode(CharBuffer.wrap(MARK + text));
    byte[] bytes = new byte[encoded.remaining()];
    encoded.get(bytes);
    return bytes;
  }

  /**
   * Encodes the contents of a file in Windows-1252, as a controller does. {@link #decode} returns
   * another text if the bytes are valid UTF-8.
   *
   * @param text the text
   * @return the bytes of the file, one per character
   * @throws IllegalArgumentException if Windows-1252 does not have a character
   */
  public static byte[] encodeWindows(String text) {
    byte[] bytes = windowsBytes(text);
    int index = CharBuffer.wrap(windows(bytes)).mismatch(CharBuffer.wrap(text));
    if (index >= 0) {
      throw new IllegalArgumentException(
          String.format(
              "the text must be Windows-1252, has U+%04X at index %d",
              text.codePointAt(index), index));
    }
    return bytes;
  }

  /** Encodes Windows-1252, as {@link #windows} decodes it; other characters become a "?". */
  private static byte[] windowsBytes(String text) {
    byte[] bytes = text.getBytes(WINDOWS);
    for (int i = 0; i < bytes.length && bytes.length == text.length(); i++) {
      boolean undefined = bytes[i] == '?' && text.charAt(i) <= LAST_BYTE;
      bytes[i] = undefined ? (byte) text.charAt(i) : bytes[i];
    }
    return bytes;
  }

  /**
   * Removes the byte order mark at the beginning of a text.
   *
   * @param text the text of a file
   * @return the text without it; the same text if it has none
   */
  public static String withoutMark(String text) {
    if (!text.isEmpty() && text.charAt(0) == MARK) {
      return text.substring(1);
    }
    return text.startsWith(WRONG_MARK) ? text.substring(WRONG_MARK.length()) : text;
  }
}
