package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Faulted;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Passed;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import org.jspecify.annotations.Nullable;

/**
 * The position of the robot in its plan, in time at 100 % override.
 *
 * @param segment the current segment; null between motions
 * @param time the time since its start, s
 * @param next the segment that is being blended in, else null
 * @param nextTime the time since its start, s
 */
record PathCursor(
    @Nullable PathSegment segment, double time, @Nullable PathSegment next, double nextTime) {
  static final PathCursor NOWHERE = new PathCursor(null, 0, null, 0);

  /**
   * The result of a step.
   *
   * @param taken the number of planned segments that have started
   * @param ended the segment at whose end the robot stands, else null
   */
  record Step(
      PathCursor cursor, int taken, @Nullable PathSegment ended, List<MotionEvent> events) {}

  static PathCursor at(PathSegment segment) {
    return new PathCursor(segment, 0, null, 0);
  }

  PathSegment requireSegment() {
    return Objects.requireNonNull(segment);
  }

  /** Returns the segment of the main run: from the middle of a blend, the next one. */
  @Nullable PathSegment current() {
    if (next != null && nextTime >= next.overlap() / 2) {
      return next;
    }
    Corner corner = segment == null ? null : segment.corner();
    return segment != null && corner != null && segment.isBefore(time) ? corner.before() : segment;
  }

  /** Returns the time in the last segment, s. */
  double lastTime() {
    return next == null ? time : nextTime;
  }

  /** Replaces the last segment by one that is the same up to here. */
  PathCursor withLast(PathSegment changed) {
    return next == null
        ? new PathCursor(changed, time, null, 0)
        : new PathCursor(segment, time, changed, nextTime);
  }

  /** Returns the segment after which the planned ones follow. */
  @Nullable PathSegment last() {
    return next == null ? segment : next;
  }

  /** Returns the external axes; in a blend the sum of both segments. */
  Axis external() {
    Axis of = requireSegment().external(time);
    return next == null ? of : of.plus(next.external(nextTime).minus(next.travel().start()));
  }

  /** Returns whether it is too late to blend a new segment into the last one. */
  boolean isBeyond(double fromEnd) {
    PathSegment last = last();
    return last == null || lastTime() > last.duration() - fromEnd;
  }

  /**
   * Advances, at most to the end of a segment without a blend: the rest of the time is then lost,
   * because a motion starts with a cycle (assumed).
   *
   * @param planned the segments that have not started
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
      PathSegment now = at.current();
      if (now != null && there.current() != now) {
        events.add(new Passed(now.requireMotion()));
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
      } else if (follows != null && follows.corner() != null) {
        at = at(follows);
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
