package no.hials.crosscom.mock.internal;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.Charset;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CharsetEncoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.text.Normalizer;
import java.util.List;

/**
 * A code page of Windows, which converts texts as C3 Bridge does in messages 0 and 1
 * (docs/reference/c3-messages.md#code-pages); KUKAVARPROXY is assumed to do the same. Bytes are
 * characters of the same number in a String.
 */
public final class CodePage {
  private static final List<String> NAMES =
      List.of("windows-%d", "x-windows-%d", "x-mswin-%d", "MS%d", "IBM%d");

  /** Letters that have no accent to be removed, and a similar letter for each. */
  private static final String LETTERS = "\u0141\u0142\u0110\u0111\u00D8\u00F8\u0126\u0127\u0131";

  private static final String SIMILAR = "LlDdOoHhi";

  private final Charset charset;

  private CodePage(Charset charset) {
    this.charset = charset;
  }

  /**
   * Returns a code page.
   *
   * @param number such as 1252
   * @throws IllegalArgumentException if there is no such code page
   */
  public static CodePage of(int number) {
    return NAMES.stream()
        .map(name -> String.format(name, number))
        .filter(Charset::isSupported)
        .findFirst()
        .map(name -> new CodePage(Charset.forName(name)))
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "codePage must be a code page of Windows such as 1252, 1251 or 936, is "
                        + number));
  }

  /**
   * Converts a text to bytes by best fit: a character that the page lacks becomes a similar one.
   */
  String encode(String text) {
    if (isAscii(text)) {
      return text;
    }
    CharsetEncoder encoder = charset.newEncoder();
    StringBuilder bytes = new StringBuilder();
    text.codePoints()
        .mapToObj(Character::toString)
        .map(character -> fitting(character, encoder))
        .forEach(bytes::append);
    return bytes.toString();
  }

  private String fitting(String character, CharsetEncoder encoder) {
    char c = character.charAt(0);
    if (encoder.canEncode(character)) {
      return bytes(character);
    }
    if (c >= 0x80 && c <= 0x9F) {
      return character; // assumed: a byte that the page does not define
    }
    int letter = LETTERS.indexOf(c);
    String similar =
        letter >= 0
            ? SIMILAR.substring(letter, letter + 1)
            : Normalizer.normalize(character, Normalizer.Form.NFKD).replaceAll("\\p{M}", "");
    // assumed: a question mark where nothing is similar
    return !similar.isEmpty() && encoder.canEncode(similar) ? bytes(similar) : "?";
  }

  private String bytes(String text) {
    return new String(text.getBytes(charset), StandardCharsets.ISO_8859_1);
  }

  /**
   * Converts bytes to a text. In a page of two bytes, a first byte takes the next one along, even a
   * double quote; the character that both become is assumed.
   */
  String decode(String bytes) {
    if (isAscii(bytes)) {
      return bytes;
    }
    CharsetDecoder decoder = charset.newDecoder();
    boolean single = charset.newEncoder().maxBytesPerChar() == 1;
    ByteBuffer in = ByteBuffer.wrap(bytes.getBytes(StandardCharsets.ISO_8859_1));
    CharBuffer out = CharBuffer.allocate(bytes.length());
    for (CoderResult result = decoder.decode(in, out, true);
        result.isError();
        result = decoder.reset().decode(in, out, true)) {
      char first = (char) (in.get() & 0xFF);
      if (!single && in.hasRemaining()) {
        in.get();
      }
      out.put(single ? first : '?');
    }
    return out.flip().toString();
  }

  private static boolean isAscii(String text) {
    return text.chars().allMatch(c -> c < 0x80);
  }
}
