package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/** Thrown if the client was closed before or during the operation. */
public final class CrossComClosedException extends CrossComException {
  private static final long serialVersionUID = 1L;

  CrossComClosedException(String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(message, cause, outcomeUnknown);
  }
}
