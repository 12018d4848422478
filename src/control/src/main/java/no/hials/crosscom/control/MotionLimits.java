package no.hials.crosscom.control;

/**
 * How fast something may move, how far in one cycle, and how far it may be from where it should be.
 * The unit is mm for a path and degrees for a rotation or an axis.
 *
 * @param speed the highest speed that a law may ask for, in units a second. What the robot does,
 *     measured over 200 ms or more, may be half as much again, since it catches up
 * @param step the longest way from one target to the next, in units
 * @param trackingError the longest way from the last target to where the robot is, in units
 */
public record MotionLimits(double speed, double step, double trackingError) {
  /** Checks that all are more than 0. */
  public MotionLimits {
    Checks.positive("speed limit", speed);
    Checks.positive("step limit", step);
    Checks.positive("tracking error limit", trackingError);
  }
}
