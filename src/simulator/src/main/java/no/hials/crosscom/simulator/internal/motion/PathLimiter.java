package no.hials.crosscom.simulator.internal.motion;

import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.path.PathLimits;

/**
 * Computes the limits of points along a path. Half of an axis' acceleration is for the bends of the
 * path, half for the ramps.
 */
final class PathLimiter {
  /** The part of an axis' acceleration that the bends of a path may use, and again its ramps. */
  private static final double SHARE = 0.5;

  private final Arm arm;
  private final AxisRates rates;
  private final double[] parameters;
  private final double[] speeds;
  private final double[] ramps;

  /**
   * Starts with the same limits at all points.
   *
   * @param rates the speeds and accelerations of the axes
   */
  PathLimiter(Arm arm, AxisRates rates, double[] parameters, double speed, double acceleration) {
    this.arm = arm;
    this.rates = rates;
    this.parameters = parameters;
    speeds = new double[parameters.length];
    ramps = new double[parameters.length];
    Arrays.fill(speeds, speed);
    Arrays.fill(ramps, acceleration);
  }

  PathLimits limits() {
    return new PathLimits(parameters, speeds, ramps);
  }

  /** Lowers a limit. */
  void lower(int point, double speed, double acceleration) {
    speeds[point] = Math.min(speeds[point], speed);
    ramps[point] = Math.min(ramps[point], acceleration);
  }

  /** Lowers the limits so that the TCP and its orientation do not exceed their rates. */
  void limitPath(int first, List<Frame> frames, PathRates path) {
    for (int i = first; i < first + frames.size() - 1; i++) {
      double way = parameters[i + 1] - parameters[i];
      Frame from = frames.get(i - first);
      Frame to = frames.get(i + 1 - first);
      double distance = from.distance(to) / way;
      double turn = Frames.angle(from, to) / way;
      double speed = Math.min(path.velocity() * 1000 / distance, path.turnVelocity() / turn);
      double ramp = Math.min(path.acceleration() * 1000 / distance, path.turnAcceleration() / turn);
      lower(i, speed, ramp);
      lower(i + 1, speed, ramp);
    }
  }

  /** Lowers speeds and accelerations so that no axis exceeds its own. */
  void limitAxes(List<Axis> points) {
    limitAxes(points, 0, parameters.length - 1, rates);
    int last = ramps.length - 1;
    ramps[0] = ramps[Math.min(1, last)];
    ramps[last] = ramps[Math.max(0, last - 1)];
  }

  /**
   * Lowers speeds and accelerations from a point to another so that no axis exceeds its own.
   *
   * @param part the speeds and accelerations of the axes there
   */
  void limitAxes(List<Axis> points, int first, int last, AxisRates part) {
    for (int axis = 0; axis < Arm.AXES; axis++) {
      double speed = arm.maxSpeed(axis) * part.velocity().get(axis) / 100;
      double acceleration = arm.maxAcceleration(axis) * part.acceleration().get(axis) / 100;
      limitAxis(points, first, last, axis, speed, acceleration);
    }
  }

  /** Lowers speeds and accelerations so that no external axis exceeds its own. */
  void limitExternalAxes(List<Axis> points) {
    for (int axis = 0; axis < arm.external().count(); axis++) {
      ExternalAxes.Limits of = arm.external().limits().get(axis);
      limitAxis(points, 0, parameters.length - 1, axis, of.speed(), of.acceleration());
    }
  }

  private void limitAxis(
      List<Axis> points, int first, int last, int axis, double most, double acceleration) {
    double share = SHARE * acceleration;
    for (int i = Math.max(1, first); i <= Math.min(last, parameters.length - 2); i++) {
      double before = parameters[i] - parameters[i - 1];
      double after = parameters[i + 1] - parameters[i];
      double here = points.get(i).get(axis);
      double rateIn = (here - points.get(i - 1).get(axis)) / before;
      double rateOut = (points.get(i + 1).get(axis) - here) / after;
      double rate = Math.max(Math.abs(rateIn), Math.abs(rateOut));
      double bend = Math.abs(rateOut - rateIn) / ((before + after) / 2);
      lower(i, Math.min(most / rate, Math.sqrt(share / bend)), share / rate);
    }
  }

  /** Lowers the limits of the first and the last point to those of their neighbours. */
  void limitEnds() {
    int last = speeds.length - 1;
    lower(0, speeds[1], ramps[1]);
    lower(last, speeds[last - 1], ramps[last - 1]);
  }
}
