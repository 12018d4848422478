package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/**
 * Thrown if the client could not connect: unknown host, refused, or no answer in the connect
 * time-out.
 */
public final class CrossComConnectException extends CrossComException {
  private static final long serialVersionUID = 1L;

  CrossComConnectException(String message, @Nullable Throwable cause) {
    super(message, cause, false);
  }
}
