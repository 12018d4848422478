package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/**
 * The axes along a motion, over a parameter from 0 to 1 or to the point where the path has to end.
 */
sealed interface JointPath permits JointPath.OfAxes, JointPath.OfJoints, JointPath.OfTcp {
  Axis at(double parameter) throws MotionRefusedException;

  /** Returns axes near enough to those at a parameter to start an inverse from. */
  Axis near(double parameter);

  Axis start();

  Axis end();

  /** Returns the accelerations for brakes and changes of the override, degrees/s². */
  Axis accelerations();

  /** Returns where a blend into the next motion starts at the earliest: in the last segment. */
  default double earliestLeave() {
    return 0.5;
  }

  /** Returns where a blend from the motion before ends at the latest: in the first segment. */
  default double latestJoin() {
    return 0.5;
  }

  /** Returns the parameter of a point between two segments of the path. */
  default double parameter(int point) {
    return point == 0 ? 0 : 1;
  }

  /** The axes over a parameter. */
  @FunctionalInterface
  interface Function {
    Axis at(double parameter) throws MotionRefusedException;
  }

  /** A curve in the axes. */
  @SuppressWarnings("ArrayRecordComponent") // neither compared nor changed
  record OfJoints(
      Function curve,
      Axis start,
      Axis end,
      Axis accelerations,
      double earliestLeave,
      double latestJoin,
      double[] points)
      implements JointPath {
    @Override
    public double parameter(int point) {
      return points[Math.min(point, points.length - 1)];
    }

    @Override
    public Axis at(double parameter) throws MotionRefusedException {
      return curve.at(parameter);
    }

    @Override
    public Axis near(double parameter) {
      return parameter < 0.5 ? start : end;
    }
  }

  /** A straight line in the axes, of a PTP. */
  record OfAxes(Axis start, Axis end, Axis accelerations) implements JointPath {
    @Override
    public Axis at(double parameter) {
      if (parameter >= 1) {
        return end;
      }
      double[] six = start.toArray();
      for (int axis = 0; axis < six.length; axis++) {
        six[axis] += parameter * (end.get(axis) - start.get(axis));
      }
      return Axis.of(six);
    }

    @Override
    public Axis near(double parameter) {
      return at(parameter);
    }
  }

  /** The curve of a LIN or CIRC. */
  record OfTcp(
      PathSampler sampler,
      Curve curve,
      Frame tool,
      Frame flangeInTool,
      PathRates rates,
      boolean byPose,
      Axis accelerations)
      implements JointPath {
    @Override
    public Axis at(double parameter) throws MotionRefusedException {
      return sampler.at(parameter);
    }

    @Override
    public Axis near(double parameter) {
      return sampler.near(parameter);
    }

    @Override
    public double earliestLeave() {
      return curve instanceof SplineCurve spline && spline.count() > 1
          ? spline.parameter(spline.count() - 1)
          : 0.5;
    }

    @Override
    public double parameter(int point) {
      return curve instanceof SplineCurve spline
          ? spline.parameter(Math.min(point, spline.count()))
          : Math.min(point, 1);
    }

    @Override
    public double latestJoin() {
      return curve instanceof SplineCurve spline ? spline.parameter(1) / 2 : 0.5;
    }

    @Override
    public Axis start() {
      return sampler.axes().get(0);
    }

    @Override
    public Axis end() {
      return sampler.lastAxes();
    }
  }
}
