package no.hials.crosscom.kinematics;

/** Thrown if machine data do not describe a six-axis arm with a spherical wrist. */
public final class MachineDataException extends Exception {
  private static final long serialVersionUID = 1;

  /** The variable that is wrong. */
  private final String variable;

  MachineDataException(String variable, String expected, Object found) {
    super(variable + ": expected " + expected + ", found " + found);
    this.variable = variable;
  }

  /**
   * Returns the variable that is wrong.
   *
   * @return such as {@code $DH_5.DHART_A} or {@code $SOFTN_END[2]}, or a formula that begins with
   *     it
   */
  public String variable() {
    return variable;
  }
}
