package no.hials.crosscom.simulator.internal.motion;

/** Thrown when no axes exist for a point of a path. */
final class NoPointException extends Exception {
  private static final long serialVersionUID = 1;

  private final MotionProblem problem;

  NoPointException(MotionProblem problem) {
    super(problem.message());
    this.problem = problem;
  }

  MotionProblem problem() {
    return problem;
  }
}
