package no.hials.crosscom.simulator.internal.motion;

import java.util.List;
import java.util.Optional;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.AxisLimit;
import no.hials.crosscom.simulator.internal.path.Point;

/**
 * The external axes of a controller.
 *
 * @param limits those of E1 and the following, at most six
 * @param rail the way of the robot's root at 1 mm of E1, in the directions of the root; zero if E1
 *     does not carry the robot
 */
public record ExternalAxes(List<Limits> limits, Frame rail) {
  /** A controller with the axes of its robot alone. */
  public static final ExternalAxes NONE = new ExternalAxes(List.of(), Frame.IDENTITY);

  /**
   * The limits of an axis, in degrees, or mm if it is linear.
   *
   * @param minimum the lower software limit
   * @param maximum the upper software limit
   * @param speed the highest speed, per s
   * @param acceleration the highest acceleration, per s²
   */
  public record Limits(double minimum, double maximum, double speed, double acceleration) {}

  public ExternalAxes {
    limits = List.copyOf(limits);
  }

  int count() {
    return limits.size();
  }

  /** Returns the first axis that is beyond a software limit; its index follows that of A6. */
  Optional<AxisLimit> beyondLimit(Axis external) {
    for (int i = 0; i < count(); i++) {
      double value = external.get(i);
      Limits of = limits.get(i);
      if (value < of.minimum() || value > of.maximum()) {
        double limit = value < of.minimum() ? of.minimum() : of.maximum();
        return Optional.of(new AxisLimit(Axis.COUNT + i, limit, value));
      }
    }
    return Optional.empty();
  }

  /** Returns the position of the root for E1, seen from the root at 0. */
  Point root(Axis external) {
    return Point.of(rail).times(external.get(0));
  }
}
