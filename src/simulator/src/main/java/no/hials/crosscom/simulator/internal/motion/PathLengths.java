package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.simulator.internal.path.Point;

/** Finds the positions of a path that the TCP reaches after some mm. */
final class PathLengths {
  /** The number of points by which the path of axes is measured. Assumed. */
  private static final int POINTS = 64;

  private final Arm arm;

  PathLengths(Arm arm) {
    this.arm = arm;
  }

  /** Returns the position that is some mm of the path before its end. */
  double fromEnd(PathSegment segment, double mm) throws MotionRefusedException {
    return position(segment, 1, -mm);
  }

  /** Returns the position that is some mm of the path after its start. */
  double fromStart(PathSegment segment, double mm) throws MotionRefusedException {
    return position(segment, 0, mm);
  }

  /**
   * Returns the position that is some mm of the path away from another one; at most its start or
   * its end.
   */
  double position(PathSegment segment, double from, double mm) throws MotionRefusedException {
    double end = mm < 0 ? 0 : 1;
    if (segment.path() instanceof JointPath.OfTcp tcp) {
      double way = mm / tcp.curve().length();
      return Double.isFinite(way) ? Math.max(0, Math.min(1, from + way)) : end;
    }
    double left = Math.abs(mm);
    double step = (end - from) / POINTS;
    Point last = point(segment, from);
    for (int i = 1; i <= POINTS; i++) {
      Point next = point(segment, from + i * step);
      double way = next.minus(last).length();
      if (way >= left && way > 0) {
        return from + step * (i - 1 + left / way);
      }
      left -= way;
      last = next;
    }
    return end;
  }

  /** Returns the length of the path from a position to its end, mm. */
  double length(PathSegment segment, double from) throws MotionRefusedException {
    if (segment.path() instanceof JointPath.OfTcp tcp) {
      return tcp.curve().length() * (1 - from);
    }
    double length = 0;
    for (int i = 0; i < POINTS; i++) {
      double step = (1 - from) / POINTS;
      length +=
          point(segment, from + i * step).minus(point(segment, from + (i + 1) * step)).length();
    }
    return length;
  }

  private Point point(PathSegment segment, double position) throws MotionRefusedException {
    Joints joints = new Joints(segment.path().at(position), segment.travel().at(position));
    return Point.of(arm.tcp(joints, segment.tool()));
  }
}
