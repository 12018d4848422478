package no.hials.crosscom.protocol;

import java.io.IOException;
import java.util.HexFormat;

/** Says that bytes are not a message: which rule they break, and the bytes in hex. */
public class MalformedFrameException extends IOException {
  private static final long serialVersionUID = 1L;

  /** How many bytes of a long frame the message shows. */
  private static final int SHOWN = 256;

  /**
   * Makes the exception.
   *
   * @param what the rule that broke, expected and actual
   * @param frame a buffer that begins with the bytes
   * @param length how many of them there are
   */
  public MalformedFrameException(String what, byte[] frame, int length) {
    super(what + ", frame: " + hex(frame, length));
  }

  /** Says more about a frame of which the rule that it breaks is known. */
  MalformedFrameException(MalformedFrameException cause) {
    super(cause.getMessage(), cause);
  }

  /**
   * Prints bytes as pairs of hexadecimal digits with blanks between.
   *
   * @param bytes a buffer that begins with the bytes
   * @param length how many to print; beyond 256 the rest is only counted
   * @return the text
   */
  public static String hex(byte[] bytes, int length) {
    HexFormat format = HexFormat.ofDelimiter(" ").withUpperCase();
    return length <= SHOWN
        ? format.formatHex(bytes, 0, length)
        : format.formatHex(bytes, 0, SHOWN) + " ... (" + length + " bytes)";
  }
}
