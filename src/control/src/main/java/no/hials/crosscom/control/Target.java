package no.hials.crosscom.control;

/**
 * The variable that a KRL program follows, and what it holds.
 *
 * <p>An increment is what {@code PTP_REL} wants, and the program moves by it again and again: for
 * X, Y, Z in mm and for A, B, C as a rotation about the axes of {@code $BASE}, or for the axes in
 * degrees. Zeros let the robot stand; see {@link LoopConfig#stepTime}. An absolute target is a
 * position in {@code $BASE} or axis angles.
 *
 * @param name the variable's name
 * @param increment whether it holds an increment
 */
public record Target(String name, boolean increment) {
  /** Refuses a name that is blank. */
  public Target {
    Checks.holds(!name.isBlank(), "the name of the target variable must not be blank");
  }

  /**
   * Names a variable that holds an increment, such as {@code MYPOS} of {@code actuator.src} and
   * {@code MYAXIS} of {@code ext_move_axis.src}.
   *
   * @param name the variable's name
   * @return the target
   */
  public static Target increment(String name) {
    return new Target(name, true);
  }

  /**
   * Names a variable that holds a target, such as {@code JOV_POS} of {@code follow_pos.src} and
   * {@code JOV_AXIS} of {@code follow_axis.src}.
   *
   * @param name the variable's name
   * @return the target
   */
  public static Target absolute(String name) {
    return new Target(name, false);
  }

  /** Gives the variable of the programs in {@code krl} that suits a law best. */
  static Target standard(Law law) {
    if (law instanceof Law.CartesianPosition) {
      return absolute("JOV_POS");
    } else if (law instanceof Law.CartesianVelocity) {
      return increment("MYPOS");
    } else if (law instanceof Law.JointPosition) {
      return absolute("JOV_AXIS");
    }
    return increment("MYAXIS");
  }
}
