package no.hials.crosscom.simulator.internal.motion;

import java.io.Serializable;
import java.util.Locale;

/** Says why the robot cannot make a motion, or the rest of it. */
public sealed interface MotionProblem extends Serializable {
  /**
   * Says it in a sentence.
   *
   * @return the rule that is broken, with the numbers
   */
  String message();

  /**
   * Tells of an axis that would have to pass its software limit.
   *
   * @param axis 0 for A1 to 5 for A6
   * @param limit the limit, degrees
   * @param value the angle that the motion asks for: of a path, the one furthest beyond
   */
  record AxisLimit(int axis, double limit, double value) implements MotionProblem {
    @Override
    public String message() {
      return String.format(
          Locale.ROOT,
          "A%d must be %s %.3f degrees, would be %.3f",
          axis + 1,
          value > limit ? "at most" : "at least",
          limit,
          value);
    }
  }

  /**
   * Tells of a point that the wrist cannot get to.
   *
   * @param message what the kinematics say
   */
  record OutOfReach(String message) implements MotionProblem {}

  /**
   * Tells of a point where an axis would have to turn in no time for the path to go on.
   *
   * @param axis 0 for A1 to 5 for A6
   * @param angle by how much the axis would have to turn, degrees
   */
  record Singularity(int axis, double angle) implements MotionProblem {
    @Override
    public String message() {
      return String.format(
          Locale.ROOT, "A%d would have to jump by %.1f degrees in a singularity", axis + 1, angle);
    }
  }

  /** Tells of three points through which no circle goes. */
  record NotACircle() implements MotionProblem {
    @Override
    public String message() {
      return "start, auxiliary point and target of a circle must be three points that are not on"
          + " one line";
    }
  }
}
