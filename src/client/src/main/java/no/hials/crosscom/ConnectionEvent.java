package no.hials.crosscom;

import java.io.EOFException;
import java.net.ConnectException;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.nio.channels.ClosedByInterruptException;
import java.time.Instant;
import java.util.concurrent.RejectedExecutionException;
import org.jspecify.annotations.Nullable;

/**
 * Something that happened to a client's connection.
 *
 * @param kind what happened
 * @param time when it happened
 * @param reason why the connection was lost, connecting failed or the client was closed; {@link
 *     ChangeReason#NONE} otherwise
 * @param cause the exception if the connection was lost or connecting failed; null otherwise
 */
public record ConnectionEvent(
    ConnectionChange kind, Instant time, ChangeReason reason, @Nullable CrossComException cause) {

  /** The kinds of events. */
  public enum ConnectionChange {
    /** The client has connected for the first time. */
    CONNECTED,
    /**
     * The connection broke, timed out, or carried bytes that are not the protocol. It is closed.
     */
    LOST,
    /** The client has connected again. */
    RECONNECTED,
    /** An attempt to connect in the background or again failed. */
    RECONNECT_FAILED,
    /** The client is closed. No event follows. */
    CLOSED
  }

  /** The reasons of events. */
  public enum ChangeReason {
    /** Nothing failed: the client has connected. */
    NONE,
    /** No answer came in the request time-out, or no connection in the connect time-out. */
    TIMEOUT,
    /** The server sent bytes that do not answer the request, or speaks another protocol. */
    PROTOCOL_ERROR,
    /** The server closed the connection. */
    SERVER_CLOSED,
    /**
     * The connection ended soon after connecting, without any answer: KUKAVARPROXY does so if it
     * has too many clients.
     */
    REJECTED,
    /** The network failed, or the connection was reset. */
    NETWORK_FAILED,
    /** No server listens at the address. */
    REFUSED,
    /** The host name is unknown. */
    UNKNOWN_HOST,
    /** The thread that used the connection, or waited for it, was interrupted. */
    INTERRUPTED,
    /** The program has called {@link CrossComClient#close}. */
    CLOSED_BY_PROGRAM,
    /** The program has closed the {@link ClientRuntime}. */
    RUNTIME_CLOSED,
    /** The program has dropped the client without closing it. */
    DROPPED;

    /** Returns the reason of a lost connection or of a failed attempt to connect. */
    static ChangeReason of(CrossComException failure) {
      Throwable cause = failure.getCause();
      Throwable root = cause == null ? null : cause.getCause();
      if (failure instanceof CrossComTimeoutException || cause instanceof SocketTimeoutException) {
        return TIMEOUT;
      } else if (failure instanceof CrossComProtocolException) {
        return PROTOCOL_ERROR;
      } else if (cause instanceof EOFException) {
        return SERVER_CLOSED;
      } else if (cause instanceof ConnectException) {
        return REFUSED;
      } else if (cause instanceof UnknownHostException) {
        return UNKNOWN_HOST;
      } else if (cause instanceof ClosedByInterruptException
          || root instanceof InterruptedException) {
        return INTERRUPTED;
      }
      return root instanceof RejectedExecutionException ? RUNTIME_CLOSED : NETWORK_FAILED;
    }
  }
}
