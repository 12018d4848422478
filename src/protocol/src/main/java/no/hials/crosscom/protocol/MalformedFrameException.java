package no.hials.crosscom.protocol;

import java.io.IOException;
import java.util.HexFormat;

/** Thrown when bytes are not a message; its text has the rule they break and the bytes in hex. */
public class MalformedFrameException extends IOException {
  private static final long serialVersionUID = 1L;

  /** The number of bytes that a message shows of a long frame. */
  private static final int SHOWN = 32;

  /**
   * Creates the exception.
   *
   * @param what the rule that broke, expected and actual
   * @param frame a buffer that begins with the bytes
   * @param length the number of bytes
   */
  public MalformedFrameException(String what, byte[] frame, int length) {
    super(what + ", frame: " + hex(frame, length));
  }

  /** Creates an exception that adds to another one. */
  MalformedFrameException(MalformedFrameException cause) {
    super(cause.getMessage(), cause);
  }

  /**
   * Returns bytes as pairs of hexadecimal digits, separated by blanks, for a message.
   *
   * @param bytes a buffer that begins with the bytes
   * @param length the number of bytes; of more than 32 only the first are printed, and the number
   * @return the text
   */
  public static String hex(byte[] bytes, int length) {
    return hex(bytes, length, SHOWN);
  }

  /**
   * Returns bytes as pairs of hexadecimal digits, separated by blanks.
   *
   * @param bytes a buffer that begins with the bytes
   * @param length the number of bytes
   * @param most the number of bytes to print; if there are more, their number follows
   * @return the text
   */
  public static String hex(byte[] bytes, int length, int most) {
    HexFormat format = HexFormat.ofDelimiter(" ").withUpperCase();
    return length <= most
        ? format.formatHex(bytes, 0, length)
        : format.formatHex(bytes, 0, most) + " ... (" + length + " bytes)";
  }
}
