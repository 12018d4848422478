package no.hials.crosscom.simulator.internal.motion;

/** Thrown when a motion cannot be planned, or when no axes exist for a point of a path. */
public final class MotionRefusedException extends Exception {
  private static final long serialVersionUID = 1;

  private final MotionProblem problem;

  MotionRefusedException(MotionProblem problem) {
    super(problem.message());
    this.problem = problem;
  }

  public MotionProblem problem() {
    return problem;
  }
}
