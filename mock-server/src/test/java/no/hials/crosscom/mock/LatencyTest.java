package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Arrays;
import java.util.stream.LongStream;
import no.hials.crosscom.mock.internal.LatencySampler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the distribution of the times. {@link LimitsTest} tests that they pass. */
class LatencyTest {
  private static final int DRAWN = 100_000;

  private static long[] draw(Latency latency) {
    return LongStream.generate(LatencySampler.of(latency)).limit(DRAWN).toArray();
  }

  private static void assertMillis(
      Latency latency, double floor, double median, double mean, double max) {
    long[] sorted = draw(latency);
    Arrays.sort(sorted);
    assertThat(sorted[0] / 1e6).isBetween(floor, floor + 0.05);
    assertThat(sorted[DRAWN / 2] / 1e6).isCloseTo(median, within(0.01));
    assertThat(Arrays.stream(sorted).average().orElseThrow() / 1e6).isCloseTo(mean, within(0.03));
    assertThat(sorted[DRAWN - 1] / 1e6).isEqualTo(max);
  }

  /** The figures of docs/reference/access-times.md#50000-accesses. */
  @Test
  void drawsTheFiguresMeasuredAtAKrc4() {
    assertMillis(Latency.krc4(1), 1.7, 2.2, 2.5, 24);
  }

  @Test
  void drawsTheMeanOfThePapers() {
    assertMillis(Latency.krc4In2014(1), 3.4, 4.4, 5, 16);
  }

  @Test
  void drawsTheSameTimesForTheSameSeedOnly() {
    assertThat(draw(Latency.krc4(7))).isEqualTo(draw(Latency.krc4(7)));
    assertThat(draw(Latency.krc4(7))).isNotEqualTo(draw(Latency.krc4(8)));
  }

  @Test
  void drawsTheMedianAlwaysIfItIsTheMean() {
    Duration two = Duration.ofMillis(2);
    Latency latency = new Latency.LogNormal(Duration.ZERO, two, two, two, 1);
    assertThat(draw(latency)).containsOnly(2_000_000);
  }

  @Test
  void isAlwaysTheSameIfFixedAndNothingIfThereIsNone() {
    assertThat(draw(Latency.fixed(Duration.ofMillis(5)))).containsOnly(5_000_000);
    assertThat(draw(Latency.none())).containsOnly(0);
  }

  // the text form

  @Test
  void knowsTheProfilesByTheirNames() {
    assertThat(Latency.parse("none", 1)).isEqualTo(Latency.none());
    assertThat(Latency.parse("krc4", 1)).isEqualTo(Latency.krc4(1));
    assertThat(Latency.parse("krc4-2014", 1)).isEqualTo(Latency.krc4In2014(1));
  }

  @ParameterizedTest
  @CsvSource({
    "5ms,5000000",
    "1.5ms,1500000",
    "200us,200000",
    "2s,2000000000",
    "0ms,0",
    "5,5000000",
    "5 MS,5000000",
    "1m,60000000000",
    "60min,3600000000000"
  })
  void takesATimeForAFixedOne(String text, long nanos) {
    assertThat(Latency.parse(text, 1)).isEqualTo(Latency.fixed(Duration.ofNanos(nanos)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "ms", "-1ms", "5  ms", ".5ms", "61m", "999999999s", "KRC4", "krc5", "1e3ms"})
  void saysWhatATextMustBe(String text) {
    assertThatThrownBy(() -> Latency.parse(text, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "latency must be none, krc4, krc4-2014 or a time up to an hour such as 5ms, is '"
                + text
                + "'");
  }

  // invalid arguments

  @Test
  void refusesTimesThatMakeNoSense() {
    Duration one = Duration.ofMillis(1);
    Duration two = Duration.ofMillis(2);
    Duration hours = Duration.ofHours(2);
    assertThatThrownBy(() -> Latency.fixed(Duration.ofNanos(-1))).hasMessageContaining("time");
    assertThatThrownBy(() -> Latency.fixed(hours)).hasMessageContaining("zero to an hour");
    assertThatThrownBy(() -> new Latency.LogNormal(one.negated(), one, two, two, 1))
        .hasMessageContaining("floor must not be negative");
    assertThatThrownBy(() -> new Latency.LogNormal(one, two, two, hours, 1))
        .hasMessageContaining("max must be zero to an hour");
    assertThatThrownBy(() -> new Latency.LogNormal(one, one, two, two, 1))
        .hasMessageContaining("floor < median <= mean <= max");
    assertThatThrownBy(() -> new Latency.LogNormal(Duration.ZERO, two, one, two, 1))
        .hasMessageContaining("floor < median <= mean <= max");
    assertThatThrownBy(() -> new Latency.LogNormal(Duration.ZERO, one, two, one, 1))
        .hasMessageContaining("floor < median <= mean <= max");
  }
}
