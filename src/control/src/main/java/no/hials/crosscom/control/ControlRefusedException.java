package no.hials.crosscom.control;

import java.io.IOException;

/** Thrown if a motion was refused: no command that violates the limit was sent. */
public final class ControlRefusedException extends IOException {
  private static final long serialVersionUID = 1;

  private final transient StopReason reason;

  /**
   * Creates an exception.
   *
   * @param reason the violated limit and the value
   */
  public ControlRefusedException(StopReason reason) {
    super(reason.message(), reason.cause());
    this.reason = reason;
  }

  ControlRefusedException(StopReason.StopKind kind, String message) {
    this(new StopReason(kind, message));
  }

  /** Returns the violated limit and the value. */
  public StopReason reason() {
    return reason;
  }
}
