package no.hials.crosscom.web.internal.socket;

/** Limits messages or other things to a number per second, and more in a burst. */
public final class RateLimit {
  private final double perSecond;
  private final double most;
  private double left;
  private long before = System.nanoTime();

  /**
   * Creates a limit.
   *
   * @param most the maximum number in a burst
   */
  public RateLimit(double perSecond, double most) {
    this.perSecond = perSecond;
    this.most = most;
    left = most;
  }

  /** Counts one more; returns false if the limit is exceeded. Call from one thread at a time. */
  public boolean take() {
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
