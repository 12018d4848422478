package no.hials.crosscom.simulator;

/** The operating modes of a controller, which the key switch selects. */
public enum OperatingMode {
  /** Manual, slow: PTP motions at {@code $RED_T1} %, the path at {@code $VEL_CP_T1} at most. */
  T1("T1"),
  /** Manual, at programmed speed. */
  T2("T2"),
  /** Automatic. */
  AUT("AUT"),
  /** Automatic, started by a higher-level controller only. */
  EXT("EX");

  private final String constant;

  OperatingMode(String constant) {
    this.constant = constant;
  }

  /**
   * Gives the constant of {@code $MODE_OP} (krl.md 2.8: it is {@code #EX}, not {@code #EXT}).
   *
   * @return the constant without {@code #}
   */
  public String constant() {
    return constant;
  }

  /**
   * Says whether a person has to hold an enabling switch for the robot to move.
   *
   * @return true in T1 and T2
   */
  public boolean manual() {
    return this == T1 || this == T2;
  }
}
