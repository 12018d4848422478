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

  /** A delay that is longer than the shortest one by less means: more can be on the way. */
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

  /** Whether at least half of the window was in use since it was changed. */
  private boolean used;

  /** Whether the window was changed on this connection. */
  private boolean changed;

  /** The time of the last change. */
  private long changedAt;

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
    used = false;
    changed = false;
  }

  /**
   * Called when a message is sent.
   *
   * @param bytes the bytes that now wait for the broker
   */
  void sent(long bytes) {
    used |= bytes >= size / 2;
  }

  /**
   * Called when a message is confirmed. Messages from before the last change do not count: their
   * delay is that of another window.
   *
   * @param sentAt when it was sent, in nanoseconds
   * @param now the time in nanoseconds
   */
  void confirmed(long sentAt, long now) {
    long delay = now - sentAt;
    measure(delay, now);
    if (changed && sentAt - changedAt < 0) {
      return;
    }
    if (delay > trips() + SLOW) {
      resize(Math.max(SMALLEST, size / 2), now);
    } else if (delay < trips() + QUICK && used) {
      resize(Math.min(LARGEST, size * 2), now);
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

  private void resize(int bytes, long now) {
    size = bytes;
    used = false;
    changed = true;
    changedAt = now;
  }
}
