package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/**
 * Thrown if no answer came within the request time-out. The connection is closed, so that a late
 * answer cannot be taken for the answer to another request.
 */
public final class CrossComTimeoutException extends CrossComException {
  private static final long serialVersionUID = 1L;

  CrossComTimeoutException(String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(message, cause, outcomeUnknown);
  }
}
