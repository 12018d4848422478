package no.hials.crosscom.simulator.internal.data;

import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;

/** Thrown if a program or a data list contains an error. */
public final class KrlErrorException extends Exception {
  private static final long serialVersionUID = 1L;

  private final transient KrlError error;

  public KrlErrorException(Position position, String message) {
    // without a stack trace: the position in the file matters
    super(position + ": " + message, null, false, false);
    this.error = new KrlError(position, message);
  }

  public KrlError error() {
    return error;
  }
}
