package no.hials.crosscom.gateway.internal.broker;

import java.time.Duration;

/**
 * The times of a session's attempts to connect. Each attempt waits longer than the one before, also
 * if the broker connects and ends the connection at once. Not thread-safe.
 */
final class Attempts {
  private static final long FIRST_DELAY = Duration.ofMillis(100).toNanos();
  private static final long LAST_DELAY = Duration.ofSeconds(5).toNanos();

  private long next = System.nanoTime();
  private long delay = FIRST_DELAY;
  private long connectedAt;

  /** Returns whether it is time for the next attempt. */
  boolean isDue(long now) {
    return now - next >= 0;
  }

  /** Called when an attempt has succeeded. */
  void connected() {
    connectedAt = System.nanoTime();
  }

  /** Called when a connection is lost. */
  void lost() {
    if (System.nanoTime() - connectedAt > LAST_DELAY) {
      delay = FIRST_DELAY;
    }
    failed();
  }

  /** Called when an attempt has failed. */
  void failed() {
    next = System.nanoTime() + delay;
    delay = Math.min(2 * delay, LAST_DELAY);
  }
}
