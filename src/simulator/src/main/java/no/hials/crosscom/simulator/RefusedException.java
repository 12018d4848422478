package no.hials.crosscom.simulator;

/** Says that the controller refuses an access, and why. */
public final class RefusedException extends Exception {
  private static final long serialVersionUID = 1L;

  private final Refusal reason;

  /**
   * Makes the exception.
   *
   * @param reason why
   * @param message the rule, what it expects and what it found
   */
  public RefusedException(Refusal reason, String message) {
    // without a stack trace: refusing is daily business of a controller, and should be quick
    super(message, null, false, false);
    this.reason = reason;
  }

  /**
   * Gives the reason.
   *
   * @return why the access is refused
   */
  public Refusal reason() {
    return reason;
  }
}
