package no.hials.crosscom;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * Something that happened to a client's connection.
 *
 * @param kind what happened
 * @param time when it happened
 * @param cause why the connection was lost, or connecting failed; null otherwise
 */
public record ConnectionEvent(
    ConnectionChange kind, Instant time, @Nullable CrossComException cause) {

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
    /** The program has closed the client. */
    CLOSED
  }
}
