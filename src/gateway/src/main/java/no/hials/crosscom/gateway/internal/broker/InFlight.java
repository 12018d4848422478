package no.hials.crosscom.gateway.internal.broker;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/** The messages that the broker has not confirmed, in the order of sending. Not thread-safe. */
final class InFlight {
  /** The maximum number of messages. */
  private static final int MOST = 1000;

  /**
   * The maximum size of the messages that only a {@linkplain RoundTrips round trip} confirms. They
   * must not keep a slow connection busy for longer than the broker may be silent.
   */
  private static final long MOST_BYTES = 256_000;

  private final Deque<Outgoing> messages = new ArrayDeque<>();
  private long bytes;

  boolean isEmpty() {
    return messages.isEmpty();
  }

  /** Returns whether another message can be sent. */
  boolean hasRoom() {
    return messages.size() < MOST && bytes < MOST_BYTES;
  }

  /** Returns whether less than half of the room is in use. */
  boolean isHalfEmpty() {
    return messages.size() < MOST / 2 && bytes < MOST_BYTES / 2;
  }

  void add(Outgoing message) {
    messages.add(message);
    bytes += message.bytes;
  }

  /** Removes and returns the oldest message, or returns null. */
  @Nullable Outgoing poll() {
    Outgoing first = messages.poll();
    bytes -= first == null ? 0 : first.bytes;
    return first;
  }

  /** Removes and returns the oldest message if it is done, or returns null. */
  @Nullable Outgoing pollDone() {
    Outgoing first = messages.peek();
    return first != null && first.done ? poll() : null;
  }
}
