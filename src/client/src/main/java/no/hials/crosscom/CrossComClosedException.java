package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/** Says that the client was closed before or while the operation ran. */
public final class CrossComClosedException extends CrossComException {
  private static final long serialVersionUID = 1L;

  CrossComClosedException(String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(message, cause, outcomeUnknown);
  }
}
