package no.hials.crosscom.cell;

import java.io.IOException;

/** Says that something was not sent to the controller, since the user does not want it. */
public final class NotSentException extends IOException {
  private static final long serialVersionUID = 1L;

  public NotSentException(String message) {
    super(message);
  }
}
