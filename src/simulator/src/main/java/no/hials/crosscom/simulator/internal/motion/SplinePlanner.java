package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.inverse;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSegment;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSpline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.ConstantSpeed;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Sections;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Spline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Timed;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.AxisLimit;
import no.hials.crosscom.simulator.internal.path.PathLimits;
import no.hials.crosscom.simulator.internal.path.Point;
import no.hials.crosscom.simulator.internal.path.Profile;
import no.hials.crosscom.simulator.internal.path.SampledProfile;
import no.hials.crosscom.simulator.internal.path.SmoothCurve;
import no.hials.crosscom.simulator.internal.path.Trapezoid;
import org.jspecify.annotations.Nullable;

/** Plans spline blocks: the path first, by its points alone, then the fastest speed along it. */
final class SplinePlanner {
  /** The distance of two computed points, mm, as far as their number allows. Assumed. */
  private static final double POINT_DISTANCE = 5;

  private static final int FEWEST = 8;
  private static final int MOST = 24;

  /** How often the speeds of timed sections are corrected. */
  private static final int CORRECTIONS = 40;

  /** The times of timed sections are found when they differ by less than this part. */
  private static final double EXACT = 1e-6;

  private final Arm arm;
  private final PathLengths lengths;
  private final Axis accelerations;

  SplinePlanner(Arm arm, Axis accelerations) {
    this.arm = arm;
    this.lengths = new PathLengths(arm);
    this.accelerations = accelerations;
  }

  PathSegment plan(Spline motion, Joints start) throws MotionRefusedException {
    for (SplineSegment segment : motion.segments()) {
      requireWithin(arm.external().beyondLimit(segment.external().axes()));
    }
    Frame from = arm.tcp(start.robot(), motion.tool());
    Point rail = arm.external().root(Axis.ZERO.with(0, 1));
    SplineCurve curve = new SplineCurve(from, start.external(), motion.segments(), rail);
    if (curve.length() == 0) {
      return nowhere(motion, start);
    }
    Frame flangeInTool = inverse(motion.tool());
    double[] points = points(curve);
    Solver solver = new Solver.ByPose(arm, curve, flangeInTool);
    PathSampler sampler = PathSampler.of(arm, solver, start.robot(), points);
    PathRates rates = motion.segments().get(0).rates();
    for (SplineSegment segment : motion.segments()) {
      rates = PathRates.lower(rates, segment.rates());
    }
    JointPath path =
        new JointPath.OfTcp(
            sampler, curve, motion.tool(), flangeInTool, rates, true, accelerations);
    Axis end = curve.external(1);
    Travel travel = Travel.along(start.external(), end, curve::external);
    PathLimits limits = limits(curve, sampler);
    for (double stop : curve.stops()) {
      limits = stop < sampler.lastParameter() ? limits.withStop(stop) : limits;
    }
    PathSegment segment = segment(motion, path, limits, sampler, travel);
    return timed(segment, motion.sections());
  }

  private static void requireWithin(Optional<AxisLimit> beyond) throws MotionRefusedException {
    if (beyond.isPresent()) {
      throw new MotionRefusedException(beyond.get());
    }
  }

  private PathSegment nowhere(MotionCommand motion, Joints start) {
    JointPath path = new JointPath.OfAxes(start.robot(), start.robot(), accelerations);
    ExternalTarget external = ExternalTarget.of(start.external());
    Travel travel = Travel.of(arm.external(), start.external(), external);
    Profile profile = Trapezoid.of(0, 1, 1);
    return new PathSegment(motion, path, PathLimits.even(1, 1, 1), profile, null, 0, travel, null);
  }

  private static PathSegment segment(
      MotionCommand motion, JointPath path, PathLimits limits, PathSampler sampler, Travel travel) {
    Profile profile = SampledProfile.of(limits);
    return new PathSegment(motion, path, limits, profile, sampler.problem(), 0, travel, null);
  }

  private static double[] points(SplineCurve curve) {
    List<Double> points = new ArrayList<>();
    for (int i = 0; i < curve.count(); i++) {
      double from = curve.parameter(i);
      double way = curve.parameter(i + 1) - from;
      int number = (int) (way * curve.length() / POINT_DISTANCE);
      double[] parts = curve.evenParts(i, Math.max(FEWEST, Math.min(MOST, number)));
      for (int j = 0; j < parts.length - 1 && way > 0; j++) {
        points.add(from + way * parts[j]);
      }
      if (way > 0) {
        points.add(curve.parameter(i + 1));
      }
    }
    return points.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private PathLimits limits(SplineCurve curve, PathSampler sampler) {
    double[] parameters = sampler.parameters();
    double none = Double.POSITIVE_INFINITY;
    PathLimiter limiter = new PathLimiter(arm, AxisRates.of(100, 100), parameters, none, none);
    for (int i = 0; i < curve.count(); i++) {
      int first = index(parameters, curve.parameter(i));
      int last = index(parameters, curve.parameter(i + 1));
      List<Frame> frames = new ArrayList<>();
      for (int j = first; j <= last; j++) {
        frames.add(arm.fromOrigin(curve.at(parameters[j]), curve.external(parameters[j])));
      }
      if (first < last) {
        limiter.limitPath(first, frames, curve.segment(i).rates());
      }
    }
    limiter.limitAxes(sampler.axes());
    limiter.limitExternalAxes(Arrays.stream(parameters).mapToObj(curve::external).toList());
    return limiter.limits();
  }

  /** Returns the index of a parameter, or of the last one if the path ends before it. */
  private static int index(double[] parameters, double parameter) {
    int found = Arrays.binarySearch(parameters, parameter);
    return found >= 0 ? found : Math.min(parameters.length - 1, -found - 1);
  }

  PathSegment plan(AxisSpline motion, Joints start) throws MotionRefusedException {
    int count = motion.segments().size();
    double[][] points = new double[count + 1][];
    points[0] = all(start.robot(), start.external());
    double[] chords = new double[count];
    double[] distances = new double[count + 1];
    for (int i = 0; i < count; i++) {
      AxisSegment segment = motion.segments().get(i);
      requireWithin(arm.beyondLimit(segment.target()));
      requireWithin(arm.external().beyondLimit(segment.external().axes()));
      points[i + 1] = all(arm.clamped(segment.target()), segment.external().axes());
      chords[i] = SmoothCurve.length(SmoothCurve.sum(points[i + 1], 1, points[i], -1));
      distances[i + 1] = distances[i] + chords[i];
    }
    double length = distances[count];
    if (length == 0) {
      return nowhere(motion, start);
    }
    boolean[] stops = new boolean[count + 1];
    for (int i = 1; i < count; i++) {
      stops[i] = chords[i - 1] == 0 || chords[i] == 0;
    }
    SmoothCurve curve = new SmoothCurve(points, chords, stops);
    double[] knots = Arrays.stream(distances).map(distance -> distance / length).toArray();
    knots[count] = 1;
    JointPath.Function axes = at -> Axis.of(Arrays.copyOf(values(curve, knots, at), Arm.AXES));
    Solver solver = new Solver.ByAxes(axes);
    double[] through = Arrays.stream(knots).filter(knot -> knot > 0).distinct().toArray();
    PathSampler sampler = PathSampler.of(arm, solver, start.robot(), through);
    double leave = count > 1 ? knots[count - 1] : 0.5;
    JointPath path =
        new JointPath.OfJoints(
            sampler::at,
            start.robot(),
            sampler.lastAxes(),
            accelerations,
            leave,
            knots[1] / 2,
            knots);
    Travel travel =
        Travel.along(
            start.external(),
            motion.segments().get(count - 1).external().axes(),
            at -> Axis.of(Arrays.copyOfRange(values(curve, knots, at), Arm.AXES, 2 * Arm.AXES)));
    PathLimits limits = limits(motion, knots, sampler, travel);
    for (int i = 1; i < count; i++) {
      boolean inside = knots[i] > 0 && knots[i] < sampler.lastParameter();
      limits = stops[i] && inside ? limits.withStop(knots[i]) : limits;
    }
    PathSegment segment = segment(motion, path, limits, sampler, travel);
    return timed(segment, motion.sections());
  }

  private static double[] all(Axis robot, Axis external) {
    double[] all = Arrays.copyOf(robot.toArray(), 2 * Arm.AXES);
    System.arraycopy(external.toArray(), 0, all, Arm.AXES, Arm.AXES);
    return all;
  }

  private static double[] values(SmoothCurve curve, double[] knots, double at) {
    int found = Arrays.binarySearch(knots, at);
    int interval = Math.max(0, Math.min(knots.length - 2, found >= 0 ? found : -found - 2));
    double length = knots[interval + 1] - knots[interval];
    double part = length == 0 ? 1 : (at - knots[interval]) / length;
    return curve.at(interval, Math.max(0, Math.min(1, part)));
  }

  private PathLimits limits(AxisSpline motion, double[] knots, PathSampler sampler, Travel travel) {
    double[] parameters = sampler.parameters();
    double none = Double.POSITIVE_INFINITY;
    AxisRates full = AxisRates.of(100, 100);
    PathLimiter limiter = new PathLimiter(arm, full, parameters, none, none);
    for (int i = 0; i < motion.segments().size(); i++) {
      int first = index(parameters, knots[i]);
      int last = index(parameters, knots[i + 1]);
      limiter.limitAxes(sampler.axes(), first, last, motion.segments().get(i).rates());
    }
    limiter.limitAxes(sampler.axes());
    limiter.limitExternalAxes(Arrays.stream(parameters).mapToObj(travel::at).toList());
    limiter.limitEnds();
    return limiter.limits();
  }

  // sections

  /** Lowers the speeds of sections with a time or a constant speed. */
  private PathSegment timed(PathSegment segment, Sections sections) throws MotionRefusedException {
    if (sections.equals(Sections.NONE) || segment.problem() != null) {
      return segment;
    }
    PathLimits limits = timed(segment.limits(), sections.times(), segment.path());
    for (ConstantSpeed constant : sections.constants()) {
      double from = at(segment, constant.from());
      double to = at(segment, constant.to());
      limits = from < to ? constant(limits, from, to) : limits;
    }
    return segment.withCorner(null, limits).withProfile(SampledProfile.of(limits));
  }

  private double at(PathSegment segment, PathPoint at) throws MotionRefusedException {
    return lengths.position(segment, segment.path().parameter(at.point()), at.mm());
  }

  private static PathLimits constant(PathLimits limits, double from, double to) {
    PathLimits all = limits.with(from).with(to);
    SampledProfile profile = SampledProfile.of(all);
    double lowest = Double.POSITIVE_INFINITY;
    for (double parameter : all.parameters()) {
      if (parameter >= from && parameter <= to) {
        lowest = Math.min(lowest, profile.speed(profile.time(parameter)));
      }
    }
    return lowest > 0 ? all.lowered(from, to, lowest) : limits;
  }

  private static PathLimits timed(PathLimits limits, List<Timed> times, JointPath path) {
    double[] speeds = new double[times.size()];
    Arrays.fill(speeds, Double.POSITIVE_INFINITY);
    PathLimits changed = limits;
    for (int i = 0; i < CORRECTIONS && !times.isEmpty(); i++) {
      SampledProfile profile = SampledProfile.of(changed);
      double worst = 0;
      changed = limits;
      for (int j = 0; j < speeds.length; j++) {
        Timed timed = times.get(j);
        double from = path.parameter(timed.from());
        double to = path.parameter(timed.to());
        double takes = profile.time(to) - profile.time(from);
        double mean = (to - from) / timed.seconds();
        speeds[j] =
            speeds[j] == Double.POSITIVE_INFINITY
                ? (takes < timed.seconds() ? mean : speeds[j])
                : speeds[j] * takes / timed.seconds();
        if (speeds[j] < Double.POSITIVE_INFINITY && from < to) {
          worst = Math.max(worst, Math.abs(takes / timed.seconds() - 1));
          changed = changed.lowered(from, to, speeds[j]);
        }
      }
      if (worst < EXACT) {
        break;
      }
    }
    return changed;
  }

  /** Returns the spline of a motion whose path passes identical points; null if it does not. */
  static @Nullable SplineCurve curve(JointPath path) {
    return path instanceof JointPath.OfTcp tcp && tcp.curve() instanceof SplineCurve spline
        ? spline
        : null;
  }
}
