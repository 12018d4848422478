package no.hials.crosscom.kinematics;

/** Thrown if a robot cannot reach a frame with its flange. */
public final class UnreachableException extends Exception {
  private static final long serialVersionUID = 1;

  /** The reasons why a frame cannot be reached. */
  public enum Reason {
    /** The wrist centre is too far away or too close. */
    REACH,
    /** An axis would exceed its software limit. */
    AXIS_LIMIT,
    /** The Status or the Turn has bits without a meaning. */
    STATUS_OR_TURN
  }

  private final Reason reason;

  UnreachableException(Reason reason, String message) {
    super(message);
    this.reason = reason;
  }

  /** Returns the reason; the message has the numbers. */
  public Reason reason() {
    return reason;
  }
}
