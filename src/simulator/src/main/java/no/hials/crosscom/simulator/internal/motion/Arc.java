package no.hials.crosscom.simulator.internal.motion;

import java.util.OptionalDouble;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.NotACircle;
import no.hials.crosscom.simulator.internal.path.Point;

/** A circular path, about its centre from one radius towards the radius square to it. */
record Arc(Frame start, Frame end, Point centre, Point arm, Point square, double sweep)
    implements Curve {
  /** Three points are on a line if the sine of the angle between them is below this. Assumed. */
  private static final double ON_A_LINE = 1e-6;

  /** Points are the same if they are closer than this, mm. Assumed. */
  private static final double SAME = 1e-3;

  /**
   * Creates the path through three points.
   *
   * @param angle the angle to go in place of the target, degrees; negative in the other direction
   * @param orientation the orientation at the end
   */
  static Arc through(
      Frame start, Frame auxiliary, Frame target, OptionalDouble angle, Frame orientation)
      throws MotionRefusedException {
    Point first = Point.of(start);
    Point toAuxiliary = Point.of(auxiliary).minus(first);
    Point toTarget = Point.of(target).minus(first);
    Point normal = toAuxiliary.cross(toTarget);
    requireACircle(toAuxiliary.length(), toTarget.length(), normal.length());
    Point toCentre =
        normal
            .cross(toAuxiliary)
            .times(toTarget.dot(toTarget))
            .plus(toTarget.cross(normal).times(toAuxiliary.dot(toAuxiliary)))
            .times(1 / (2 * normal.dot(normal)));
    Point arm = toCentre.times(-1);
    // seen against the normal, the circle turns left from start over the auxiliary point to the
    // target
    Point square = normal.times(1 / normal.length()).cross(arm);
    Point last = toTarget.plus(arm);
    double toEnd = Math.atan2(last.dot(square), last.dot(arm));
    double whole = toEnd > 0 ? toEnd : toEnd + 2 * Math.PI;
    double sweep = angle.isPresent() ? Math.toRadians(angle.getAsDouble()) : whole;
    return new Arc(start, orientation, first.plus(toCentre), arm, square, sweep);
  }

  private static void requireACircle(double auxiliary, double target, double area)
      throws MotionRefusedException {
    if (auxiliary < SAME || target < SAME || area < ON_A_LINE * auxiliary * target) {
      throw new MotionRefusedException(new NotACircle());
    }
  }

  @Override
  public Frame at(double parameter) {
    double turned = sweep * parameter;
    return centre
        .plus(arm.times(Math.cos(turned)))
        .plus(square.times(Math.sin(turned)))
        .turnedAs(Curve.isTurn(start, end) ? Frames.interpolate(start, end, parameter) : start);
  }

  /** Returns the direction of the path. */
  Point direction(double parameter) {
    double turned = sweep * parameter;
    Point tangent = square.times(Math.cos(turned)).minus(arm.times(Math.sin(turned)));
    return tangent.times(Math.signum(sweep) / arm.length());
  }

  @Override
  public double length() {
    return Math.abs(sweep) * arm.length();
  }

  @Override
  public double angle() {
    return Frames.angle(start, end);
  }
}
