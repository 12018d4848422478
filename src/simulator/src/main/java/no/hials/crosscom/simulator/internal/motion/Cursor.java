package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Faulted;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Passed;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import org.jspecify.annotations.Nullable;

/**
 * Where the robot is in its plan, in time at 100 % override.
 *
 * @param leg the leg under way; none between motions
 * @param time how long it is under way, s
 * @param next the leg that has begun in the meantime
 * @param nextTime how long that is under way, s
 */
record Cursor(@Nullable Leg leg, double time, @Nullable Leg next, double nextTime) {
  static final Cursor NOWHERE = new Cursor(null, 0, null, 0);

  /**
   * Where a cursor comes to.
   *
   * @param taken how many of the planned legs have begun
   * @param ended the leg at whose end the robot stands, if it does
   */
  record Step(Cursor cursor, int taken, @Nullable Leg ended, List<MotionEvent> events) {}

  static Cursor at(Leg leg) {
    return new Cursor(leg, 0, null, 0);
  }

  /** Gives the leg under way where there is one. */
  Leg requireLeg() {
    return Objects.requireNonNull(leg);
  }

  /** Gives the leg that the main run is on: from the middle of a blend, the next one. */
  @Nullable Leg current() {
    return next != null && nextTime >= next.overlap() / 2 ? next : leg;
  }

  /** Gives the leg after which those that are still to come follow. */
  @Nullable Leg last() {
    return next == null ? leg : next;
  }

  /** Says whether it is too late for a leg that is added now to blend into the last one. */
  boolean isBeyond(double fromEnd) {
    Leg last = last();
    return last == null || (next == null ? time : nextTime) > last.duration() - fromEnd;
  }

  /**
   * Goes on, at most to where a leg ends without a blend: the rest of the time is then lost, since
   * a motion starts with a cycle (assumed).
   *
   * @param planned the legs that are still to come
   */
  @SuppressWarnings("ReferenceEquality") // two legs can be alike
  Step advance(double seconds, List<Leg> planned) {
    List<MotionEvent> events = new ArrayList<>();
    Cursor at = this;
    int taken = 0;
    Leg ended = null;
    double left = seconds;
    while (at.leg != null) {
      Leg follows = taken < planned.size() ? planned.get(taken) : null;
      double ahead = at.next == null && follows != null ? follows.overlap() : 0;
      double way = at.leg.duration() - ahead - at.time;
      Cursor there = at.moved(Math.min(left, way));
      if (there.current() != at.current()) {
        events.add(new Passed(at.leg.requireMotion()));
      }
      at = there;
      if (left < way) {
        break;
      }
      left -= way;
      if (at.next != null) {
        at = new Cursor(at.next, at.nextTime, null, 0);
      } else if (ahead > 0 && follows != null) {
        at = new Cursor(at.leg, at.time, follows, 0);
        events.add(new Started(follows.requireMotion()));
        taken++;
      } else {
        ended = at.leg;
        end(ended, events);
        at = NOWHERE;
      }
    }
    return new Step(at, taken, ended, events);
  }

  private Cursor moved(double seconds) {
    return new Cursor(leg, time + seconds, next, next == null ? 0 : nextTime + seconds);
  }

  private static void end(Leg leg, List<MotionEvent> events) {
    if (leg.motion() != null) {
      events.add(
          leg.problem() == null
              ? new Passed(leg.motion())
              : new Faulted(leg.motion(), leg.problem(), leg.path().end()));
    }
  }
}
