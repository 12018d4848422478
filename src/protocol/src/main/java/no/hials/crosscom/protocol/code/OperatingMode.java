package no.hials.crosscom.protocol.code;

/**
 * The operating modes of a controller, which the key switch selects: the values of {@code
 * $MODE_OP}.
 */
public enum OperatingMode {
  /**
   * Manual, slow: PTP motions at {@code $RED_T1} %, paths at {@code $VEL_CP_T1} at most; a person
   * holds the enabling switch.
   */
  T1("T1"),
  /** Manual, at programmed speed; a person holds the enabling switch. */
  T2("T2"),
  /** Automatic: nobody holds a switch. */
  AUT("AUT"),
  /** Automatic, started by a higher-level controller only: nobody holds a switch. */
  EXT("EX");

  private final String constant;

  OperatingMode(String constant) {
    this.constant = constant;
  }

  /**
   * Returns the constant of {@code $MODE_OP}, which is {@code #EX} for EXT.
   *
   * @return the constant without {@code #}
   */
  public String constant() {
    return constant;
  }

  /**
   * Returns whether a person has to hold an enabling switch for the robot to move.
   *
   * @return true in T1 and T2
   */
  public boolean manual() {
    return this == T1 || this == T2;
  }
}
