package no.hials.crosscom;

import java.time.Duration;
import java.util.Arrays;
import java.util.Locale;

/**
 * The exchanges of a client since it was created, at one time. For a metrics library, register
 * functions that read {@link CrossComClient#statistics}.
 *
 * <p>The numbers are read one after the other while exchanges go on, so they may not match: a count
 * can be one ahead of another.
 */
public final class ClientStatistics {
  private final long accesses;
  private final long refusals;
  private final long timeouts;
  private final long losses;
  private final long reconnects;
  private final Histogram queueTimes;
  private final Histogram accessTimes;

  ClientStatistics(
      long accesses,
      long refusals,
      long timeouts,
      long losses,
      long reconnects,
      Histogram queueTimes,
      Histogram accessTimes) {
    this.accesses = accesses;
    this.refusals = refusals;
    this.timeouts = timeouts;
    this.losses = losses;
    this.reconnects = reconnects;
    this.queueTimes = queueTimes;
    this.accessTimes = accessTimes;
  }

  /**
   * Returns the number of requests that were answered, including those of the client itself, such
   * as the keep-alive and the questions for the type of the server.
   */
  public long accesses() {
    return accesses;
  }

  /** Returns how many of the answers reported failure. */
  public long refusals() {
    return refusals;
  }

  /** Returns the number of exchanges that took too long, in the queue or after sending. */
  public long timeouts() {
    return timeouts;
  }

  /** Returns the number of other exchanges without a valid answer. */
  public long losses() {
    return losses;
  }

  /** Returns how often the client has connected again. */
  public long reconnects() {
    return reconnects;
  }

  /** Returns how long the exchanges waited for those of other threads. */
  public Histogram queueTimes() {
    return queueTimes;
  }

  /** Returns the times from sending a request to having its answer. */
  public Histogram accessTimes() {
    return accessTimes;
  }

  @Override
  public String toString() {
    return "ClientStatistics[accesses="
        + accesses
        + ", refusals="
        + refusals
        + ", timeouts="
        + timeouts
        + ", losses="
        + losses
        + ", reconnects="
        + reconnects
        + ", queueTimes="
        + queueTimes
        + ", accessTimes="
        + accessTimes
        + "]";
  }

  /** The distribution of times, with a resolution of 12.5 % from 1 µs to 1 h. */
  public static final class Histogram {
    /** Shorter times are counted as this: 1.024 µs. */
    private static final int MIN_EXPONENT = 10;

    /** Longer times are counted as this: 73 minutes. */
    private static final int MAX_EXPONENT = 42;

    /** Each power of two has this many buckets, as a power of two. */
    private static final int PARTS = 3;

    static final int SIZE = (MAX_EXPONENT - MIN_EXPONENT) << PARTS;

    private final long[] counts;
    private final long count;

    Histogram(long[] counts) {
      this.counts = counts;
      this.count = Arrays.stream(counts).sum();
    }

    /** Returns the bucket of a time. */
    static int bucket(long nanos) {
      long inRange = Math.max(1L << MIN_EXPONENT, Math.min(nanos, (1L << MAX_EXPONENT) - 1));
      int exponent = 63 - Long.numberOfLeadingZeros(inRange);
      int part = (int) (inRange >>> (exponent - PARTS)) & ((1 << PARTS) - 1);
      return ((exponent - MIN_EXPONENT) << PARTS) + part;
    }

    /** Returns the upper end of a bucket, in ns. */
    private static long end(int bucket) {
      int exponent = (bucket >> PARTS) + MIN_EXPONENT;
      long parts = (1L << PARTS) + (bucket & ((1 << PARTS) - 1)) + 1;
      return parts << (exponent - PARTS);
    }

    /** Returns the number of times. */
    public long count() {
      return count;
    }

    /**
     * Returns the time that a share of the times did not exceed.
     *
     * @param percent 0 to 100; 50 for the median
     * @return the upper end of the range of the time; zero without any time
     * @throws IllegalArgumentException if the share is out of range
     */
    public Duration percentile(double percent) {
      if (!(percent >= 0 && percent <= 100)) {
        throw new IllegalArgumentException("percent must be 0 to 100, is " + percent);
      }
      long rank = (long) Math.ceil(count * percent / 100);
      long seen = 0;
      for (int i = 0; i < counts.length; i++) {
        seen += counts[i];
        if (seen >= rank && seen > 0) {
          return Duration.ofNanos(end(i));
        }
      }
      return Duration.ZERO;
    }

    /** Receives the buckets of a histogram. */
    @FunctionalInterface
    public interface BucketVisitor {
      /**
       * Called for a bucket that is not empty.
       *
       * @param upTo the upper end of its range
       * @param count the number of times in it
       */
      void bucket(Duration upTo, long count);
    }

    /** Calls a visitor for each bucket that is not empty, from short to long times. */
    public void forEach(BucketVisitor visitor) {
      for (int i = 0; i < counts.length; i++) {
        if (counts[i] > 0) {
          visitor.bucket(Duration.ofNanos(end(i)), counts[i]);
        }
      }
    }

    @Override
    public String toString() {
      return "Histogram[count=" + count + ", median=" + millis(50) + ", 99%=" + millis(99) + "]";
    }

    private String millis(double percent) {
      return String.format(Locale.ROOT, "%.3f ms", percentile(percent).toNanos() / 1e6);
    }
  }
}
