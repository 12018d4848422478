package no.hials.crosscom.control;

import java.time.Duration;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.control.StopReason.Kind;

/** The heartbeat that the watchdog of {@code krl/jov_sps.sub} looks at. */
final class Heartbeat {
  private static final String LIMIT = "JOV_LIMIT";
  private static final String BEAT = "JOV_HEARTBEAT";
  private static final String SEEN = "JOV_SEEN";

  /** How often the watchdog is asked at the start whether it has seen the heartbeat. */
  private static final int ATTEMPTS = 50;

  private static final long PAUSE = Duration.ofMillis(20).toNanos();

  /** How many beats are sent in the time that the watchdog waits. */
  private static final int BEATS = 4;

  private final Channel channel;
  private final LoopTime time;
  private final long limitMillis;
  private final long interval;
  private final KRLInt beat = new KRLInt(BEAT);

  /** What the watchdog is set to, and the last beat it saw; to be read while the loop runs. */
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

  /** Switches the watchdog on, and makes sure that it looks. */
  void start() throws ControlRefusedException {
    if (!isOn()) {
      return;
    }
    try {
      limitBefore = channel.readInt(LIMIT);
      channel.read(beat);
      count();
      if (channel.readInt(SEEN) == beat.intValue()) {
        count(); // what was seen before proves nothing
      }
    } catch (ControlRefusedException e) {
      throw new ControlRefusedException(
          new StopReason(
              Kind.WATCHDOG,
              "the watchdog of krl/config.dat is not on this controller (noWatchdog() does without"
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
            Kind.WATCHDOG,
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

  /** Says whether there is a watchdog. */
  boolean isOn() {
    return limitMillis > 0;
  }

  /** Says whether the watchdog was on already. */
  boolean wasOn() {
    return limitBefore > 0;
  }

  /** Refuses a watchdog, as it was read last, that somebody has set to something else. */
  void checkLimit() throws ControlRefusedException {
    if (limit.intValue() != limitMillis) {
      throw new ControlRefusedException(
          Kind.WATCHDOG,
          LIMIT
              + " must be "
              + limitMillis
              + " as this loop has set it, is "
              + limit.intValue()
              + "; another client uses the watchdog");
    }
  }

  /** Refuses a watchdog that has not seen, as it was read last, any of the latest beats. */
  void checkSeen() throws ControlRefusedException {
    // the beat after the greatest is 0
    long behind = Math.floorMod(beat.intValue() - (long) seen.intValue(), 1L << 31);
    if (behind > BEATS) {
      throw new ControlRefusedException(
          Kind.WATCHDOG,
          "the watchdog does not see the heartbeat any more: "
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

  /** Gives the next beat to be written. */
  KRLInt next() {
    count();
    next = time.nanoTime() + interval;
    return beat;
  }

  /** Sets the watchdog to what it was before, once the robot stands. */
  void end() throws ControlRefusedException {
    if (isOn()) {
      channel.writeInt(LIMIT, limitBefore);
    }
  }
}
