package no.hials.crosscom.control;

import java.io.IOException;

/** Says that a motion was refused: nothing that breaks the named limit was sent. */
public final class ControlRefusedException extends IOException {
  private static final long serialVersionUID = 1;

  private final transient StopReason reason;

  /**
   * Makes an exception.
   *
   * @param reason which limit was broken, by what
   */
  public ControlRefusedException(StopReason reason) {
    super(reason.message(), reason.cause());
    this.reason = reason;
  }

  ControlRefusedException(StopReason.Kind kind, String message) {
    this(new StopReason(kind, message));
  }

  /**
   * Gives the reason.
   *
   * @return which limit was broken, by what
   */
  public StopReason reason() {
    return reason;
  }
}
