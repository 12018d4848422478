package no.hials.crosscom.cli;

import java.io.IOException;

/** Says that something was not sent to the controller, since the user does not want it. */
final class NotSentException extends IOException {
  private static final long serialVersionUID = 1L;

  NotSentException(String message) {
    super(message);
  }
}
