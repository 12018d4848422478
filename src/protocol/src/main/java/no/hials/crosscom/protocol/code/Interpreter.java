package no.hials.crosscom.protocol.code;

import java.util.Optional;

/** The interpreters of the controller (c3-bridge.md, type 10). */
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
   * Finds a constant by its number.
   *
   * @param code any number
   * @return the constant, or nothing if the number is unknown
   */
  public static Optional<Interpreter> from(int code) {
    return WireCode.find(Interpreter.class, code);
  }
}
