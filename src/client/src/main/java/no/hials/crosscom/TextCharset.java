package no.hials.crosscom;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.Charset;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CharsetEncoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import no.hials.crosscom.protocol.value.KrlText;
import org.jspecify.annotations.Nullable;

/**
 * The character set in which KUKAVARPROXY carries texts. The bytes of a message are characters of
 * the same number in a String.
 */
final class TextCharset {
  private final Charset charset;

  TextCharset(Charset charset) {
    this.charset = charset;
  }

  /**
   * Returns whether functions 0 and 1 carry a name or value exactly, whatever the server's code
   * page is: it is ASCII without a double quote, which each text of KRL has
   * (docs/reference/c3-messages.md#code-pages).
   */
  static boolean isPlain(CharSequence value) {
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

  /** Returns whether a charset has the characters of ASCII in the same bytes. */
  static boolean isUsable(Charset charset) {
    StringBuilder ascii = new StringBuilder();
    for (char c = ' '; c < 0x7F; c++) {
      ascii.append(c);
    }
    String text = ascii.toString();
    return charset.canEncode()
        && text.equals(new String(text.getBytes(charset), StandardCharsets.ISO_8859_1));
  }

  /** Returns why a text cannot be sent; null if it can. */
  @Nullable String violation(String text) {
    CharsetEncoder encoder = charset.newEncoder();
    int index = 0;
    for (int next; index < text.length(); index = next) {
      next = text.offsetByCodePoints(index, 1);
      String character = text.substring(index, next);
      if (!encoder.canEncode(character)) {
        return String.format(
            "the charset for KUKAVARPROXY is %s, which does not have %s (U+%04X) at index %d: %s",
            charset.name(), character, character.codePointAt(0), index, text);
      }
    }
    return null;
  }

  /** Returns the bytes of a text that has no {@link #violation}. */
  String encode(String text) {
    return new String(text.getBytes(charset), StandardCharsets.ISO_8859_1);
  }

  /**
   * Returns the text of bytes.
   *
   * @throws IllegalArgumentException if the charset has no character for some of them
   */
  String decode(String bytes) {
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
