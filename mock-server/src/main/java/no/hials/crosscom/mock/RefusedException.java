package no.hials.crosscom.mock;

/** Says that the controller refuses an access, and why. */
final class RefusedException extends Exception {
  private static final long serialVersionUID = 1L;

  private final Refusal reason;

  RefusedException(Refusal reason, String message) {
    // without a stack trace: refusing is daily business of a controller, and should be quick
    super(message, null, false, false);
    this.reason = reason;
  }

  Refusal reason() {
    return reason;
  }
}
