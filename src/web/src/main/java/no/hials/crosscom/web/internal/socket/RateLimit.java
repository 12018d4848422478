package no.hials.crosscom.web.internal.socket;

/** Counts the messages of one viewer: a number each second, and some more in a burst. */
final class RateLimit {
  private final double perSecond;
  private final double most;
  private double left;
  private long before = System.nanoTime();

  RateLimit(double perSecond, double most) {
    this.perSecond = perSecond;
    this.most = most;
    left = most;
  }

  /** Counts a message; returns false if it is one too many. Called by one thread at a time. */
  boolean take() {
    long now = System.nanoTime();
    left = Math.min(most, left + (now - before) / 1e9 * perSecond);
    before = now;
    if (left < 1) {
      return false;
    }
    left--;
    return true;
  }
}
