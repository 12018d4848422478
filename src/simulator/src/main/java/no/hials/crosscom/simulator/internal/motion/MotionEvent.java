package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Axes;

/** An event of a motion in a cycle. */
public sealed interface MotionEvent {
  /** Handles an event by its kind. */
  interface Visitor {
    /** Called for {@link Started}. */
    void started(MotionCommand motion);

    /** Called for {@link Passed}. */
    void passed(MotionCommand motion);

    /** Called for {@link Faulted}. */
    void faulted(MotionCommand motion, MotionProblem problem);
  }

  MotionCommand motion();

  /** Calls the method for the kind of event. */
  void accept(Visitor visitor);

  /** The robot has started the motion, or the blend into it. */
  record Started(MotionCommand motion) implements MotionEvent {
    @Override
    public void accept(Visitor visitor) {
      visitor.started(motion);
    }
  }

  /** The robot is at the end of the motion, or in the middle of the blend into the next. */
  record Passed(MotionCommand motion) implements MotionEvent {
    @Override
    public void accept(Visitor visitor) {
      visitor.passed(motion);
    }
  }

  /**
   * The motion cannot continue: the robot stands, and all planned motions are discarded.
   *
   * @param axes the position of the robot: the last point of the path within the limits
   */
  record Faulted(MotionCommand motion, MotionProblem problem, Axes axes) implements MotionEvent {
    @Override
    public void accept(Visitor visitor) {
      visitor.faulted(motion, problem);
    }
  }
}
