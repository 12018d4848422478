package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.inverse;
import static no.hials.crosscom.kinematics.Frames.product;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.AxisDistance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Distance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Exact;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Orientation;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Speed;
import no.hials.crosscom.simulator.internal.path.ArcLength;
import no.hials.crosscom.simulator.internal.path.PathLimits;
import no.hials.crosscom.simulator.internal.path.Point;
import org.jspecify.annotations.Nullable;

/**
 * The sum of two segments. The rest of the first and the done part of the next add up: of the TCP
 * if both are paths of the same TCP, else of the axes. C_DIS and C_SPL add them up along the path,
 * the others over the time.
 */
final class Blend {
  /**
   * {@code $APO_DIS_PTP}, degrees: 90 for every axis; C_PTP is a percentage of it
   * (docs/reference/system-variables.md#machine-data).
   */
  private static final double AXIS_DISTANCE = 90;

  /**
   * The time of the blend where a corner cannot be cut, s: the robot slows down to the target, but
   * does not stay there.
   */
  private static final double TURN = 1e-6;

  /** How exactly the time of a blend is found: halvings of the longest time. */
  private static final int HALVINGS = 20;

  /** The smallest part of a path that a corner can cut. */
  private static final double SHORTEST = 1e-9;

  /** The number of points at which a blend is checked. */
  private static final int TRIALS = 4;

  /** The part of the length that the orientation counts for where both change. Assumed. */
  private static final double MM_PER_DEGREE = 0.5;

  private final Arm arm;
  private final PathLengths lengths;

  Blend(Arm arm) {
    this.arm = arm;
    lengths = new PathLengths(arm);
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
    if (byPose(segment.path(), next.path())) {
      JointPath.OfTcp from = (JointPath.OfTcp) segment.path();
      JointPath.OfTcp to = (JointPath.OfTcp) next.path();
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

  static Frame sum(Frame first, Frame second, Frame corner) {
    Point position = Point.of(first).plus(Point.of(second).minus(Point.of(corner)));
    Frame turn = product(turn(second), inverse(turn(corner)), turn(first));
    return position.turnedAs(turn);
  }

  private static Frame turn(Frame frame) {
    return new Frame(0, 0, 0, frame.a(), frame.b(), frame.c());
  }

  /**
   * Returns a segment with a curve from the one before: the corner that C_DIS and C_SPL cut. It
   * leaves the segment before at the distance before its end, and joins the next at the distance
   * after its start, each at most at half. The rest of the one and the done part of the next add
   * up: of straight lines to a parabola within their triangle. Empty if it cannot.
   *
   * @param earliest the first position at which the robot can still leave the segment before
   */
  Optional<PathSegment> joined(PathSegment before, double earliest, PathSegment next) {
    if (before.motion() == null
        || !(before.motion().approximation() instanceof Distance distance)
        || before.problem() != null
        || next.problem() != null
        || before.duration() == 0
        || next.duration() == 0
        || distance.mm() == 0
        || earliest >= 1) {
      return Optional.empty();
    }
    try {
      double nominal =
          Math.max(before.path().earliestLeave(), lengths.fromEnd(before, distance.mm()));
      double leave = Math.max(nominal, earliest);
      double join = Math.min(next.path().latestJoin(), lengths.fromStart(next, distance.mm()));
      // where two points of a block are identical, there is no path to cut
      return leave > 1 - SHORTEST || join < SHORTEST
          ? Optional.empty()
          : Optional.of(joined(before, leave, next, join));
    } catch (MotionRefusedException e) {
      // the corner may be at a limit
      return Optional.empty();
    }
  }

  private PathSegment joined(PathSegment before, double leave, PathSegment next, double join)
      throws MotionRefusedException {
    ArcLength length = length(before, leave, next, join);
    Curve curve = null;
    Solver solver;
    if (byPose(before.path(), next.path())) {
      JointPath.OfTcp from = (JointPath.OfTcp) before.path();
      JointPath.OfTcp to = (JointPath.OfTcp) next.path();
      curve = new Curve.Blended(from.curve(), leave, to.curve(), join, length);
      solver = new Solver.ByPose(arm, curve, from.flangeInTool());
    } else {
      solver = new Solver.ByAxes(part -> sum(before, leave, next, join, length.parameter(part)));
    }
    Axis start = before.path().at(leave);
    PathSampler sampler = PathSampler.of(arm, solver, start, length.evenParts());
    if (sampler.problem() != null) {
      throw new MotionRefusedException(sampler.problem());
    }
    // the curve extends the next segment, whose parameter it continues
    double extent = 2 * join * length.slopeAtEnd();
    double entry = 2 * (1 - leave) * length.slopeAtStart() / extent;
    JointPath path =
        new JointPath.OfJoints(
            sampler::at,
            start,
            sampler.lastAxes(),
            next.path().accelerations(),
            leave,
            join,
            new double[] {0, 1});
    Corner corner =
        new Corner(
            before.withCorner(null, before.limits()),
            leave,
            join,
            join - extent,
            entry,
            length,
            path);
    PathLimits limits =
        next.limits()
            .between(join, 1)
            .after(limits(before, next, corner, sampler, curve).scaled(extent, join - extent));
    return next.withCorner(corner, limits);
  }

  /** Measures the curve: of the TCP, or of the axes if it has no path of the TCP. */
  private ArcLength length(PathSegment before, double leave, PathSegment next, double join)
      throws MotionRefusedException {
    if (byPose(before.path(), next.path())) {
      Curve from = ((JointPath.OfTcp) before.path()).curve();
      Curve to = ((JointPath.OfTcp) next.path()).curve();
      Frame[] points = new Frame[ArcLength.INTERVALS + 1];
      for (int i = 0; i < points.length; i++) {
        double part = (double) i / ArcLength.INTERVALS;
        Axis external = Corner.external(before.travel(), leave, next.travel(), join, part);
        points[i] = arm.fromOrigin(Curve.Blended.sum(from, leave, to, join, part), external);
      }
      return new ArcLength(
          i -> points[i].distance(points[i + 1]) + MM_PER_DEGREE * angle(points[i], points[i + 1]));
    }
    Axis[] points = new Axis[ArcLength.INTERVALS + 1];
    for (int i = 0; i < points.length; i++) {
      points[i] = sum(before, leave, next, join, (double) i / ArcLength.INTERVALS);
    }
    return new ArcLength(i -> points[i].largestDifference(points[i + 1]));
  }

  private PathLimits limits(
      PathSegment before,
      PathSegment next,
      Corner corner,
      PathSampler sampler,
      @Nullable Curve curve) {
    double[] parameters = sampler.parameters();
    AxisRates rates = AxisRates.lower(rates(before), rates(next));
    PathLimiter limiter =
        new PathLimiter(arm, rates, parameters, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    limiter.limitAxes(sampler.axes());
    List<Axis> external =
        Arrays.stream(parameters)
            .mapToObj(part -> corner.external(corner.position(part), next.travel()))
            .toList();
    limiter.limitExternalAxes(external);
    Optional<PathRates> path =
        Stream.of(before.path(), next.path())
            .filter(JointPath.OfTcp.class::isInstance)
            .map(of -> ((JointPath.OfTcp) of).rates())
            .reduce(PathRates::lower);
    if (path.isPresent()) {
      List<Frame> frames = new ArrayList<>();
      for (int i = 0; i < parameters.length; i++) {
        Frame tcp =
            curve == null ? arm.tcp(sampler.axes().get(i), next.tool()) : curve.at(parameters[i]);
        frames.add(arm.fromOrigin(tcp, external.get(i)));
      }
      limiter.limitPath(0, frames, path.get());
    }
    limiter.limitEnds();
    return limiter.limits();
  }

  private static AxisRates rates(PathSegment segment) {
    if (segment.motion() instanceof MotionCommand.AxisSpline spline) {
      return spline.segments().stream()
          .map(MotionCommand.AxisSegment::rates)
          .reduce(AxisRates.of(100, 100), AxisRates::lower);
    }
    return segment.motion() instanceof MotionCommand.PointToPoint ptp
        ? ptp.rates()
        : AxisRates.of(100, 100);
  }

  private static Axis sum(
      PathSegment before, double leave, PathSegment next, double join, double part)
      throws MotionRefusedException {
    return sum(
        before.path().at(Corner.first(leave, part)),
        next.path().at(Corner.second(join, part)),
        next.path().start());
  }

  private static boolean byPose(JointPath first, JointPath second) {
    return first instanceof JointPath.OfTcp from
        && second instanceof JointPath.OfTcp to
        && from.byPose()
        && to.byPose()
        && from.tool().equals(to.tool());
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
    if (approximation instanceof Distance distance) {
      return distance.mm() == 0 ? 0 : Math.min(longest, TURN);
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
