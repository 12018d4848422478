package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/**
 * Says that the server sent what is not the answer to the request; the message shows it in hex. The
 * connection is closed.
 */
public final class CrossComProtocolException extends CrossComException {
  private static final long serialVersionUID = 1L;

  CrossComProtocolException(String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(message, cause, outcomeUnknown);
  }
}
