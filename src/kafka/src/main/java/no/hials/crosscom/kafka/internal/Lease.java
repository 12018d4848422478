package no.hials.crosscom.kafka.internal;

import java.time.Duration;
import no.hials.crosscom.cell.Moment;
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
    if (before == null || requested.nanos() - before.nanos() > 0) {
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
