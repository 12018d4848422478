package no.hials.crosscom.lab.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class GarbageCollectionsTest {
  /** Both times are cut to whole milliseconds. */
  private static final double CUT = 0.0025;

  @Test
  @Timeout(30)
  void aPauseIsNotedAtTheTimeItWas() {
    try (GarbageCollections pauses = new GarbageCollections()) {
      pauses.begin();
      long start = System.nanoTime();
      double before = (System.nanoTime() - start) / 1e9;
      System.gc();
      double after = (System.nanoTime() - start) / 1e9;

      List<GarbageCollections.Pause> seen = pauses.seen(0);
      while (seen.isEmpty()) { // they come on a thread of the JVM's own
        LockSupport.parkNanos(1_000_000); // to spin would make garbage for one more collection
        seen = pauses.seen(0);
      }
      assertThat(seen)
          .allSatisfy(
              pause -> {
                assertThat(pause.begin()).isBetween(before - CUT, after + CUT);
                assertThat(pause.begin() + pause.length()).isBetween(before - CUT, after + CUT);
              });
      assertThat(pauses.seen(10).get(0).begin()).isEqualTo(seen.get(0).begin() + 10);
    }
  }
}
