package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** The readings that were left out, for two periods. */
class MissedReadingsTest {
  private static final Duration FAST = Duration.ofMillis(100);
  private static final Duration SLOW = Duration.ofSeconds(1);

  private final MissedReadings readings = new MissedReadings(Set.of(FAST, SLOW));

  private static Instant at(long millis) {
    return Instant.ofEpochMilli(1_000_000 + millis);
  }

  private long read(Duration period, long millis, long missed) {
    return readings.read(period, at(millis), missed, false);
  }

  @Test
  void whileTheRobotIsUsedTheNumberOfTheReadingCounts() {
    assertThat(read(FAST, 0, 0)).isZero();
    assertThat(read(FAST, 500, 3)).isEqualTo(3);
    assertThat(readings.stored()).isEqualTo(Map.of("read.100", 1_000_500L));
  }

  @Test
  void afterAStartEachPeriodCountsFromItsOwnLastReading() {
    Map<String, Object> offset =
        Map.of("read.100", 1_000_000L, "read.1000", 1_000_950L, "sequence", 7L);
    readings.restore(offset, at(-5000));
    readings.resume(at(1000));

    assertThat(read(FAST, 1010, 0)).isEqualTo(10);
    assertThat(read(SLOW, 1020, 0)).isZero();
  }

  @Test
  void aPeriodThatIsNewHasMissedNothing() {
    readings.restore(Map.of("read.1000", 1_000_000L), at(-5000));
    readings.resume(at(0));

    assertThat(read(FAST, 10, 0)).isZero();
  }

  @Test
  void allPeriodsOfAnOffsetWithoutThemCountFromTheGivenTime() {
    readings.restore(Map.of("sequence", 7L), at(-5000));
    readings.resume(at(0));

    assertThat(read(FAST, 10, 0)).isEqualTo(50);
    assertThat(read(SLOW, 10, 0)).isEqualTo(5);
  }

  @Test
  void aReadingThatIsDueNowIsNotLeftOut() {
    readings.restore(Map.of(), at(0));
    readings.resume(at(300));

    assertThat(read(FAST, 300, 0)).isEqualTo(2);
  }

  @Test
  void readingsWithoutTheLeaseAreCountedByTheTime() {
    assertThat(read(FAST, 0, 0)).isZero();
    readings.unused(FAST, at(100));
    readings.unused(FAST, at(200));
    readings.resume(at(500));

    assertThat(readings.isUnread(FAST)).isTrue();
    assertThat(read(FAST, 510, 12)).isEqualTo(5);
    assertThat(read(FAST, 610, 0)).isZero();
  }

  @Test
  void readingsThatFailBeforeTheRobotCanBeConnectedAreLeftOut() {
    readings.restore(Map.of(), at(0));
    readings.resume(at(1000));

    assertThat(readings.read(FAST, at(1050), 0, true)).isZero();
    assertThat(readings.read(FAST, at(1150), 0, true)).isZero();
    assertThat(read(FAST, 1250, 0)).isEqualTo(12);
  }

  @Test
  void aRobotThatIsOffIsTried() {
    readings.restore(Map.of(), at(0));
    readings.resume(at(1000));

    assertThat(readings.read(FAST, at(3050), 0, true)).isEqualTo(29);
    assertThat(readings.read(FAST, at(3150), 0, true)).isZero();
  }

  @Test
  void aClockThatWasSetBackCountsNothing() {
    readings.restore(Map.of(), at(3_600_000));
    readings.resume(at(0));

    assertThat(read(FAST, 10, 0)).isZero();
    assertThat(readings.last(FAST)).isEqualTo(at(10));
  }
}
