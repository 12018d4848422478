package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.product;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.kinematics.UnreachableException;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.AxisLimit;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.OutOfReach;
import no.hials.crosscom.simulator.internal.path.Point;

/**
 * The robot for path planning: the inverse ignores the software limits, so that an error can name
 * the axis and the angle beyond its limit.
 */
final class Arm {
  static final int AXES = 6;

  /**
   * An axis beyond a limit by less than this counts as at the limit, degrees; the same as in the
   * kinematics.
   */
  private static final double TOLERANCE = 1e-4;

  /** Further than any axis ever turns, degrees. */
  private static final double FAR = 1e6;

  private final RobotModel robot;
  private final RobotModel unlimited;
  private final ExternalAxes external;

  Arm(RobotModel robot, ExternalAxes external) {
    this.robot = robot;
    this.external = external;
    this.unlimited =
        robot.withLimits(
            new Axis(-FAR, -FAR, -FAR, -FAR, -FAR, -FAR), new Axis(FAR, FAR, FAR, FAR, FAR, FAR));
  }

  double maxSpeed(int axis) {
    return robot.maxSpeed(axis);
  }

  double maxAcceleration(int axis) {
    return robot.maxAcceleration(axis);
  }

  Frame forward(Axis axes) {
    return robot.forward(axes);
  }

  ExternalAxes external() {
    return external;
  }

  /** Returns the TCP, seen from the root at E1 = 0. */
  Frame tcp(Joints joints, Frame tool) {
    return fromOrigin(tcp(joints.robot(), tool), joints.external());
  }

  /** Returns a frame in the present root, seen from the root at E1 = 0. */
  Frame fromOrigin(Frame frame, Axis externalAxes) {
    return external.rail().equals(Frame.IDENTITY)
        ? frame
        : Point.of(frame).plus(external.root(externalAxes)).turnedAs(frame);
  }

  Frame tcp(Axis axes, Frame tool) {
    Frame flange = robot.forward(axes);
    return tool.equals(Frame.IDENTITY) ? flange : product(flange, tool);
  }

  /** Returns the axes nearest to others, inside the limits or not. */
  Axis inverse(Frame tcp, Frame flangeInTool, Axis near) throws MotionRefusedException {
    boolean isFlange = flangeInTool.equals(Frame.IDENTITY);
    try {
      return unlimited.inverse(isFlange ? tcp : product(tcp, flangeInTool), near);
    } catch (UnreachableException e) {
      throw new MotionRefusedException(new OutOfReach(Objects.requireNonNull(e.getMessage())));
    }
  }

  /** Returns the first axis that is beyond a software limit. */
  Optional<AxisLimit> beyondLimit(Axis axes) {
    List<Integer> outside = robot.axesOutsideLimits(axes, -TOLERANCE);
    return outside.isEmpty() ? Optional.empty() : Optional.of(limit(outside.get(0), axes));
  }

  private AxisLimit limit(int axis, Axis axes) {
    double value = axes.get(axis);
    double limit = value > robot.maximum(axis) ? robot.maximum(axis) : robot.minimum(axis);
    return new AxisLimit(axis, limit, value);
  }

  /** Moves axes that are beyond a limit to the limit. */
  Axis clamped(Axis axes) {
    double[] six = axes.toArray();
    for (int axis = 0; axis < AXES; axis++) {
      six[axis] = Math.max(robot.minimum(axis), Math.min(robot.maximum(axis), six[axis]));
    }
    return Axis.of(six);
  }
}
