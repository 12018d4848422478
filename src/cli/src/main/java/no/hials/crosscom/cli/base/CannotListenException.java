package no.hials.crosscom.cli.base;

import java.io.IOException;

/** Thrown when the mock server cannot be started, for example on a port in use. */
public final class CannotListenException extends IOException {
  private static final long serialVersionUID = 1L;

  public CannotListenException(String message, IOException cause) {
    super(message, cause);
  }
}
