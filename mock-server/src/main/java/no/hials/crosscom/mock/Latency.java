package no.hials.crosscom.mock;

import java.time.Duration;
import no.hials.crosscom.mock.internal.Checks;
import no.hials.crosscom.mock.internal.DurationParser;

/**
 * The time that the controller takes for a request.
 *
 * <p>The request keeps its turn for this time: five clients without pauses each wait five times as
 * long, as measured (docs/reference/access-times.md#50000-accesses); see {@link
 * MockServerConfig#oneAtATime}. {@code PING}, bytes that are not a request, and requests that a
 * {@link Fault} does not execute take no time. Assumed: the time does not depend on the length of
 * the value, as in the papers.
 *
 * <p>The same seed always gives the same times, in the order in which requests are served.
 */
public sealed interface Latency {

  /** Returns no latency, the default. */
  static Latency none() {
    return new None();
  }

  /** Returns the same latency for each request, zero to an hour. */
  static Latency fixed(Duration time) {
    return new Fixed(time);
  }

  /**
   * Returns the latency measured at a KR C4 with one client: at least 1.7 ms, median 2.2 ms, mean
   * 2.5 ms, at most 24 ms (docs/reference/access-times.md#50000-accesses).
   *
   * @param seed the same seed gives the same times
   */
  static Latency krc4(long seed) {
    return new LogNormal(micros(1700), micros(2200), micros(2500), micros(24_000), seed);
  }

  /**
   * Returns the latency of a KR C4 in the papers of 2014 and 2015: mean 5 ms
   * (docs/reference/access-times.md#papers). The papers contain no other figures; the distribution
   * of {@link #krc4} with doubled times is assumed: at least 3.4 ms, median 4.4 ms. The maximum is
   * 16 ms, where their figure ends.
   *
   * @param seed the same seed gives the same times
   */
  static Latency krc4In2014(long seed) {
    return new LogNormal(micros(3400), micros(4400), micros(5000), micros(16_000), seed);
  }

  /**
   * Parses the text form that the command line and {@code @KukaController} use.
   *
   * @param text {@code none}, a time up to an hour such as {@code 5ms}, {@code 1.5ms}, {@code
   *     200us}, {@code 1s}, {@code 1m} or {@code 5}, in ms without a unit, {@code krc4} for {@link
   *     #krc4}, {@code krc4-2014} for {@link #krc4In2014}
   * @param seed the seed of the last two
   * @throws IllegalArgumentException if the text is not one of these
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
                              "latency must be none, krc4, krc4-2014 or a time up to an hour such as 5ms, is '"
                                  + text
                                  + "'")));
    };
  }

  private static Duration micros(long micros) {
    return Duration.ofNanos(micros * 1000);
  }

  /** See {@link Latency#none}. */
  record None() implements Latency {}

  /**
   * See {@link Latency#fixed}.
   *
   * @param time zero to an hour
   */
  record Fixed(Duration time) implements Latency {
    public Fixed {
      Checks.upToAnHour("time", time);
    }
  }

  /**
   * A floor plus a log-normal distribution: most times are near the median, few are long.
   *
   * @param floor the shortest time
   * @param median the median; more than the floor
   * @param mean the mean of the distribution before the maximum is applied; at least the median
   * @param max the longest time, at most an hour; longer times are cut to it; at least the mean
   * @param seed the same seed gives the same times
   */
  record LogNormal(Duration floor, Duration median, Duration mean, Duration max, long seed)
      implements Latency {
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
