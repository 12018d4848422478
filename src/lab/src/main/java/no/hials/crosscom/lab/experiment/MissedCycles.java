package no.hials.crosscom.lab.experiment;

import java.time.Duration;
import java.util.List;
import no.hials.crosscom.control.Trace;

/**
 * Counts the cycles missed because the previous cycle took too long, by cause. Each cycle counts
 * under the first cause that fits.
 *
 * @param byAccess the accesses to the controller, without the pauses in them, left less than 0.2 ms
 *     of the period
 * @param byWaking the accesses and a late wake-up of the loop by the computer, without the pauses,
 *     left less than 0.2 ms of the period
 * @param byCollection a garbage collection pause
 * @param byOther any other cause: the law, the loop, or a busy computer
 */
record MissedCycles(long byAccess, long byWaking, long byCollection, long byOther) {
  /** The time that a cycle itself may need, ms. */
  private static final double OWN = 0.2;

  static MissedCycles of(
      List<Trace.Cycle> cycles, List<GarbageCollections.Pause> pauses, Duration period) {
    double dt = period.toNanos() / 1e6;
    MissedCycles sum = new MissedCycles(0, 0, 0, 0);
    for (int i = 1; i < cycles.size(); i++) {
      Trace.Cycle before = cycles.get(i - 1);
      // a cycle that begins late is not missed
      long missed = slot(cycles.get(i), dt) - slot(before, dt) - 1;
      if (missed > 0) {
        sum = sum.plus(between(before, cycles.get(i), missed, pauses, dt));
      }
    }
    return sum;
  }

  private static MissedCycles between(
      Trace.Cycle before,
      Trace.Cycle next,
      long missed,
      List<GarbageCollections.Pause> pauses,
      double dt) {
    double due = slot(before, dt) * dt / 1e3;
    double pausedBefore = GarbageCollections.millisBetween(pauses, due, before.time());
    double pausedIn = GarbageCollections.millisBetween(pauses, before.time(), next.time());
    double access = Math.max(0, before.read() + before.write() - pausedIn);
    double late = Math.max(0, (before.time() - due) * 1e3 - pausedBefore);
    long byAccess = Math.min(missed, (long) Math.floor((access + OWN) / dt));
    long byBoth = Math.min(missed, (long) Math.floor((late + access + OWN) / dt));
    long rest = missed - byBoth;
    return pausedBefore + pausedIn > 0
        ? new MissedCycles(byAccess, byBoth - byAccess, rest, 0)
        : new MissedCycles(byAccess, byBoth - byAccess, 0, rest);
  }

  private MissedCycles plus(MissedCycles other) {
    return new MissedCycles(
        byAccess + other.byAccess,
        byWaking + other.byWaking,
        byCollection + other.byCollection,
        byOther + other.byOther);
  }

  /** Returns the number of the period in which a cycle began. */
  private static long slot(Trace.Cycle cycle, double dt) {
    return (long) Math.floor(cycle.time() * 1e3 / dt + 1e-6);
  }
}
