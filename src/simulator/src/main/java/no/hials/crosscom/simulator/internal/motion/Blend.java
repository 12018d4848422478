package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.inverse;
import static no.hials.crosscom.kinematics.Frames.product;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.AxisDistance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Distance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Exact;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Orientation;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Speed;

/**
 * The sum of two segments. The rest of the first and the done part of the next add up: of the TCP
 * if both are paths of the same TCP, else of the axes.
 */
final class Blend {
  /**
   * {@code $APO_DIS_PTP}, degrees: 90 for every axis; C_PTP is a percentage of it
   * (docs/reference/system-variables.md#machine-data).
   */
  private static final double AXIS_DISTANCE = 90;

  /** How exactly the time of a blend is found: halvings of the longest time. */
  private static final int HALVINGS = 20;

  /** The number of points at which a blend is checked. */
  private static final int TRIALS = 4;

  private final Arm arm;

  Blend(Arm arm) {
    this.arm = arm;
  }

  Axis axes(PathCursor at) throws MotionRefusedException {
    return arm.clamped(unlimited(at));
  }

  private Axis unlimited(PathCursor at) throws MotionRefusedException {
    PathSegment segment = at.requireSegment();
    PathSegment next = at.next();
    if (next == null) {
      return segment.at(at.time());
    }
    if (segment.path() instanceof JointPath.OfTcp from
        && next.path() instanceof JointPath.OfTcp to
        && from.byPose()
        && to.byPose()
        && from.tool().equals(to.tool())) {
      Frame first = from.curve().at(segment.profile().position(at.time()));
      Frame second = to.curve().at(next.profile().position(at.nextTime()));
      Axis near = sum(segment.near(at.time()), next.near(at.nextTime()), to.start());
      Frame tcp = sum(first, second, to.curve().at(0));
      return arm.inverse(tcp, from.flangeInTool(), near);
    }
    return sum(segment.at(at.time()), next.at(at.nextTime()), next.path().start());
  }

  private static Axis sum(Axis first, Axis second, Axis corner) {
    return first.plus(second.minus(corner));
  }

  private static Frame sum(Frame first, Frame second, Frame corner) {
    Point position = Point.of(first).plus(Point.of(second).minus(Point.of(corner)));
    Frame turn = product(turn(second), inverse(turn(corner)), turn(first));
    return position.turnedAs(turn);
  }

  private static Frame turn(Frame frame) {
    return new Frame(0, 0, 0, frame.a(), frame.b(), frame.c());
  }

  /** Returns the time that a segment can blend with the one before, s; 0 if it cannot. */
  double overlap(PathSegment segment, PathSegment next) {
    double longest = Math.min(segment.profile().rampDown(), next.profile().rampUp());
    if (segment.motion() == null || segment.problem() != null || longest == 0) {
      return 0;
    }
    double overlap = kept(segment.motion().approximation(), segment, next, longest);
    return isPassable(segment, next, overlap) ? overlap : 0;
  }

  private double kept(
      ApproximationZone approximation, PathSegment segment, PathSegment next, double longest) {
    if (approximation instanceof Exact) {
      return 0;
    }
    if (approximation instanceof Speed speed) {
      return Math.min(longest, segment.profile().rampDown() * speed.percent() / 100);
    }
    if (isKept(approximation, segment, next, longest)) {
      return longest;
    }
    double kept = 0;
    double step = longest;
    for (int i = 0; i < HALVINGS; i++) {
      step /= 2;
      if (isKept(approximation, segment, next, kept + step)) {
        kept += step;
      }
    }
    return kept;
  }

  /** Returns whether a blend is inside the zone where it starts and where it ends. */
  private boolean isKept(
      ApproximationZone approximation, PathSegment segment, PathSegment next, double overlap) {
    try {
      double begin = segment.duration() - overlap;
      if (approximation instanceof AxisDistance ptp) {
        double most = ptp.percent() / 100 * AXIS_DISTANCE;
        return segment.path().end().largestDifference(segment.at(begin)) <= most
            && next.path().start().largestDifference(next.at(overlap)) <= most;
      }
      Frame first = tcp(segment, begin, segment.tool());
      Frame corner = tcp(segment, segment.duration(), segment.tool());
      Frame second = tcp(next, overlap, segment.tool());
      if (approximation instanceof Distance distance) {
        return first.distance(corner) <= distance.mm() && second.distance(corner) <= distance.mm();
      }
      if (approximation instanceof Orientation orientation) {
        return angle(first, corner) <= orientation.degrees()
            && angle(second, corner) <= orientation.degrees();
      }
      throw new IllegalArgumentException("no distance to the corner: " + approximation);
    } catch (MotionRefusedException e) {
      return false;
    }
  }

  private Frame tcp(PathSegment segment, double time, Frame tool) throws MotionRefusedException {
    return arm.fromOrigin(tcpInRoot(segment, time, tool), segment.external(time));
  }

  private Frame tcpInRoot(PathSegment segment, double time, Frame tool)
      throws MotionRefusedException {
    return segment.path() instanceof JointPath.OfTcp path
            && path.byPose()
            && path.tool().equals(tool)
        ? path.curve().at(segment.profile().position(time))
        : arm.tcp(segment.at(time), tool);
  }

  /** Returns whether the arm can pass the whole blend: a corner may be out of its reach. */
  private boolean isPassable(PathSegment segment, PathSegment next, double overlap) {
    try {
      for (int i = 1; i < TRIALS; i++) {
        double time = overlap * i / TRIALS;
        PathCursor at = new PathCursor(segment, segment.duration() - overlap + time, next, time);
        if (arm.beyondLimit(unlimited(at)).isPresent()) {
          return false;
        }
      }
      return true;
    } catch (MotionRefusedException e) {
      return false;
    }
  }
}
