package no.hials.crosscom.mock;

import java.time.Duration;
import no.hials.crosscom.mock.internal.Checks;
import no.hials.crosscom.mock.internal.DurationParser;

/**
 * How long the controller takes for a request.
 *
 * <p>The time is spent while the request has its turn, so that five clients that ask without a
 * pause wait five times as long each, as measured (docs/reference/access-times.md#50000-accesses);
 * see {@link MockServerConfig#oneAtATime}. Only what the controller is asked for takes it: not
 * {@code PING}, not what is no request, and not a request that a {@link Fault} keeps from being
 * executed. Assumed: one time a request, however many elements an array has (the papers found it
 * the same for short and long values).
 *
 * <p>The times of a seed are always the same, in the order in which requests are served.
 */
public sealed interface Latency {

  /**
   * Takes no time, the default.
   *
   * @return no latency
   */
  static Latency none() {
    return new None();
  }

  /**
   * Takes the same time for each request.
   *
   * @param time zero to an hour
   * @return the latency
   */
  static Latency fixed(Duration time) {
    return new Fixed(time);
  }

  /**
   * Takes the time that was measured at a KR C4 with one client: at least 1.7 ms, median 2.2 ms,
   * mean 2.5 ms, at most 24 ms (docs/reference/access-times.md#50000-accesses).
   *
   * @param seed the same seed gives the same times
   * @return the latency
   */
  static Latency krc4(long seed) {
    return new LogNormal(micros(1700), micros(2200), micros(2500), micros(24_000), seed);
  }

  /**
   * Takes the time that the papers of 2014 and 2015 give for a KR C4: 5 ms in the mean
   * (docs/reference/access-times.md#papers). Assumed, since they give no more: the shape of {@link
   * #krc4} at twice its size, so at least 3.4 ms and median 4.4 ms; at most 16 ms, where their
   * figure ends.
   *
   * @param seed the same seed gives the same times
   * @return the latency
   */
  static Latency krc4In2014(long seed) {
    return new LogNormal(micros(3400), micros(4400), micros(5000), micros(16_000), seed);
  }

  /**
   * Reads the text form that the command line and {@code @KukaController} use.
   *
   * @param text {@code none}, a time such as {@code 5ms}, {@code 1.5ms}, {@code 200us} or {@code
   *     1s}, {@code krc4} for {@link #krc4}, {@code krc4-2014} for {@link #krc4In2014}
   * @param seed the seed of the last two
   * @return the latency
   * @throws IllegalArgumentException if the text is none of these
   */
  static Latency parse(String text, long seed) {
    return switch (text) {
      case "none" -> none();
      case "krc4" -> krc4(seed);
      case "krc4-2014" -> krc4In2014(seed);
      default ->
          fixed(
              DurationParser.parse(text)
                  .orElseThrow(
                      () ->
                          new IllegalArgumentException(
                              "latency must be none, krc4, krc4-2014 or a time such as 5ms, is '"
                                  + text
                                  + "'")));
    };
  }

  private static Duration micros(long micros) {
    return Duration.ofNanos(micros * 1000);
  }

  /** No time. */
  record None() implements Latency {}

  /**
   * Always the same time.
   *
   * @param time zero to an hour
   */
  record Fixed(Duration time) implements Latency {
    /** Checks the range. */
    public Fixed {
      Checks.upToAnHour("time", time);
    }
  }

  /**
   * Times above a floor by a log-normal distribution: most are near the median, few are long.
   *
   * @param floor what no request goes below
   * @param median what half of the requests go below; more than the floor
   * @param mean the mean without the maximum; not below the median
   * @param max what is cut down to this; not below the mean, and at most an hour
   * @param seed the same seed gives the same times
   */
  record LogNormal(Duration floor, Duration median, Duration mean, Duration max, long seed)
      implements Latency {
    /** Checks the order. */
    public LogNormal {
      Checks.notNegative("floor", floor);
      Checks.upToAnHour("max", max);
      if (median.compareTo(floor) <= 0 || mean.compareTo(median) < 0 || max.compareTo(mean) < 0) {
        throw new IllegalArgumentException(
            "must be floor < median <= mean <= max, are "
                + floor
                + ", "
                + median
                + ", "
                + mean
                + ", "
                + max);
      }
    }
  }
}
