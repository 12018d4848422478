package no.hials.crosscom.gateway.internal.broker;

import java.util.concurrent.TimeUnit;

/**
 * The number of bytes that may wait for the broker at a time, adapted to the speed of a connection.
 * What is on its way cannot be called back, and keep-alives wait for it: so it is as little as
 * keeps the connection busy. Not thread-safe.
 */
final class SendWindow {
  static final int FIRST = 16_000;
  static final int SMALLEST = 4_000;
  static final int LARGEST = 1_024_000;

  /** The delay of a message that is sought, on top of two round trips. */
  private static final long SPARE = TimeUnit.MILLISECONDS.toNanos(50);

  /** A delay that is longer than two round trips by more means: the connection has become slow. */
  private static final long LATE = TimeUnit.SECONDS.toNanos(1);

  /** A longer delay of a message that was sent alone comes from its size. */
  private static final long LONGEST_TRIP = TimeUnit.MILLISECONDS.toNanos(1500);

  private int size;

  /** The shortest delay since a message was sent alone. */
  private long trip;

  /** Whether the window was made smaller on this connection. */
  private boolean shrunk;

  /** When the window was last made smaller. */
  private long shrunkAt;

  SendWindow() {
    reset();
  }

  /** Returns the size in bytes. */
  int size() {
    return size;
  }

  /** Begins again, for another connection. */
  void reset() {
    size = FIRST;
    trip = LONGEST_TRIP;
    shrunk = false;
  }

  /**
   * Called when a message is confirmed. Its delay and the bytes that waited with it show the speed
   * of the connection. Messages from before the window was made smaller do not make it smaller
   * again.
   *
   * @param now the time in nanoseconds
   */
  void confirmed(Outgoing message, long now) {
    long delay = Math.max(1, now - message.sentAt);
    trip = Math.min(message.isAlone() ? LONGEST_TRIP : trip, delay);
    long fitting = Math.min(LARGEST, message.waiting * (2 * trip + SPARE) / delay);
    if (!isLate(message, now)) {
      size = (int) Math.max(size, Math.min(2 * message.waiting, fitting));
    } else if (!shrunk || message.sentAt - shrunkAt >= 0) {
      size = (int) Math.max(SMALLEST, Math.min(size, fitting));
      shrunk = true;
      shrunkAt = now;
    }
  }

  /**
   * Returns whether a message has waited for much longer than two round trips: one for the question
   * of a message before it, one for its own.
   */
  boolean isLate(Outgoing message, long now) {
    return now - message.sentAt > 2 * trip + LATE;
  }
}
