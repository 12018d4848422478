package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/**
 * The axes along a motion, over a parameter from 0 to 1 or to the point where the path has to end.
 */
sealed interface JointPath permits JointPath.OfAxes, JointPath.OfTcp {
  Axis at(double parameter) throws MotionRefusedException;

  /** Returns axes near enough to those at a parameter to start an inverse from. */
  Axis near(double parameter);

  Axis start();

  Axis end();

  /** Returns the accelerations for brakes and changes of the override, degrees/s². */
  Axis accelerations();

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
    public Axis start() {
      return sampler.axes().get(0);
    }

    @Override
    public Axis end() {
      return sampler.lastAxes();
    }
  }
}
