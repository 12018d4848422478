package no.hials.crosscom.gateway.internal.broker;

import java.time.Duration;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The times of a session's attempts to connect. Each attempt waits longer than the one before, also
 * if the broker connects and ends the connection soon. Logs each failure that differs from the last
 * one. Not thread-safe.
 */
final class Attempts {
  private static final Logger LOG = LoggerFactory.getLogger(Attempts.class);
  private static final long FIRST_DELAY = Duration.ofMillis(100).toNanos();
  private static final long LAST_DELAY = Duration.ofSeconds(5).toNanos();

  /** After a connection that lasted so long, the next attempts begin with the first delay. */
  private static final long GOOD = Duration.ofSeconds(2).toNanos();

  private final String session;
  private final String url;
  private long next = System.nanoTime();
  private long delay = FIRST_DELAY;
  private long connectedAt;
  private String lastFailure = "";

  /**
   * Creates the times; the first attempt is due.
   *
   * @param session the name of the session
   * @param url the address of the broker
   */
  Attempts(String session, String url) {
    this.session = session;
    this.url = url;
  }

  /** Returns whether it is time for the next attempt. */
  boolean isDue(long now) {
    return now - next >= 0;
  }

  /** Called when an attempt has succeeded. */
  void connected() {
    connectedAt = System.nanoTime();
    if (!lastFailure.isEmpty()) {
      delay = FIRST_DELAY; // it has waited for the broker, not because connections end soon
    }
    lastFailure = "";
  }

  /**
   * Called when a connection is lost.
   *
   * @param again whether to connect again soon, since the next connection will be better
   */
  void lost(boolean again) {
    if (again || System.nanoTime() - connectedAt > GOOD) {
      delay = FIRST_DELAY;
    }
    postpone();
  }

  /** Called when an attempt has failed. */
  void failed(String reason) {
    if (!reason.equals(lastFailure)) {
      LOG.warn("MQTT {}: cannot connect to {}: {}", session, url, reason);
    }
    lastFailure = reason;
    postpone();
  }

  private void postpone() {
    next = System.nanoTime() + delay;
    delay = Math.min(2 * delay, LAST_DELAY);
  }
}
