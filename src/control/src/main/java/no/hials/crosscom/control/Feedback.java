package no.hials.crosscom.control;

import java.util.ArrayDeque;
import no.hials.crosscom.control.Space.Quantity;
import no.hials.crosscom.control.StopReason.Kind;
import org.jspecify.annotations.Nullable;

/**
 * Looks at where the robot is from cycle to cycle: how fast it is, whether it follows, and whether
 * the value changes at all.
 *
 * @param <P> the position
 */
final class Feedback<P> {
  /**
   * The shortest time over which a speed is measured, ns. When within its access a value was taken
   * is not known, which is up to 24 ms (krl.md 5) at either end.
   */
  private static final long WINDOW = 200_000_000;

  /** How much faster than the law may ask for a robot may be that catches up. */
  private static final double CATCHING_UP = 1.5;

  /**
   * At least so many readings have to be the same for a stall, each counting for its share of the
   * time at most: while this computer stands still, the value cannot be seen to change.
   */
  private static final int READINGS_OF_STALL = 5;

  /** So far, mm or degrees, the robot has to be told to go for the value to change. */
  private static final double NOTICEABLE = 0.01;

  /** Where the robot was, and when. */
  private record Fix<P>(long nanos, P place) {}

  private final Space<P> space;
  private final long maxStall;
  private final Meter meter;
  private final double[] differences;
  private final ArrayDeque<Fix<P>> fixes = new ArrayDeque<>();
  private @Nullable P last;
  private @Nullable P target;
  private long lastNanos;

  /** How long the value has not changed, ns. */
  private long unchanged;

  Feedback(Space<P> space, Safety safety, Meter meter) {
    this.space = space;
    this.maxStall = safety.maxStall().toNanos();
    this.meter = meter;
    this.differences = new double[space.quantities.size()];
  }

  /** Remembers where the robot was told to be; nothing if it was told to stand. */
  void told(@Nullable P place) {
    target = place;
  }

  void check(P actual, long now) throws ControlRefusedException {
    checkSpeed(actual, now);
    if (target != null) {
      space.differences(actual, target, differences);
      meter.error(differences);
    }
    checkStall(actual, now);
    if (target != null) {
      checkError(); // of a value that stalls is said that it does
    }
    last = actual;
  }

  private void checkSpeed(P actual, long now) throws ControlRefusedException {
    fixes.addLast(new Fix<>(now, actual));
    Fix<P> oldest = fixes.getFirst();
    while (now - fixes.getFirst().nanos() >= WINDOW) {
      oldest = fixes.removeFirst();
    }
    if (now - oldest.nanos() < WINDOW) {
      return;
    }
    double seconds = (now - oldest.nanos()) / 1e9;
    space.differences(oldest.place(), actual, differences);
    for (int i = 0; i < differences.length; i++) {
      Quantity quantity = space.quantities.get(i);
      double limit = quantity.limits().speed() * CATCHING_UP;
      double speed = differences[i] / seconds;
      Guard.checkAtMost(
          Kind.SPEED,
          "the measured speed of %s must be at most %s %s/s, is %s",
          quantity.name(),
          limit,
          quantity.unit(),
          speed);
    }
  }

  private void checkStall(P actual, long now) throws ControlRefusedException {
    long since = now - lastNanos;
    lastNanos = now;
    if (last == null || !last.equals(actual) || !isToldToMove()) {
      unchanged = 0;
      return;
    }
    unchanged += Math.min(since, maxStall / READINGS_OF_STALL);
    if (unchanged > maxStall) {
      throw new ControlRefusedException(
          Kind.STALLED_FEEDBACK,
          space.feedback().getName()
              + " must change within "
              + maxStall / 1_000_000
              + " ms when the robot is told to move, has not for "
              + unchanged / 1_000_000
              + " ms");
    }
  }

  private boolean isToldToMove() {
    if (target == null) {
      return false;
    }
    for (double difference : differences) {
      if (difference > NOTICEABLE) {
        return true;
      }
    }
    return false;
  }

  private void checkError() throws ControlRefusedException {
    for (int i = 0; i < differences.length; i++) {
      Quantity quantity = space.quantities.get(i);
      Guard.checkAtMost(
          Kind.TRACKING_ERROR,
          "the tracking error of %s must be at most %s %s, is %s",
          quantity.name(),
          quantity.limits().trackingError(),
          quantity.unit(),
          differences[i]);
    }
  }
}
