package no.hials.crosscom.protocol.code;

/**
 * The states of an interpreter, as {@code $PRO_STATE1} has them
 * (docs/reference/system-variables.md#enumerations).
 */
public enum ProgramState {
  /** No program is selected. */
  FREE,
  /** A program is selected, and is at its beginning. */
  RESET,
  /** The program runs. */
  ACTIVE,
  /** The program was stopped, and can go on. */
  STOP,
  /** The program has come to its end. */
  END;

  /**
   * Gives the constant of {@code $PRO_STATE1}.
   *
   * @return the constant without {@code #}, such as {@code P_FREE}
   */
  public String constant() {
    return "P_" + name();
  }
}
