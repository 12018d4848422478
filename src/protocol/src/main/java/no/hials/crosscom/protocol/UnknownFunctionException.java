package no.hials.crosscom.protocol;

/** Says that a frame is whole but of a function that this codec does not have. */
public final class UnknownFunctionException extends MalformedFrameException {
  private static final long serialVersionUID = 1L;

  private final int id;
  private final int function;

  /**
   * Makes the exception.
   *
   * @param id the frame's id
   * @param function its function byte
   * @param frame a buffer that begins with the frame
   * @param length its length
   */
  UnknownFunctionException(int id, int function, byte[] frame, int length) {
    super("function must be 0 to 3, is " + function, frame, length);
    this.id = id;
    this.function = function;
  }

  /**
   * Gives the frame's id, by which a server answers it.
   *
   * @return 0 to 65535
   */
  public int id() {
    return id;
  }

  /**
   * Gives the function byte.
   *
   * @return 0 to 255
   */
  public int function() {
    return function;
  }
}
