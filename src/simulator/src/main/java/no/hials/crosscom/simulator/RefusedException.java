package no.hials.crosscom.simulator;

/** Thrown if the controller refuses an access. */
public final class RefusedException extends Exception {
  private static final long serialVersionUID = 1L;

  private final Refusal reason;

  /**
   * Creates the exception.
   *
   * @param reason the reason
   * @param message the rule, expected and actual
   */
  public RefusedException(Refusal reason, String message) {
    // without a stack trace: refusals are frequent and must be fast
    super(message, null, false, false);
    this.reason = reason;
  }

  /**
   * Returns the reason.
   *
   * @return the reason
   */
  public Refusal reason() {
    return reason;
  }
}
