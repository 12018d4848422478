package no.hials.crosscom.protocol.code;

import java.util.Optional;

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

  /**
   * Returns the constant with a number.
   *
   * @param code any number
   * @return the constant, or empty if the number is unknown
   */
  public static Optional<Interpreter> from(int code) {
    return WireCode.find(Interpreter.class, code);
  }
}
