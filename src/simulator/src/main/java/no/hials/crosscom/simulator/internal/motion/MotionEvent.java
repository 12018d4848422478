package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Axes;

/** Tells what became of a motion in a cycle. */
public sealed interface MotionEvent {
  /**
   * Names the motion.
   *
   * @return the motion as it was added
   */
  MotionCommand motion();

  /**
   * Tells that the robot has set off, or that the blend into the motion has begun.
   *
   * @param motion the motion
   */
  record Started(MotionCommand motion) implements MotionEvent {}

  /**
   * Tells that the robot is at the end of the motion, or in the middle of the blend into the next.
   *
   * @param motion the motion
   */
  record Passed(MotionCommand motion) implements MotionEvent {}

  /**
   * Tells that the motion cannot go on: the robot stands, and everything planned is forgotten.
   *
   * @param motion the motion
   * @param problem why
   * @param axes where the robot stands: the last point of the path that is within the limits
   */
  record Faulted(MotionCommand motion, MotionProblem problem, Axes axes) implements MotionEvent {}
}
