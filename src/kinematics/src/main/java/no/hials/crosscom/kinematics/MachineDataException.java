package no.hials.crosscom.kinematics;

/** Thrown if machine data do not describe a six-axis arm with a spherical wrist. */
public final class MachineDataException extends Exception {
  private static final long serialVersionUID = 1;

  MachineDataException(String variable, String expected, Object found) {
    super(variable + ": expected " + expected + ", found " + found);
  }
}
