package no.hials.crosscom.cell;

import java.io.IOException;

/** Thrown when a request was not sent, because the user does not allow it or it waited too long. */
public final class NotSentException extends IOException {
  private static final long serialVersionUID = 1L;

  public NotSentException(String message) {
    super(message);
  }
}
