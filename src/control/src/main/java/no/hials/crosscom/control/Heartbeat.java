package no.hials.crosscom.control;

import java.time.Duration;
import java.util.concurrent.ThreadLocalRandom;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.control.StopReason.StopKind;
import org.jspecify.annotations.Nullable;

/** The heartbeat for the watchdog of {@code krl/jov_sps.sub}. */
final class Heartbeat {
  private static final String LIMIT = "JOV_LIMIT";
  private static final String BEAT = "JOV_HEARTBEAT";
  private static final String SEEN = "JOV_SEEN";

  /** How often the start checks whether the watchdog has seen the heartbeat. */
  private static final int ATTEMPTS = 50;

  private static final long PAUSE = Duration.ofMillis(20).toNanos();

  /**
   * The part of the watchdog's time in which another loop beats, late or not. After the whole time
   * the watchdog would stop a program without a heartbeat.
   */
  private static final double BEAT_OF_OTHER = 3.0 / 8;

  /** The longest wait for a beat of another driver. */
  private static final long LONGEST_SILENCE = Duration.ofSeconds(10).toNanos();

  /** The silence after which another driver counts as stopped if the watchdog is off. */
  private static final long SILENCE = Duration.ofMillis(500).toNanos();

  /** The time in which another driver has to stop for a takeover. */
  private static final Duration TAKEOVER = Duration.ofSeconds(5);

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

  /** The time of the last beat, or shortly before the first one was seen. */
  private long last;

  /** The heartbeat before the other checks; null if the controller does not have it. */
  private @Nullable Integer first;

  Heartbeat(Channel channel, LoopTime time, Duration limit) {
    this.channel = channel;
    this.time = time;
    this.limitMillis = limit.toMillis();
    this.interval = limit.toNanos() / BEATS;
  }

  /** Reads the heartbeat before the other checks, for {@link #checkAlone}. */
  void observe() throws ControlRefusedException {
    try {
      first = channel.readInt(BEAT);
    } catch (ControlRefusedException e) {
      if (!(e.reason().cause() instanceof CrossComAccessException)) {
        throw e;
      }
      // without the variable there is no driver with a heartbeat, and start() refuses a watchdog
    }
  }

  /**
   * Checks that no other client has sent a heartbeat since {@link #observe}. If the watchdog is on,
   * it watches for a part of its time.
   *
   * @param takeover whether another driver is stopped, instead of refusing to start
   */
  void checkAlone(boolean takeover) throws ControlRefusedException {
    if (first == null) {
      return;
    }
    long silence = Math.min(LONGEST_SILENCE, (long) (BEAT_OF_OTHER * 1e6 * channel.readInt(LIMIT)));
    long end = time.nanoTime() + silence;
    int found = channel.readInt(BEAT);
    while (found == first && time.nanoTime() < end) {
      pause();
      found = channel.readInt(BEAT);
    }
    if (found == first) {
      return;
    }
    if (!takeover) {
      throw new ControlRefusedException(
          StopKind.OTHER_DRIVER,
          BEAT
              + " must not change before the start, changed from "
              + first
              + " to "
              + found
              + "; another client drives the robot");
    }
    takeOver(silence > 0 ? silence : SILENCE);
  }

  /** Replaces the beats of another loop, which stops when it no longer sees its own. */
  private void takeOver(long silence) throws ControlRefusedException {
    beat.setValue(random());
    long begin = time.nanoTime();
    long replaced = begin;
    channel.write(beat);
    while (time.nanoTime() - replaced <= silence) {
      pause();
      if (channel.readInt(BEAT) != beat.intValue()) {
        if (time.nanoTime() - begin > TAKEOVER.toNanos()) {
          throw new ControlRefusedException(
              StopKind.OTHER_DRIVER,
              "the other driver must stop within "
                  + TAKEOVER.toSeconds()
                  + " s of the takeover, still changes "
                  + BEAT);
        }
        replaced = time.nanoTime();
        channel.write(beat);
      }
    }
  }

  /** Returns a beat far from those of other drivers, which therefore see each other. */
  private static int random() {
    return ThreadLocalRandom.current().nextInt(Integer.MAX_VALUE);
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
      beat.setValue(random());
      if (channel.readInt(SEEN) == beat.intValue()) {
        count(); // an earlier beat proves nothing
      }
    } catch (ControlRefusedException e) {
      throw new ControlRefusedException(
          new StopReason(
              StopKind.WATCHDOG,
              "the watchdog of krl/config.dat is not on this controller: " + e.getMessage(),
              e));
    }
    last = time.nanoTime();
    channel.write(beat);
    channel.writeInt(LIMIT, (int) limitMillis);
    long asked = time.nanoTime();
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
      last = asked; // not seen then
      pause();
      asked = time.nanoTime();
    }
    // without a limit it sees the beats as well
    channel.read(limit);
    checkLimit();
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

  /**
   * Checks that the next beat is not too late for the watchdog, such as after the computer was
   * asleep.
   */
  void checkInTime() throws ControlRefusedException {
    if (isOn()) {
      Guard.checkAtMost(
          StopKind.LATE_HEARTBEAT,
          "the time between %s must be at most %s %s, is %s; the watchdog stops the program",
          "two heartbeats",
          (double) limitMillis,
          "ms",
          (time.nanoTime() - last) / 1e6);
    }
  }

  boolean isDue() {
    return isOn() && time.nanoTime() - next >= 0;
  }

  /** Returns the next beat to be written. */
  KRLInt next() throws ControlRefusedException {
    checkInTime();
    count();
    last = time.nanoTime();
    next = last + interval;
    return beat;
  }

  /** Restores the previous setting of the watchdog after the robot stands. */
  void end() throws ControlRefusedException {
    if (isOn()) {
      KRLInt before = new KRLInt(LIMIT);
      before.setValue(limitBefore);
      channel.writeLast(before);
    }
  }
}
