package no.hials.crosscom.mock.internal;

import java.time.Duration;
import java.util.Random;
import java.util.function.LongSupplier;
import no.hials.crosscom.mock.Latency;

/** Draws random times of a {@link Latency}, in nanoseconds. Not thread-safe. */
public final class LatencySampler {
  private LatencySampler() {}

  /** Returns a source of times. */
  public static LongSupplier of(Latency latency) {
    if (latency instanceof Latency.Fixed fixed) {
      long nanos = fixed.time().toNanos();
      return () -> nanos;
    }
    if (latency instanceof Latency.None) {
      return () -> 0;
    }
    return of((Latency.LogNormal) latency);
  }

  /**
   * Computes the parameters of the log-normal distribution: its median is exp(mu), its mean exp(mu
   * + sigma^2 / 2).
   */
  private static LongSupplier of(Latency.LogNormal spread) {
    double floor = spread.floor().toNanos();
    double median = above(spread.floor(), spread.median());
    double mean = above(spread.floor(), spread.mean());
    double max = spread.max().toNanos();
    double sigma = StrictMath.sqrt(2 * StrictMath.log(mean / median));
    // the algorithm of Random is specified, so the times are the same in every JDK
    Random random = new Random(spread.seed());
    return () ->
        (long) Math.min(max, floor + median * StrictMath.exp(sigma * random.nextGaussian()));
  }

  private static double above(Duration floor, Duration time) {
    return time.minus(floor).toNanos();
  }
}
