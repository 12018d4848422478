package no.hials.crosscom.lab.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import no.hials.crosscom.control.Trace;
import org.junit.jupiter.api.Test;

class MissedCyclesTest {
  private static final Duration PERIOD = Duration.ofMillis(12);
  private static final List<GarbageCollections.Pause> NONE = List.of();

  private static Trace.Cycle cycle(double time, double period, double read, double write) {
    List<Double> six = Collections.nCopies(6, 0.0);
    return new Trace.Cycle(time, period, read, write, true, six, six, six);
  }

  private static MissedCycles of(double access, List<GarbageCollections.Pause> pauses) {
    return MissedCycles.of(
        List.of(
            cycle(0, 0, 2, 2),
            cycle(0.012, 12.0, access - 2, 2),
            cycle(0.048, 36.1, 2, 2),
            cycle(0.060, 11.9, 2, 2)),
        pauses,
        PERIOD);
  }

  @Test
  void accessesThatLeaveNothingOfThePeriodCountForTheController() {
    assertThat(of(24.5, NONE)).isEqualTo(new MissedCycles(2, 0, 0, 0));
    assertThat(of(11.9, NONE)).isEqualTo(new MissedCycles(1, 0, 0, 1));
    assertThat(of(11.7, NONE)).isEqualTo(new MissedCycles(0, 0, 0, 2));
  }

  @Test
  void aCollectionOfGarbageCountsForItselfAlsoDuringAnAccess() {
    List<GarbageCollections.Pause> pause = List.of(new GarbageCollections.Pause(0.014, 0.020));

    assertThat(of(24.5, pause)).isEqualTo(new MissedCycles(0, 0, 2, 0));
    assertThat(of(4.5, pause)).isEqualTo(new MissedCycles(0, 0, 2, 0));
  }

  @Test
  void aShortCollectionDoesNotExcuseALongAccess() {
    assertThat(of(25.5, List.of(new GarbageCollections.Pause(0.014, 0.001))))
        .isEqualTo(new MissedCycles(2, 0, 0, 0));
  }

  @Test
  void aLongAccessDoesNotExcuseACollectionThatMissesMore() {
    assertThat(of(24.5, List.of(new GarbageCollections.Pause(0.014, 0.012))))
        .isEqualTo(new MissedCycles(1, 0, 1, 0));
  }

  @Test
  void aCycleThatBeginsLateIsNotMissed() {
    List<Trace.Cycle> cycles = List.of(cycle(0, 0, 2, 2), cycle(0.021, 21, 2, 0.5));

    assertThat(MissedCycles.of(cycles, NONE, PERIOD)).isEqualTo(new MissedCycles(0, 0, 0, 0));
  }

  private static MissedCycles ofOneBegunLate(double late, List<GarbageCollections.Pause> pauses) {
    List<Trace.Cycle> cycles =
        List.of(cycle(0, 0, 2, 2), cycle(0.012 + late, 12, 4, 2), cycle(0.036, 24 - late, 2, 2));
    return MissedCycles.of(cycles, pauses, PERIOD);
  }

  @Test
  void aCycleThatMissesTheNextSinceItWasWokenLateCountsForTheComputer() {
    assertThat(ofOneBegunLate(0.0059, NONE)).isEqualTo(new MissedCycles(0, 1, 0, 0));
    assertThat(ofOneBegunLate(0.0057, NONE)).isEqualTo(new MissedCycles(0, 0, 0, 1));
  }

  @Test
  void aCycleThatACollectionOfGarbageMadeLateCountsForThat() {
    assertThat(ofOneBegunLate(0.0059, List.of(new GarbageCollections.Pause(0.010, 0.007))))
        .isEqualTo(new MissedCycles(0, 0, 1, 0));
  }

  @Test
  void whatNeitherExplainsCountsForTheRest() {
    assertThat(of(4.5, NONE)).isEqualTo(new MissedCycles(0, 0, 0, 2));
    assertThat(of(4.5, List.of(new GarbageCollections.Pause(0.050, 0.020))))
        .isEqualTo(new MissedCycles(0, 0, 0, 2));
  }
}
