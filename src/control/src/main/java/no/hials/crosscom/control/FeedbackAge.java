package no.hials.crosscom.control;

import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.control.StopReason.StopKind;

/**
 * The age of a position by the clock of the controller, which is read with it: how much further
 * that clock lags behind the clock of this computer than in the reading with the smallest lag
 * (docs/reference/system-variables.md#the-clock-of-the-controller).
 */
final class FeedbackAge {
  private static final String CLOCK = "$ROB_TIMER";

  /** The assumed steps of the clock, a cycle of the controller, ns. */
  private static final long RESOLUTION = 12_000_000;

  /** The part by which two clocks may differ; a simulated controller on a busy computer is slow. */
  private static final double DRIFT = 0.02;

  final KRLInt clock = new KRLInt(CLOCK);
  private final Channel channel;
  private final LoopTime time;
  private final boolean on;
  private final double limitMillis;
  private final long interval;
  private boolean together;
  private int last;
  private long lastNanos;

  /** The time that has passed on the controller, ns. */
  private long passed;

  /** The smallest lead of the clock of this computer, ns. */
  private long smallestLead;

  FeedbackAge(Channel channel, LoopTime time, Safety safety) {
    this.channel = channel;
    this.time = time;
    this.on = safety.clock();
    this.interval = safety.checkInterval().toNanos();
    this.limitMillis = (safety.maxFeedbackAge().toNanos() + RESOLUTION) / 1e6;
  }

  /** Reads the clock for the first time. */
  void start() throws ControlRefusedException {
    if (!on) {
      return;
    }
    try {
      channel.read(clock);
    } catch (ControlRefusedException e) {
      if (!(e.reason().cause() instanceof CrossComAccessException)) {
        throw e;
      }
      throw new ControlRefusedException(
          new StopReason(
              StopKind.STALE_FEEDBACK,
              "the age of positions needs the clock of the controller (noClock() works without it):"
                  + " "
                  + e.getMessage(),
              e));
    }
    together = channel.readsTogether();
    last = clock.intValue();
    lastNanos = time.nanoTime();
    smallestLead = lastNanos;
  }

  /** Returns whether the clock is read with each position, in one message. */
  boolean isReadTogether() {
    return on && together;
  }

  /** Returns whether the clock has to be read in an access of its own. */
  boolean isDue() {
    return on && !together && time.nanoTime() - lastNanos >= interval;
  }

  /** Returns whether the clock was not read in time, as in a slow loop whose cycles have checks. */
  boolean isOverdue() {
    return on && !together && time.nanoTime() - lastNanos >= 2 * interval;
  }

  /** Checks the position that was read just before the clock, in the same cycle. */
  void check(String position) throws ControlRefusedException {
    long now = time.nanoTime();
    int millis = clock.intValue() - last; // also after the largest INT
    last = clock.intValue();
    passed += millis * 1_000_000L;
    long lead = now - passed;
    smallestLead = Math.min(lead, smallestLead + (long) (DRIFT * (now - lastNanos)));
    lastNanos = now;
    Guard.checkAtMost(
        StopKind.STALE_FEEDBACK,
        "the age of %s by " + CLOCK + " must be at most %s %s, is %s",
        position,
        limitMillis,
        "ms",
        (lead - smallestLead) / 1e6);
  }
}
