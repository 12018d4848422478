package no.hials.crosscom.protocol.code;

/**
 * The states of an interpreter: the values of {@code $PRO_STATE1}
 * (docs/reference/system-variables.md#enumerations).
 */
public enum ProgramState {
  /** No program is selected. */
  FREE,
  /** A program is selected, and has not started. */
  RESET,
  /** The program runs. */
  ACTIVE,
  /** The program was stopped, and can continue. */
  STOP,
  /** The program has ended. */
  END;

  /**
   * Returns the constant of {@code $PRO_STATE1}.
   *
   * @return the constant without {@code #}, such as {@code P_FREE}
   */
  public String constant() {
    return "P_" + name();
  }
}
