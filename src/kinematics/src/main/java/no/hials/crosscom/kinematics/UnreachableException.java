package no.hials.crosscom.kinematics;

/** Says why a robot cannot bring its flange to a frame. */
public final class UnreachableException extends Exception {
  private static final long serialVersionUID = 1;

  /** The rules that a frame can break. */
  public enum Reason {
    /** The wrist centre is too far away, or too near. */
    REACH,
    /** An axis would have to pass its software limit. */
    AXIS_LIMIT,
    /** The Status or the Turn is not a number that says something. */
    STATUS_OR_TURN
  }

  private final Reason reason;

  UnreachableException(Reason reason, String message) {
    super(message);
    this.reason = reason;
  }

  /**
   * Names the rule that is broken; the message has the numbers.
   *
   * @return the rule
   */
  public Reason reason() {
    return reason;
  }
}
