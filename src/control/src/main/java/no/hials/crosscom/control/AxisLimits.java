package no.hials.crosscom.control;

import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;

/**
 * The range of each axis.
 *
 * @param minimum the smallest angles, degrees
 * @param maximum the largest angles, degrees
 */
public record AxisLimits(Axis minimum, Axis maximum) {
  /** Checks that each minimum is less than its maximum. */
  public AxisLimits {
    for (int i = 0; i < 6; i++) {
      Checks.holds(
          minimum.get(i) < maximum.get(i),
          "the minimum of A"
              + (i + 1)
              + " must be less than its maximum, are "
              + minimum.get(i)
              + " and "
              + maximum.get(i));
    }
  }

  /** Returns the software limits of a robot model. */
  public static AxisLimits of(RobotModel model) {
    double[] minimum = new double[6];
    double[] maximum = new double[6];
    for (int i = 0; i < 6; i++) {
      minimum[i] = model.minimum(i);
      maximum[i] = model.maximum(i);
    }
    return new AxisLimits(Axis.of(minimum), Axis.of(maximum));
  }
}
