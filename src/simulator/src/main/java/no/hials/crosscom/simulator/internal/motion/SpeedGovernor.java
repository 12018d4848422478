package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import org.jspecify.annotations.Nullable;

/**
 * Chooses how much of the planned time a cycle takes, so that the robot gets to the override that
 * is wanted as fast as accelerations allow and never leaves the path.
 *
 * <p>What the next cycle may do is the part of the plan's next step for which each axis, and the
 * TCP if it is on a path of its own, changes its speed by no more than its acceleration. Where the
 * plan itself asks for more, as two motions that add up in a blend can, the plan is followed; but
 * no axis exceeds its speed.
 */
final class SpeedGovernor {
  /** The shortest look ahead, in parts of a cycle. */
  static final double SHORTEST = 0.001;

  /** By so much accelerations may be exceeded, so that rounding does not slow a motion down. */
  private static final double TOLERANCE = 1.02;

  private final Arm arm;
  private final double cycle;
  private final AccelerationLimits limits;
  private final Axes last;
  private final Axes now;
  private final @Nullable Frame tcp;
  private final SpeedLimit speedLimit;
  private final double pathStep;
  private final double turnStep;
  private double least;
  private double most;

  /**
   * Looks at a cycle.
   *
   * @param last where the axes were a cycle ago
   * @param now where they are
   * @param speedLimit how fast the robot may be
   */
  SpeedGovernor(
      Arm arm,
      double cycle,
      AccelerationLimits limits,
      Axes last,
      Axes now,
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
      turnStep = from.angle(tcp);
    }
  }

  /**
   * Chooses the part of the cycle.
   *
   * @param wanted the override that is wanted, 0 to 1
   * @param before the part that the cycle before took
   * @param horizon how far to look ahead, in parts of a cycle
   * @param ahead where the axes will be after the horizon
   */
  double rate(double wanted, double before, double horizon, Axes ahead) {
    least = 0;
    most = 1;
    for (int axis = 0; axis < Arm.AXES; axis++) {
      double step = (ahead.get(axis) - now.get(axis)) / horizon;
      most = Math.min(most, fastest(axis) * cycle / Math.abs(step));
      change(now.get(axis) - last.get(axis), step, limits.axes().get(axis));
    }
    PathRates path = limits.path();
    if (path != null && tcp != null) {
      Frame to = arm.tcp(ahead, limits.tool());
      change(pathStep, tcp.distance(to) / horizon, path.acceleration() * 1000);
      change(turnStep, tcp.angle(to) / horizon, path.turnAcceleration());
    }
    if (speedLimit.path() < Double.POSITIVE_INFINITY) {
      most = Math.min(most, speedLimit.path() * 1000 * cycle * horizon / furthest(ahead));
    }
    double rate = Math.max(wanted, Math.min(least, Math.max(wanted, before)));
    return Math.max(0, Math.min(rate, most));
  }

  private double fastest(int axis) {
    return arm.maxSpeed(axis) * speedLimit.axes().get(axis) / 100;
  }

  /** Gives how far the TCP or the flange is away, whichever goes further, mm. */
  private double furthest(Axes ahead) {
    double tool = arm.tcp(now, limits.tool()).distance(arm.tcp(ahead, limits.tool()));
    return Math.max(tool, arm.forward(now).distance(arm.forward(ahead)));
  }

  private void change(double last, double step, double acceleration) {
    if (step == 0) {
      return;
    }
    double change = acceleration * cycle * cycle * TOLERANCE;
    double one = (last - change) / step;
    double other = (last + change) / step;
    least = Math.max(least, Math.min(one, other));
    most = Math.min(most, Math.max(one, other));
  }
}
