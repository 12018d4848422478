package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/**
 * Thrown if no answer came within the request time-out, which includes waiting for the exchanges of
 * other threads. The connection is closed, so that a late answer cannot be taken for the answer to
 * another request. If the request was not sent, the connection stays.
 */
public final class CrossComTimeoutException extends CrossComException {
  private static final long serialVersionUID = 1L;

  CrossComTimeoutException(String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(message, cause, outcomeUnknown);
  }
}
