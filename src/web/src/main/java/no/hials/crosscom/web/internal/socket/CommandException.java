package no.hials.crosscom.web.internal.socket;

import java.io.IOException;

/** Thrown by a command that is not done; its message is a sentence for the person at the page. */
public final class CommandException extends IOException {
  private static final long serialVersionUID = 1L;

  public CommandException(String message) {
    super(message);
  }
}
