package no.hials.crosscom.simulator.internal.data;

import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;

/** Says what is wrong with one place of a program or a data list. */
public final class KrlErrorException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient KrlError error;

  /**
   * Makes the exception.
   *
   * @param position where
   * @param message the rule, what it expects and what it found
   */
  public KrlErrorException(Position position, String message) {
    // without a stack trace: the place that matters is in the file
    super(position + ": " + message, null, false, false);
    this.error = new KrlError(position, message);
  }

  /**
   * Gives the place and the message.
   *
   * @return what is wrong
   */
  public KrlError error() {
    return error;
  }
}
