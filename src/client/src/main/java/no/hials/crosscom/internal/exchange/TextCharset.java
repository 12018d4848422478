package no.hials.crosscom.internal.exchange;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.Charset;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import no.hials.crosscom.protocol.value.KrlText;
import org.jspecify.annotations.Nullable;

/**
 * The character set in which KUKAVARPROXY carries texts. The bytes of a message are characters of
 * the same number in a String.
 */
public final class TextCharset {
  private final Charset charset;

  public TextCharset(Charset charset) {
    this.charset = charset;
  }

  /**
   * Returns whether functions 0 and 1 carry a name or value exactly, whatever the server's code
   * page is: it is ASCII without a double quote, which each text of KRL has
   * (docs/reference/c3-messages.md#code-pages).
   */
  public static boolean isPlain(CharSequence value) {
    if (value instanceof KrlText) {
      return true; // a number, BOOL or structure of numbers
    }
    for (int i = 0; i < value.length(); i++) {
      if (value.charAt(i) >= 0x80 || value.charAt(i) == '"') {
        return false;
      }
    }
    return true;
  }

  /** Returns whether a charset has the characters of ASCII in the same bytes, and the reverse. */
  public static boolean isUsable(Charset charset) {
    StringBuilder ascii = new StringBuilder();
    for (char c = 0; c < 0x80; c++) {
      ascii.append(c); // with ESC, SO and SI, which change the meaning of later bytes of ISO-2022
    }
    String text = ascii.toString();
    byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
    return charset.canEncode()
        && Arrays.equals(bytes, text.getBytes(charset))
        && text.equals(new String(bytes, charset));
  }

  /** Returns why a text cannot be sent; null if its bytes are those of no other text. */
  public @Nullable String violation(String text) {
    String read = new String(text.getBytes(charset), charset);
    if (read.equals(text)) {
      return null;
    }
    int same = Arrays.mismatch(text.toCharArray(), read.toCharArray());
    int index = Math.min(same, text.length() - 1);
    int character = text.codePointAt(index);
    return String.format(
        "the charset for KUKAVARPROXY is %s, which does not have %s (U+%04X) at index %d: %s",
        charset.name(), Character.toString(character), character, index, text);
  }

  /** Returns the bytes of a text that has no {@link #violation}. */
  public String encode(String text) {
    return new String(text.getBytes(charset), StandardCharsets.ISO_8859_1);
  }

  /**
   * Returns the text of bytes.
   *
   * @throws IllegalArgumentException if the charset has no character for some of them
   */
  public String decode(String bytes) {
    ByteBuffer in = ByteBuffer.wrap(bytes.getBytes(StandardCharsets.ISO_8859_1));
    CharsetDecoder decoder = charset.newDecoder();
    CharBuffer out = CharBuffer.allocate((int) (in.remaining() * decoder.maxCharsPerByte()));
    CoderResult result = decoder.decode(in, out, true);
    if (result.isError()) {
      throw new IllegalArgumentException(
          String.format(
              "%s has no character for the byte %02X at index %d",
              charset.name(), in.get(in.position()), in.position()));
    }
    decoder.flush(out);
    return out.flip().toString();
  }
}
