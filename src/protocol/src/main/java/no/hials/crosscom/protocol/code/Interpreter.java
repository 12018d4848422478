package no.hials.crosscom.protocol.code;

/** The interpreters of the controller (type 10). */
public enum Interpreter implements WireCode {
  /** The submit interpreter. */
  SUBMIT(0),
  /** The robot interpreter. */
  ROBOT(1);

  private final int code;

  Interpreter(int code) {
    this.code = code;
  }

  @Override
  public int code() {
    return code;
  }
}
