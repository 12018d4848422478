package no.hials.crosscom;

import org.jspecify.annotations.Nullable;

/**
 * Thrown if the server sent bytes that do not answer the request; the message shows the first of
 * them in hex, or names the protocol of the server, such as HTTP. The connection is closed.
 */
public final class CrossComProtocolException extends CrossComException {
  private static final long serialVersionUID = 1L;

  CrossComProtocolException(String message, @Nullable Throwable cause, boolean outcomeUnknown) {
    super(message, cause, outcomeUnknown);
  }
}
