package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/** Thrown if the connection broke: the server closed it, or the network failed. */
public final class CrossComConnectionLostException extends CrossComException {
  private static final long serialVersionUID = 1L;

  CrossComConnectionLostException(
      String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(message, cause, outcomeUnknown);
  }
}
