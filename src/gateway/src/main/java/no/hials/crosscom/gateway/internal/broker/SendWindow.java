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

  /** After a delay that is longer than three round trips by more, nothing is sent for now. */
  private static final long LATE = TimeUnit.MILLISECONDS.toNanos(250);

  /** A delay that is longer than three round trips by more: the connection has become slow. */
  private static final long SLOW = TimeUnit.SECONDS.toNanos(1);

  /** If delays are longer than is sought, the round trip is measured again after this time. */
  private static final long INTERVAL = TimeUnit.SECONDS.toNanos(5);

  /** A longer delay of a message that was sent alone comes from its size. */
  private static final long LONGEST_TRIP = TimeUnit.MILLISECONDS.toNanos(1500);

  private int size;

  /** The shortest delay since a message was sent alone. */
  private long trip;

  /** When the last message that was sent alone was confirmed. */
  private long measuredAt;

  /** Whether the round trip may have become longer. */
  private boolean outdated;

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
    outdated = false;
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
    if (message.isAlone()) {
      trip = LONGEST_TRIP;
      measuredAt = now;
    }
    trip = Math.min(trip, delay);
    outdated = delay > 2 * trip + SPARE && now - measuredAt > INTERVAL;
    long fitting = Math.min(LARGEST, message.waiting * (2 * trip + SPARE) / delay);
    if (delay <= 3 * trip + SLOW) {
      size = (int) Math.max(size, Math.min(2 * message.waiting, fitting));
    } else if (!shrunk || message.sentAt - shrunkAt >= 0) {
      size = (int) Math.max(SMALLEST, Math.min(size, fitting));
      shrunk = true;
      shrunkAt = now;
    }
  }

  /** Called when no message waits for the broker any more: the next one is sent alone. */
  void drained() {
    outdated = false;
  }

  /**
   * Returns whether all messages must be confirmed before another one is sent: the oldest has
   * waited for longer than the last one of a full window does, which is two round trips of others
   * and its own, or the round trip must be measured with a message that is sent alone.
   *
   * @param oldest the oldest message that is not confirmed
   */
  boolean mustDrain(Outgoing oldest, long now) {
    return outdated || now - oldest.sentAt > 3 * trip + LATE;
  }
}
