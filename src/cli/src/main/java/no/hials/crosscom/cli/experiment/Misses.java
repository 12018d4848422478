package no.hials.crosscom.cli.experiment;

import java.time.Duration;
import java.util.List;
import no.hials.crosscom.control.Trace;

/**
 * The cycles that were left out since the one before took too long, by what took it so long.
 *
 * @param byAccess those that the accesses to the controller alone would have missed, without the
 *     pauses in them: they left less than a millisecond of the period
 * @param byCollection the others, if there was a pause for the collection of garbage
 * @param byOther neither: the law, or a computer that had other things to do
 */
record Misses(long byAccess, long byCollection, long byOther) {
  /** What a cycle may need itself, ms. */
  private static final double OWN = 1;

  static Misses of(List<Trace.Cycle> cycles, List<Pauses.Pause> pauses, Duration period) {
    double dt = period.toNanos() / 1e6;
    long byAccess = 0;
    long byCollection = 0;
    long byOther = 0;
    for (int i = 1; i < cycles.size(); i++) {
      Trace.Cycle before = cycles.get(i - 1);
      // a cycle that begins late is not a missed one
      long missed = slot(cycles.get(i), dt) - slot(before, dt) - 1;
      if (missed > 0) {
        double paused = Pauses.millisBetween(pauses, before.time(), cycles.get(i).time());
        double access = Math.max(0, before.read() + before.write() - paused);
        long expected = Math.min(missed, (long) Math.floor((access + OWN) / dt));
        byAccess += expected;
        if (paused > 0) {
          byCollection += missed - expected;
        } else {
          byOther += missed - expected;
        }
      }
    }
    return new Misses(byAccess, byCollection, byOther);
  }

  /** Gives which of all periods a cycle began in. */
  private static long slot(Trace.Cycle cycle, double dt) {
    return (long) Math.floor(cycle.time() * 1e3 / dt + 1e-6);
  }
}
