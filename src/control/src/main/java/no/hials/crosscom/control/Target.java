package no.hials.crosscom.control;

/**
 * The variable that a KRL program follows, and its kind.
 *
 * <p>An increment is the argument of {@code PTP_REL}, by which the program moves repeatedly: X, Y,
 * Z in mm and A, B, C as a rotation about the axes of {@code $BASE}, or the axes in degrees. With
 * zeros the robot stands still; see {@link LoopConfig#stepTime}. An absolute target is a position
 * in {@code $BASE} or axis angles.
 *
 * @param name the variable's name
 * @param increment whether it holds an increment
 */
public record Target(String name, boolean increment) {
  /** Checks that the name is not blank. */
  public Target {
    Checks.holds(!name.isBlank(), "the name of the target variable must not be blank");
  }

  /**
   * Returns a variable that holds an increment, such as {@code MYPOS} of {@code actuator.src} and
   * {@code MYAXIS} of {@code ext_move_axis.src}.
   */
  public static Target increment(String name) {
    return new Target(name, true);
  }

  /**
   * Returns a variable that holds an absolute target, such as {@code JOV_POS} of {@code
   * follow_pos.src} and {@code JOV_AXIS} of {@code follow_axis.src}.
   */
  public static Target absolute(String name) {
    return new Target(name, false);
  }
}
