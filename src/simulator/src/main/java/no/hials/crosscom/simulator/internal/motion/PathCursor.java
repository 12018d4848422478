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
 * @param segment the segment under way; none between motions
 * @param time how long it is under way, s
 * @param next the segment that has begun in the meantime
 * @param nextTime how long that is under way, s
 */
record PathCursor(
    @Nullable PathSegment segment, double time, @Nullable PathSegment next, double nextTime) {
  static final PathCursor NOWHERE = new PathCursor(null, 0, null, 0);

  /**
   * Where a cursor comes to.
   *
   * @param taken how many of the planned segments have begun
   * @param ended the segment at whose end the robot stands, if it does
   */
  record Step(
      PathCursor cursor, int taken, @Nullable PathSegment ended, List<MotionEvent> events) {}

  static PathCursor at(PathSegment segment) {
    return new PathCursor(segment, 0, null, 0);
  }

  /** Gives the segment under way where there is one. */
  PathSegment requireSegment() {
    return Objects.requireNonNull(segment);
  }

  /** Gives the segment that the main run is on: from the middle of a blend, the next one. */
  @Nullable PathSegment current() {
    return next != null && nextTime >= next.overlap() / 2 ? next : segment;
  }

  /** Gives the segment after which those that are still to come follow. */
  @Nullable PathSegment last() {
    return next == null ? segment : next;
  }

  /** Says whether it is too late for a segment that is added now to blend into the last one. */
  boolean isBeyond(double fromEnd) {
    PathSegment last = last();
    return last == null || (next == null ? time : nextTime) > last.duration() - fromEnd;
  }

  /**
   * Goes on, at most to where a segment ends without a blend: the rest of the time is then lost,
   * since a motion starts with a cycle (assumed).
   *
   * @param planned the segments that are still to come
   */
  @SuppressWarnings("ReferenceEquality") // two segments can be alike
  Step advance(double seconds, List<PathSegment> planned) {
    List<MotionEvent> events = new ArrayList<>();
    PathCursor at = this;
    int taken = 0;
    PathSegment ended = null;
    double left = seconds;
    while (at.segment != null) {
      PathSegment follows = taken < planned.size() ? planned.get(taken) : null;
      double ahead = at.next == null && follows != null ? follows.overlap() : 0;
      double way = at.segment.duration() - ahead - at.time;
      PathCursor there = at.moved(Math.min(left, way));
      if (there.current() != at.current()) {
        events.add(new Passed(at.segment.requireMotion()));
      }
      at = there;
      if (left < way) {
        break;
      }
      left -= way;
      if (at.next != null) {
        at = new PathCursor(at.next, at.nextTime, null, 0);
      } else if (ahead > 0 && follows != null) {
        at = new PathCursor(at.segment, at.time, follows, 0);
        events.add(new Started(follows.requireMotion()));
        taken++;
      } else {
        ended = at.segment;
        end(ended, events);
        at = NOWHERE;
      }
    }
    return new Step(at, taken, ended, events);
  }

  private PathCursor moved(double seconds) {
    return new PathCursor(segment, time + seconds, next, next == null ? 0 : nextTime + seconds);
  }

  private static void end(PathSegment segment, List<MotionEvent> events) {
    if (segment.motion() != null) {
      events.add(
          segment.problem() == null
              ? new Passed(segment.motion())
              : new Faulted(segment.motion(), segment.problem(), segment.path().end()));
    }
  }
}
