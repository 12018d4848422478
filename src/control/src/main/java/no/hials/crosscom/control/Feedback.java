package no.hials.crosscom.control;

import java.util.ArrayDeque;
import no.hials.crosscom.control.Space.Quantity;
import no.hials.crosscom.control.StopReason.StopKind;
import org.jspecify.annotations.Nullable;

/**
 * Checks the measured position from cycle to cycle: its speed, the tracking error, and whether the
 * value changes at all.
 *
 * @param <P> the position
 */
final class Feedback<P> {
  /**
   * The shortest time over which a speed is measured, ns. The moment of a value within its access
   * is not known, which is up to 24 ms at both ends
   * (docs/reference/access-times.md#50000-accesses).
   */
  private static final long WINDOW = 200_000_000;

  /** The factor by which a robot that catches up may exceed the speed limit of the law. */
  private static final double CATCHING_UP = 1.5;

  /**
   * The number of equal readings of a stall. Each reading counts at most for its share of the time,
   * since a value does not change while this computer pauses.
   */
  private static final int READINGS_OF_STALL = 5;

  /** The shortest commanded motion, mm or degrees, that must change the value. */
  private static final double NOTICEABLE = 0.01;

  /** A position of the robot and its time. */
  private record Fix<P>(long nanos, P place) {}

  private final Space<P> space;
  private final long maxStall;
  private final Meter meter;
  private final double[] differences;
  private final ArrayDeque<Fix<P>> fixes = new ArrayDeque<>();
  private @Nullable P last;
  private @Nullable P target;
  private long lastNanos;

  /** The time since the last change of the value, ns. */
  private long unchanged;

  Feedback(Space<P> space, Safety safety, Meter meter) {
    this.space = space;
    this.maxStall = safety.maxStall().toNanos();
    this.meter = meter;
    this.differences = new double[space.quantities.size()];
  }

  /** Sets the commanded position; null if the robot was told to stand. */
  void setCommanded(@Nullable P place) {
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
      checkError(); // a stalled value is reported as a stall, not as a tracking error
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
          StopKind.SPEED,
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
          StopKind.STALLED_FEEDBACK,
          space.feedback.getName()
              + " must change within "
              + maxStall / 1_000_000
              + " ms when the robot is told to move, was the same for "
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
          StopKind.TRACKING_ERROR,
          "the tracking error of %s must be at most %s %s, is %s",
          quantity.name(),
          quantity.limits().trackingError(),
          quantity.unit(),
          differences[i]);
    }
  }
}
