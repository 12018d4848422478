package no.hials.crosscom.simulator.internal.data;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;

/**
 * The codes of characters, for assignments between CHAR and INT: those of Windows-1252, in which a
 * controller writes its files (docs/reference/krl-values.md#scalars); assumed.
 */
final class CharacterCodes {
  private static final Charset WINDOWS = Charset.forName("windows-1252");
  private static final int MAX_CODE = 255;

  private CharacterCodes() {}

  /** Returns the code of a character. */
  static int codeOf(char character) throws RefusedException {
    try {
      return WINDOWS.newEncoder().encode(CharBuffer.wrap(new char[] {character})).get(0) & 0xFF;
    } catch (CharacterCodingException e) {
      if (character <= MAX_CODE) {
        return character; // one of the five bytes that Windows-1252 does not define
      }
      throw new RefusedException(
          Refusal.OUT_OF_RANGE, "a CHAR is in Windows-1252, was given " + character);
    }
  }

  /** Returns the character of a code. */
  static char character(int code) throws RefusedException {
    if (code < 0 || code > MAX_CODE) {
      throw new RefusedException(
          Refusal.OUT_OF_RANGE, "the code of a CHAR is 0 to " + MAX_CODE + ", was given " + code);
    }
    try {
      return WINDOWS.newDecoder().decode(ByteBuffer.wrap(new byte[] {(byte) code})).get(0);
    } catch (CharacterCodingException e) {
      return (char) code;
    }
  }
}
