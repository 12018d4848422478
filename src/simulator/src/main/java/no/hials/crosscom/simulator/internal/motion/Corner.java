package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.internal.path.ArcLength;

/**
 * The curve between two segments, in place of the end of the first and the start of the second. It
 * extends the second segment: its parameter runs from {@code from} to {@code join}, and changes
 * there as fast as that of the segment.
 *
 * @param before the segment before, without a corner of its own
 * @param leave where it leaves the segment before
 * @param join where it joins the segment
 * @param from the parameter at which it starts
 * @param entry the change of the parameter before with the parameter here, at the start
 * @param lengths from the part of the curve to the part of the sum
 * @param path the axes, over the part of the curve
 */
record Corner(
    PathSegment before,
    double leave,
    double join,
    double from,
    double entry,
    ArcLength lengths,
    JointPath path) {

  /** Returns the position on the segment before, where a part of the sum is done. */
  static double first(double leave, double part) {
    return leave + (1 - leave) * part * (2 - part);
  }

  /** Returns the position on the second segment, where a part of the sum is done. */
  static double second(double join, double part) {
    return join * part * part;
  }

  double middle() {
    return (from + join) / 2;
  }

  /** Returns the part of the curve before a position. */
  double part(double position) {
    return Math.max(0, Math.min(1, (position - from) / (join - from)));
  }

  /** Returns the position where a part of the curve is done. */
  double position(double part) {
    return from + part * (join - from);
  }

  /**
   * Returns the position in place of one of the segment before: its end is the middle of the curve.
   */
  double positionOf(double positionBefore) {
    return position(Math.max(0, (positionBefore - leave) / (1 - leave)) / 2);
  }

  Axis external(double position, Travel next) {
    return external(before.travel(), leave, next, join, lengths.parameter(part(position)));
  }

  /** Returns the external axes where a part of the sum is done. */
  static Axis external(Travel before, double leave, Travel next, double join, double part) {
    Axis first = before.at(first(leave, part));
    return first.plus(next.at(second(join, part)).minus(next.start()));
  }
}
