package no.hials.crosscom.kafka.internal;

import java.time.Duration;
import org.jspecify.annotations.Nullable;

/**
 * The right to use robots, which expires. Answers of the broker renew it. It counts from the time
 * when the requests were made, so that neither a late answer nor a frozen process extends it.
 * Thread-safe.
 */
public final class Lease {
  private final long length;
  private volatile @Nullable Moment renewed;
  private volatile boolean ended;

  /**
   * A time on both clocks of the machine. The monotonic one stands still while a virtual machine is
   * suspended, and the other one can be set.
   */
  public record Moment(long nanos, long millis) {
    /** Returns the time now. */
    public static Moment now() {
      return new Moment(System.nanoTime(), System.currentTimeMillis());
    }

    /** Returns the time since an earlier moment, by the clock that has moved further. */
    public long nanosSince(Moment before) {
      return Math.max(nanos - before.nanos, (millis - before.millis) * 1_000_000);
    }
  }

  /** Creates a lease that is not held yet. */
  public Lease(Duration length) {
    this.length = length.toNanos();
  }

  /**
   * Renews the lease.
   *
   * @param requested the time of the request that the broker answered
   */
  public synchronized void renew(Moment requested) {
    Moment before = renewed;
    if (before == null || requested.nanos - before.nanos > 0) {
      renewed = requested;
    }
  }

  /** Returns whether robots may be used now. */
  public boolean isHeld() {
    Moment last = renewed;
    return !ended && last != null && Moment.now().nanosSince(last) < length;
  }

  /** Ends the lease for good. */
  public void end() {
    ended = true;
  }
}
