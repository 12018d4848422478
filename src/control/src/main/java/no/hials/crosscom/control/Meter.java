package no.hials.crosscom.control;

import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.control.LoopStatistics.TrackingError;
import no.hials.crosscom.control.Space.Quantity;

/** Collects the statistics of a loop. Thread-safe. */
final class Meter {
  private final List<Quantity> quantities;
  private final double[] squares;
  private final double[] largest;
  private final Tally period = new Tally();
  private final Tally late = new Tally();
  private final Tally read = new Tally();
  private final Tally write = new Tally();
  private final Tally own = new Tally();
  private long cycles;
  private long holding;
  private long missed;
  private long missedByAccess;
  private long saturated;
  private long errors;

  Meter(List<Quantity> quantities) {
    this.quantities = quantities;
    this.squares = new double[quantities.size()];
    this.largest = new double[quantities.size()];
  }

  synchronized void began(long sinceLast, long lateNanos) {
    cycles++;
    late.add(lateNanos);
    if (sinceLast > 0) {
      period.add(sinceLast);
    }
  }

  synchronized void accessed(long readNanos, long writeNanos, long ownNanos) {
    read.add(readNanos);
    write.add(writeNanos);
    own.add(ownNanos);
  }

  synchronized void missed(long count, boolean byAccess) {
    missed += count;
    if (byAccess) {
      missedByAccess += count;
    }
  }

  synchronized void held() {
    holding++;
  }

  synchronized void cut() {
    saturated++;
  }

  synchronized void error(double[] differences) {
    errors++;
    for (int i = 0; i < differences.length; i++) {
      squares[i] += differences[i] * differences[i];
      largest[i] = Math.max(largest[i], differences[i]);
    }
  }

  synchronized LoopStatistics statistics() {
    List<TrackingError> trackingErrors = new ArrayList<>();
    for (int i = 0; i < quantities.size(); i++) {
      Quantity quantity = quantities.get(i);
      trackingErrors.add(
          new TrackingError(
              quantity.name(),
              quantity.unit(),
              errors == 0 ? 0 : Math.sqrt(squares[i] / errors),
              largest[i]));
    }
    return new LoopStatistics(
        cycles,
        holding,
        missed,
        missedByAccess,
        saturated,
        period.times(),
        late.times(),
        read.times(),
        write.times(),
        own.times(),
        trackingErrors);
  }
}
