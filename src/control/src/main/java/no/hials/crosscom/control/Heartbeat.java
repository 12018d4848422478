package no.hials.crosscom.control;

import java.time.Duration;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.control.StopReason.StopKind;

/** The heartbeat for the watchdog of {@code krl/jov_sps.sub}. */
final class Heartbeat {
  private static final String LIMIT = "JOV_LIMIT";
  private static final String BEAT = "JOV_HEARTBEAT";
  private static final String SEEN = "JOV_SEEN";

  /** How often the start checks whether the watchdog has seen the heartbeat. */
  private static final int ATTEMPTS = 50;

  private static final long PAUSE = Duration.ofMillis(20).toNanos();

  /** The number of beats within the time of the watchdog. */
  private static final int BEATS = 4;

  private final Channel channel;
  private final LoopTime time;
  private final long limitMillis;
  private final long interval;
  private final KRLInt beat = new KRLInt(BEAT);

  /** The setting of the watchdog, and the last beat that it saw; read while the loop runs. */
  final KRLInt limit = new KRLInt(LIMIT);

  final KRLInt seen = new KRLInt(SEEN);
  private int limitBefore;
  private long next;

  Heartbeat(Channel channel, LoopTime time, Duration limit) {
    this.channel = channel;
    this.time = time;
    this.limitMillis = limit.toMillis();
    this.interval = limit.toNanos() / BEATS;
  }

  /**
   * Switches the watchdog on and checks that it sees the heartbeat.
   *
   * @return whether the watchdog was on before
   */
  boolean start() throws ControlRefusedException {
    if (!isOn()) {
      return false;
    }
    try {
      limitBefore = channel.readInt(LIMIT);
      channel.read(beat);
      count();
      if (channel.readInt(SEEN) == beat.intValue()) {
        count(); // an earlier beat proves nothing
      }
    } catch (ControlRefusedException e) {
      throw new ControlRefusedException(
          new StopReason(
              StopKind.WATCHDOG,
              "the watchdog of krl/config.dat is not on this controller (noWatchdog() works without"
                  + " it): "
                  + e.getMessage(),
              e));
    }
    channel.write(beat);
    channel.writeInt(LIMIT, (int) limitMillis);
    for (int i = 0; channel.readInt(SEEN) != beat.intValue(); i++) {
      if (i == ATTEMPTS) {
        end();
        throw new ControlRefusedException(
            StopKind.WATCHDOG,
            "the watchdog does not see the heartbeat: "
                + SEEN
                + " must become "
                + beat.intValue()
                + ", is "
                + channel.readInt(SEEN)
                + "; JOV_SPS does not run");
      }
      pause();
    }
    next = time.nanoTime();
    return limitBefore > 0;
  }

  private void pause() {
    long end = time.nanoTime() + PAUSE;
    while (time.nanoTime() < end) {
      time.awaitUntil(end);
    }
  }

  private void count() {
    beat.setValue(beat.intValue() == Integer.MAX_VALUE ? 0 : beat.intValue() + 1);
  }

  /** Returns whether there is a watchdog. */
  boolean isOn() {
    return limitMillis > 0;
  }

  /** Checks that the setting of the watchdog, when last read, was still that of this loop. */
  void checkLimit() throws ControlRefusedException {
    if (limit.intValue() != limitMillis) {
      throw new ControlRefusedException(
          StopKind.WATCHDOG,
          LIMIT
              + " must be "
              + limitMillis
              + " as set by this loop, is "
              + limit.intValue()
              + "; another client uses the watchdog");
    }
  }

  /** Checks that the watchdog, when last read, had seen one of the latest beats. */
  void checkSeen() throws ControlRefusedException {
    // the beat after the largest is 0
    long behind = Math.floorMod(beat.intValue() - (long) seen.intValue(), 1L << 31);
    if (behind > BEATS) {
      throw new ControlRefusedException(
          StopKind.WATCHDOG,
          "the watchdog no longer sees the heartbeat: "
              + SEEN
              + " must be at most "
              + BEATS
              + " behind "
              + beat.intValue()
              + ", is "
              + seen.intValue()
              + "; JOV_SPS has stopped, or another client sends a heartbeat");
    }
  }

  boolean isDue() {
    return isOn() && time.nanoTime() - next >= 0;
  }

  /** Returns the next beat to be written. */
  KRLInt next() {
    count();
    next = time.nanoTime() + interval;
    return beat;
  }

  /** Restores the previous setting of the watchdog after the robot stands. */
  void end() throws ControlRefusedException {
    if (isOn()) {
      channel.writeInt(LIMIT, limitBefore);
    }
  }
}
