package no.hials.crosscom.gateway.internal.broker;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/**
 * The messages that the broker has not confirmed, in the order of sending. Their number and their
 * bytes are limited, but a single message may be larger. Not thread-safe.
 */
final class InFlight {
  /** The maximum number of messages. */
  private static final int MOST = 1000;

  private final Deque<Outgoing> messages = new ArrayDeque<>();
  private final SendWindow window = new SendWindow();

  /** The bytes of the messages that are not done. */
  private long bytes;

  boolean isEmpty() {
    return messages.isEmpty();
  }

  /**
   * Returns whether another message can be sent.
   *
   * @param now the time in nanoseconds
   */
  boolean hasRoom(long now) {
    Outgoing oldest = messages.peek();
    boolean waits = oldest != null && !oldest.done && window.isLate(oldest.sentAt, now);
    return !waits && messages.size() < MOST && bytes < window.size();
  }

  /**
   * Returns whether another message can be sent, and less than half of the room is in use.
   *
   * @param now the time in nanoseconds
   */
  boolean isHalfEmpty(long now) {
    return hasRoom(now) && messages.size() < MOST / 2 && bytes < window.size() / 2;
  }

  /** Adds a message that is sent now. */
  void add(Outgoing message) {
    messages.add(message);
    bytes += message.bytes;
    message.waiting = bytes;
  }

  /**
   * Marks a message as done.
   *
   * @param now the time in nanoseconds
   */
  void done(Outgoing message, long now) {
    message.done = true;
    bytes -= message.bytes;
    window.confirmed(message.sentAt, message.waiting, now);
  }

  /** Removes and returns the oldest message if it is done, or returns null. */
  @Nullable Outgoing pollDone() {
    Outgoing first = messages.peek();
    return first != null && first.done ? messages.poll() : null;
  }

  /** Removes and returns the oldest message of a lost connection, or returns null at the end. */
  @Nullable Outgoing pollLost() {
    window.reset();
    bytes = 0;
    return messages.poll();
  }
}
