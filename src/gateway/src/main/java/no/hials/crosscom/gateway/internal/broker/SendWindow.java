package no.hials.crosscom.gateway.internal.broker;

import java.util.concurrent.TimeUnit;

/**
 * The number of bytes that may wait for the broker at a time, adapted to the speed of a connection.
 * Keep-alives wait behind these bytes, so a slow connection with too many of them looks lost. Not
 * thread-safe.
 */
final class SendWindow {
  static final int FIRST = 16_000;
  static final int SMALLEST = 4_000;
  static final int LARGEST = 1_024_000;

  /** The delay that is sought; it comes on top of the shortest one. */
  private static final long QUICK = TimeUnit.SECONDS.toNanos(1);

  /** A delay that is longer than the shortest one by more means: too much is on the way. */
  private static final long SLOW = TimeUnit.SECONDS.toNanos(2);

  /** The maximum round trip; a longer delay comes from what is on the way. */
  private static final long LONGEST_TRIP = TimeUnit.MILLISECONDS.toNanos(1200);

  /** The shortest delay is that of the last one to two intervals, since a route can change. */
  private static final long INTERVAL = TimeUnit.SECONDS.toNanos(10);

  private int size = FIRST;
  private long shortest = LONGEST_TRIP;
  private long shortestBefore = LONGEST_TRIP;
  private boolean measured;
  private long intervalStart;

  /** Whether the window was made smaller on this connection. */
  private boolean shrunk;

  /** When the window was last made smaller. */
  private long shrunkAt;

  /** Returns the size in bytes. */
  int size() {
    return size;
  }

  /** Begins again, for another connection. */
  void reset() {
    size = FIRST;
    shortest = LONGEST_TRIP;
    shortestBefore = LONGEST_TRIP;
    measured = false;
    shrunk = false;
  }

  /**
   * Called when a message is confirmed. The bytes that waited with it show how many can be on the
   * way. Messages from before the window was made smaller do not make it smaller again.
   *
   * @param sentAt when it was sent, in nanoseconds
   * @param waiting the bytes that then waited for the broker, with its own
   * @param now the time in nanoseconds
   */
  void confirmed(long sentAt, long waiting, long now) {
    long delay = Math.max(1, now - sentAt);
    measure(delay, now);
    if (delay > trips() + SLOW) {
      if (!shrunk || sentAt - shrunkAt >= 0) {
        size = Math.max(SMALLEST, size / 2);
        shrunk = true;
        shrunkAt = now;
      }
    } else {
      long quick = waiting * (trips() + QUICK) / delay;
      size = (int) Math.max(size, Math.min(LARGEST, Math.min(2 * waiting, quick)));
    }
  }

  /** Returns whether a message has waited for longer than it does while more can be sent. */
  boolean isLate(long sentAt, long now) {
    return now - sentAt > trips() + QUICK;
  }

  /** Returns two round trips: a message can wait for another question before its own. */
  private long trips() {
    return 2 * Math.min(shortest, shortestBefore);
  }

  private void measure(long delay, long now) {
    if (!measured || now - intervalStart > INTERVAL) {
      shortestBefore = shortest;
      shortest = LONGEST_TRIP;
      intervalStart = now;
      measured = true;
    }
    shortest = Math.min(shortest, delay);
  }
}
