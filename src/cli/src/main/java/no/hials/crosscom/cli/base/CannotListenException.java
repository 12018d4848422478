package no.hials.crosscom.cli.base;

import java.io.IOException;

/** Says that the mock server could not be started, as on a port that is in use. */
public final class CannotListenException extends IOException {
  private static final long serialVersionUID = 1L;

  public CannotListenException(String message, IOException cause) {
    super(message, cause);
  }
}
