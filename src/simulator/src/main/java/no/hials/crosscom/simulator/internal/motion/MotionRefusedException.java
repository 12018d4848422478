package no.hials.crosscom.simulator.internal.motion;

/** Says why a motion was not taken into the plan. */
public final class MotionRefusedException extends Exception {
  private static final long serialVersionUID = 1;

  private final MotionProblem problem;

  MotionRefusedException(MotionProblem problem) {
    super(problem.message());
    this.problem = problem;
  }

  /**
   * Gives the cause.
   *
   * @return the rule that the motion breaks, and the numbers
   */
  public MotionProblem problem() {
    return problem;
  }
}
