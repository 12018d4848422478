package no.hials.crosscom.control;

/**
 * Limits of the speed, of the step in one cycle and of the tracking error. The unit is mm for a
 * path and degrees for a rotation or an axis.
 *
 * @param speed the highest speed that a law may command, in units per second. The measured speed of
 *     the robot, over 200 ms or more, may be half as much again, since it catches up
 * @param step the largest distance between consecutive targets, in units
 * @param trackingError the largest distance of the robot from the last target, in units
 */
public record MotionLimits(double speed, double step, double trackingError) {
  /** Checks that all are more than 0. */
  public MotionLimits {
    Checks.positive("speed limit", speed);
    Checks.positive("step limit", step);
    Checks.positive("tracking error limit", trackingError);
  }
}
