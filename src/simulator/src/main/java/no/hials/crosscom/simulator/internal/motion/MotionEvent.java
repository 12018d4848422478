package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;

/** An event of a motion in a cycle. */
public sealed interface MotionEvent {
  MotionCommand motion();

  /** The robot has started the motion, or the blend into it. */
  record Started(MotionCommand motion) implements MotionEvent {}

  /** The robot is at the end of the motion, or in the middle of the blend into the next. */
  record Passed(MotionCommand motion) implements MotionEvent {}

  /**
   * The motion cannot continue: the robot stands, and all planned motions are discarded.
   *
   * @param axes the position of the robot: the last point of the path within the limits
   */
  record Faulted(MotionCommand motion, MotionProblem problem, Axis axes) implements MotionEvent {}
}
