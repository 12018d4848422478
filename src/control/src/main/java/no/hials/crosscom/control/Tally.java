package no.hials.crosscom.control;

/** A histogram of times that creates no objects. Used under the lock of its owner. */
final class Tally {
  private static final long BUCKET_NANOS = 10_000;
  private static final int BUCKETS = 20_000;

  private final int[] buckets = new int[BUCKETS];
  private long count;
  private long sum;
  private long minimum = Long.MAX_VALUE;
  private long maximum;

  void add(long nanos) {
    count++;
    sum += nanos;
    minimum = Math.min(minimum, nanos);
    maximum = Math.max(maximum, nanos);
    buckets[(int) Math.min(BUCKETS - 1, nanos / BUCKET_NANOS)]++;
  }

  LoopStatistics.Times times() {
    return count == 0
        ? new LoopStatistics.Times(0, 0, 0, 0, 0, 0)
        : new LoopStatistics.Times(
            count, millis(minimum), sum / 1e6 / count, part(0.5), part(0.99), millis(maximum));
  }

  /** Returns a quantile of the times, to 10 µs. */
  private double part(double part) {
    long wanted = (long) Math.ceil(part * count);
    long seen = 0;
    for (int i = 0; i < BUCKETS - 1; i++) {
      seen += buckets[i];
      if (seen >= wanted) {
        return millis(Math.min(maximum, (i + 1) * BUCKET_NANOS));
      }
    }
    return millis(maximum); // beyond the buckets
  }

  private static double millis(long nanos) {
    return nanos / 1e6;
  }
}
