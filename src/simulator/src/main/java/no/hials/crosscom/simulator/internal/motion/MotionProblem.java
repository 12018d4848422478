package no.hials.crosscom.simulator.internal.motion;

import java.io.Serializable;
import java.util.Locale;
import no.hials.crosscom.protocol.value.Axis;

/** The reason why the robot cannot make a motion, or the rest of it. */
public sealed interface MotionProblem extends Serializable {
  /** Returns the rule that the motion breaks, with the numbers. */
  String message();

  /** The number of the message for {@link OutOfReach}. */
  int WORK_ENVELOPE = 9101;

  /** The number of the message for {@link AxisLimit}. */
  int SOFTWARE_LIMIT = 1211;

  /** The number of the message for {@link Singularity}. */
  int SINGULARITY = 9103;

  /** The number of the message for {@link NotACircle}, the first of the three of KSS (assumed). */
  int NO_CIRCLE = 1456;

  /** The number of the message for a motion statement that makes no sense. */
  int BAD_MOTION = 9106;

  int number();

  /**
   * An axis would exceed its software limit.
   *
   * @param axis 0 for A1 to 5 for A6, then E1 to E6
   * @param limit the limit, degrees, or mm if the axis is linear
   * @param value the angle that the motion needs: on a path the one furthest beyond the limit
   */
  record AxisLimit(int axis, double limit, double value) implements MotionProblem {
    @Override
    public String message() {
      return String.format(
          Locale.ROOT,
          "%s must be %s %.3f%s, would be %.3f",
          axis < Axis.COUNT ? "A" + (axis + 1) : "E" + (axis + 1 - Axis.COUNT),
          value > limit ? "at most" : "at least",
          limit,
          axis < Axis.COUNT ? " degrees" : "",
          value);
    }

    @Override
    public int number() {
      return SOFTWARE_LIMIT;
    }
  }

  /**
   * The wrist cannot reach a point.
   *
   * @param message the message of the kinematics
   */
  record OutOfReach(String message) implements MotionProblem {
    @Override
    public int number() {
      return WORK_ENVELOPE;
    }
  }

  /**
   * An axis would have to jump for the path to continue.
   *
   * @param axis 0 for A1 to 5 for A6
   * @param angle the jump, degrees
   */
  record Singularity(int axis, double angle) implements MotionProblem {
    @Override
    public String message() {
      return String.format(
          Locale.ROOT, "A%d would have to jump by %.1f degrees in a singularity", axis + 1, angle);
    }

    @Override
    public int number() {
      return SINGULARITY;
    }
  }

  /** Three points do not define a circle. */
  record NotACircle() implements MotionProblem {
    @Override
    public String message() {
      return "start, auxiliary point and target of a circle must be three points that are not on"
          + " one line";
    }

    @Override
    public int number() {
      return NO_CIRCLE;
    }
  }
}
