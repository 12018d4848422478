package no.hials.crosscom;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicLongArray;
import no.hials.crosscom.ClientStatistics.Histogram;

/** Counts the exchanges of a client. Several threads may read it; only the turn's owner counts. */
final class ExchangeMeter {
  private final AtomicLong accesses = new AtomicLong();
  private final AtomicLong refusals = new AtomicLong();
  private final AtomicLong timeouts = new AtomicLong();
  private final AtomicLong losses = new AtomicLong();
  private final AtomicLong reconnects = new AtomicLong();
  private final AtomicLongArray queueTimes = new AtomicLongArray(Histogram.SIZE);
  private final AtomicLongArray accessTimes = new AtomicLongArray(Histogram.SIZE);

  void answered(long queueNanos, long accessNanos, boolean success) {
    add(accesses);
    if (!success) {
      add(refusals);
    }
    add(queueTimes, queueNanos);
    add(accessTimes, accessNanos);
  }

  void failed(CrossComException e) {
    if (e instanceof CrossComTimeoutException) {
      timeouts.incrementAndGet();
    } else {
      add(losses);
    }
  }

  /** Counts a wait for the turn that took too long; any thread may call it. */
  void timedOutInQueue() {
    timeouts.incrementAndGet();
  }

  void reconnected() {
    add(reconnects);
  }

  /** Adds without a locked instruction, which only one thread at a time may do. */
  private static void add(AtomicLong counter) {
    counter.lazySet(counter.getPlain() + 1);
  }

  private static void add(AtomicLongArray histogram, long nanos) {
    int bucket = Histogram.bucket(nanos);
    histogram.lazySet(bucket, histogram.getPlain(bucket) + 1);
  }

  ClientStatistics snapshot() {
    return new ClientStatistics(
        accesses.get(),
        refusals.get(),
        timeouts.get(),
        losses.get(),
        reconnects.get(),
        copy(queueTimes),
        copy(accessTimes));
  }

  private static Histogram copy(AtomicLongArray counts) {
    long[] copy = new long[counts.length()];
    for (int i = 0; i < copy.length; i++) {
      copy[i] = counts.get(i);
    }
    return new Histogram(copy);
  }
}
