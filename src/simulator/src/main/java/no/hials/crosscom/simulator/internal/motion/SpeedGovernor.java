package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.angle;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.jspecify.annotations.Nullable;

/**
 * Chooses the part of the planned time that a cycle takes, so that the robot reaches the wanted
 * override as fast as accelerations allow and never leaves the path.
 *
 * <p>In that part of the plan's next step each axis, and the TCP on a LIN or CIRC, changes its
 * speed by no more than its acceleration. Where the plan itself needs more, as two motions that add
 * up in a blend can, the plan wins; but no axis exceeds its speed.
 */
final class SpeedGovernor {
  /** The shortest look ahead, in parts of a cycle. */
  static final double SHORTEST = 0.001;

  /**
   * The factor by which accelerations may be exceeded, so that rounding does not slow a motion
   * down.
   */
  private static final double TOLERANCE = 1.02;

  private final Arm arm;
  private final double cycle;
  private final AccelerationLimits limits;
  private final Joints last;
  private final Joints now;
  private final @Nullable Frame tcp;
  private final SpeedLimit speedLimit;
  private final double pathStep;
  private final double turnStep;
  private double least;
  private double most;

  /** The highest part by the accelerations. */
  private double gentle;

  /**
   * Creates the governor of one cycle.
   *
   * @param last the axes a cycle ago
   * @param now the current axes
   * @param speedLimit the highest speed of the robot
   */
  SpeedGovernor(
      Arm arm,
      double cycle,
      AccelerationLimits limits,
      Joints last,
      Joints now,
      SpeedLimit speedLimit) {
    this.speedLimit = speedLimit;
    this.arm = arm;
    this.cycle = cycle;
    this.limits = limits;
    this.last = last;
    this.now = now;
    if (limits.path() == null) {
      tcp = null;
      pathStep = 0;
      turnStep = 0;
    } else {
      Frame from = arm.tcp(last, limits.tool());
      tcp = arm.tcp(now, limits.tool());
      pathStep = from.distance(tcp);
      turnStep = angle(from, tcp);
    }
  }

  /**
   * Returns the part of the cycle.
   *
   * @param wanted the wanted override, 0 to 1
   * @param before the part of the cycle before
   * @param horizon the look ahead, in parts of a cycle
   * @param ahead the axes after the horizon
   */
  double rate(double wanted, double before, double horizon, Joints ahead) {
    least = 0;
    most = 1;
    gentle = 1;
    Axis steps = ahead.robot().minus(now.robot());
    Axis robotBefore = now.robot().minus(last.robot());
    for (int axis = 0; axis < Arm.AXES; axis++) {
      limit(
          robotBefore.get(axis), steps.get(axis) / horizon, fastest(axis), limits.axes().get(axis));
    }
    Axis externalSteps = ahead.external().minus(now.external());
    Axis externalBefore = now.external().minus(last.external());
    for (int i = 0; i < arm.external().count(); i++) {
      ExternalAxes.Limits of = arm.external().limits().get(i);
      limit(externalBefore.get(i), externalSteps.get(i) / horizon, of.speed(), of.acceleration());
    }
    PathRates path = limits.path();
    if (path != null && tcp != null) {
      Frame to = arm.tcp(ahead, limits.tool());
      change(pathStep, tcp.distance(to) / horizon, path.acceleration() * 1000);
      change(turnStep, angle(tcp, to) / horizon, path.turnAcceleration());
    }
    if (speedLimit.path() < Double.POSITIVE_INFINITY) {
      most = Math.min(most, speedLimit.path() * 1000 * cycle * horizon / furthest(ahead));
    }
    double rate = Math.max(wanted, Math.min(least, Math.max(wanted, before)));
    // where the plan itself speeds up more, it is not slowed down
    double changed = Math.min(rate, Math.max(gentle, Math.min(wanted, before)));
    return Math.max(0, Math.min(changed, most));
  }

  private double fastest(int axis) {
    return arm.maxSpeed(axis) * speedLimit.axes().get(axis) / 100;
  }

  /** Returns the distance of the TCP or the flange, whichever moves further, mm. */
  private double furthest(Joints ahead) {
    double tool = arm.tcp(now, limits.tool()).distance(arm.tcp(ahead, limits.tool()));
    Frame flange = arm.tcp(now, Frame.IDENTITY);
    return Math.max(tool, flange.distance(arm.tcp(ahead, Frame.IDENTITY)));
  }

  private void limit(double last, double step, double speed, double acceleration) {
    most = Math.min(most, speed * cycle / Math.abs(step));
    change(last, step, acceleration);
  }

  private void change(double last, double step, double acceleration) {
    if (step == 0) {
      return;
    }
    double change = acceleration * cycle * cycle * TOLERANCE;
    double one = (last - change) / step;
    double other = (last + change) / step;
    least = Math.max(least, Math.min(one, other));
    gentle = Math.min(gentle, Math.max(one, other));
  }
}
