package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.inverse;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Circular;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Linear;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.PointToPoint;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.AxisLimit;
import no.hials.crosscom.simulator.internal.path.PathLimits;
import no.hials.crosscom.simulator.internal.path.Point;
import no.hials.crosscom.simulator.internal.path.Profile;
import no.hials.crosscom.simulator.internal.path.SampledProfile;
import no.hials.crosscom.simulator.internal.path.Trapezoid;
import org.jspecify.annotations.Nullable;

/** Plans motions: checks targets, computes the axes along paths and the fastest profile. */
final class TrajectoryPlanner {
  /** The distance of two points of a path, mm or degrees, however little the axes turn on it. */
  private static final double POINT_DISTANCE = 5;

  private static final int FEWEST = 3;
  private static final int MOST = 10;

  /** A motion that is no longer than this, mm or degrees, has no distance. */
  private static final double NOWHERE = 1e-9;

  private static final TypeSwitch<Planning, MotionCommand, PathSegment, MotionRefusedException>
      MOTIONS =
          TypeSwitch.create(
              MotionCommand.class,
              cases ->
                  cases
                      .on(
                          MotionCommand.Spline.class,
                          (it, motion) -> it.planner.splines.plan(motion, it.start))
                      .on(
                          MotionCommand.AxisSpline.class,
                          (it, motion) -> it.planner.splines.plan(motion, it.start))
                      .on(
                          PointToPoint.class,
                          (it, motion) -> it.planner.pointToPoint(motion, it.robot(), it.travel()))
                      .on(
                          Linear.class,
                          (it, motion) -> it.planner.linear(motion, it.robot(), it.travel()))
                      .on(
                          Circular.class,
                          (it, motion) -> it.planner.circular(motion, it.robot(), it.travel())));

  private final Arm arm;
  private final Axis accelerations;
  private final SplinePlanner splines;

  TrajectoryPlanner(Arm arm) {
    this.arm = arm;
    double[] six = new double[Arm.AXES];
    Arrays.setAll(six, arm::maxAcceleration);
    this.accelerations = Axis.of(six);
    this.splines = new SplinePlanner(arm, accelerations);
  }

  /** Returns the highest accelerations of the axes, degrees/s². */
  Axis accelerations() {
    return accelerations;
  }

  /** Plans a motion that starts at the end of the one before. */
  PathSegment plan(MotionCommand motion, Joints start, ExternalTarget external)
      throws MotionRefusedException {
    return MOTIONS.apply(new Planning(this, start, external), motion);
  }

  /** The start of a motion that is planned, and the end of its external axes. */
  private record Planning(TrajectoryPlanner planner, Joints start, ExternalTarget external) {
    Axis robot() {
      return start.robot();
    }

    Travel travel() throws MotionRefusedException {
      Optional<AxisLimit> beyond = planner.arm.external().beyondLimit(external.axes());
      if (beyond.isPresent()) {
        throw new MotionRefusedException(beyond.get());
      }
      return Travel.of(planner.arm.external(), start.external(), external);
    }
  }

  /** Plans the return to where the robot left a path. */
  PathSegment back(Joints start, Joints target, AxisRates rates) {
    // the limits may have changed since
    ExternalTarget external = ExternalTarget.of(target.external());
    Travel travel = Travel.of(arm.external(), start.external(), external);
    return segment(null, target.robot(), rates, start.robot(), travel);
  }

  private PathSegment pointToPoint(PointToPoint motion, Axis start, Travel travel)
      throws MotionRefusedException {
    Optional<AxisLimit> beyond = arm.beyondLimit(motion.target());
    if (beyond.isPresent()) {
      throw new MotionRefusedException(beyond.get());
    }
    return segment(motion, arm.clamped(motion.target()), motion.rates(), start, travel);
  }

  private PathSegment segment(
      @Nullable MotionCommand motion, Axis end, AxisRates rates, Axis start, Travel travel) {
    double[] most = new double[Arm.AXES];
    double speed = travel.speed();
    double acceleration = travel.acceleration();
    for (int axis = 0; axis < most.length; axis++) {
      double way = Math.abs(end.get(axis) - start.get(axis));
      most[axis] = arm.maxAcceleration(axis) * rates.acceleration().get(axis) / 100;
      speed = Math.min(speed, arm.maxSpeed(axis) * rates.velocity().get(axis) / 100 / way);
      acceleration = Math.min(acceleration, most[axis] / way);
    }
    double length = start.largestDifference(end) < NOWHERE && travel.isNone() ? 0 : 1;
    JointPath path = new JointPath.OfAxes(start, end, Axis.of(most));
    PathLimits limits = PathLimits.even(1, speed, acceleration);
    Profile profile = Trapezoid.of(length, speed, acceleration);
    return new PathSegment(motion, path, limits, profile, null, 0, travel, null);
  }

  private PathSegment linear(Linear motion, Axis start, Travel travel) {
    Frame from = arm.tcp(start, motion.tool());
    Frame to =
        keeps(motion.orientation()) ? Point.of(motion.target()).turnedAs(from) : motion.target();
    return along(
        motion, new Curve.Line(from, to), motion.rates(), motion.orientation(), start, travel);
  }

  /** Returns whether the orientation of the target does not count. */
  private static boolean keeps(OrientationControl orientation) {
    return orientation == OrientationControl.CONSTANT || orientation == OrientationControl.IGNORE;
  }

  private PathSegment circular(Circular motion, Axis start, Travel travel)
      throws MotionRefusedException {
    Frame from = arm.tcp(start, motion.tool());
    Frame orientation = keeps(motion.orientation()) ? from : motion.target();
    OptionalDouble angle = motion.angle();
    Arc arc = Arc.through(from, motion.auxiliary(), motion.target(), angle, orientation);
    return along(motion, arc, motion.rates(), motion.orientation(), start, travel);
  }

  private PathSegment along(
      MotionCommand motion,
      Curve target,
      PathRates rates,
      OrientationControl orientation,
      Axis start,
      Travel travel) {
    Curve curve = carried(target, travel);
    Frame flangeInTool = inverse(motion.tool());
    Solver solver = solver(curve, motion.tool(), flangeInTool, orientation, start);
    int points = (int) (Math.max(curve.length(), curve.angle()) / POINT_DISTANCE);
    PathSampler sampler =
        PathSampler.of(arm, solver, start, Math.max(FEWEST, Math.min(MOST, points)));
    double length = sampler.problem() == null ? 1 : sampler.lastParameter();
    if (curve.length() < NOWHERE && curve.angle() < NOWHERE && travel.isNone()) {
      length = 0;
    }
    boolean byPose = solver instanceof Solver.ByPose;
    JointPath path =
        new JointPath.OfTcp(
            sampler, curve, motion.tool(), flangeInTool, rates, byPose, accelerations);
    return profiled(motion, path, curve, rates, sampler, length, travel);
  }

  /** Returns a path in the moving root of the robot. */
  private Curve carried(Curve curve, Travel travel) {
    Point way = arm.external().root(travel.end().minus(travel.start()));
    return way.length() == 0 ? curve : new Curve.Carried(curve, way);
  }

  private Solver solver(
      Curve curve, Frame tool, Frame flangeInTool, OrientationControl orientation, Axis start) {
    Solver byPose = new Solver.ByPose(arm, curve, flangeInTool);
    if (orientation != OrientationControl.JOINT) {
      return byPose;
    }
    try {
      Axis end = arm.inverse(curve.at(1), flangeInTool, start);
      return new Solver.ByWrist(arm, curve, tool, start, end);
    } catch (MotionRefusedException e) {
      // out of reach: with this solver the robot moves as far as it can
      return byPose;
    }
  }

  private PathSegment profiled(
      MotionCommand motion,
      JointPath path,
      Curve curve,
      PathRates rates,
      PathSampler sampler,
      double length,
      Travel travel) {
    double speed =
        least(
            rates.velocity() * 1000 / curve.length(),
            rates.turnVelocity() / curve.angle(),
            travel.speed());
    double acceleration =
        least(
            rates.acceleration() * 1000 / curve.length(),
            rates.turnAcceleration() / curve.angle(),
            travel.acceleration());
    Profile free = Trapezoid.of(length, speed, acceleration);
    double[] parameters = sampler.parameters();
    if (length == 0 || parameters.length < 3) {
      PathLimits limits = PathLimits.even(1, speed, acceleration);
      return new PathSegment(motion, path, limits, free, sampler.problem(), 0, travel, null);
    }
    PathLimiter limiter =
        new PathLimiter(arm, AxisRates.of(100, 100), parameters, speed, acceleration);
    limiter.limitAxes(sampler.axes());
    PathLimits limits = limiter.limits();
    // a speed that is never reached need not be lowered
    double reached = Math.min(speed, Math.sqrt(length * acceleration));
    boolean slower =
        Arrays.stream(limits.speeds()).anyMatch(most -> most < reached)
            || Arrays.stream(limits.accelerations()).anyMatch(most -> most < acceleration);
    Profile profile = slower ? SampledProfile.of(limits) : free;
    return new PathSegment(motion, path, limits, profile, sampler.problem(), 0, travel, null);
  }

  private static double least(double one, double two, double three) {
    return Math.min(one, Math.min(two, three));
  }
}
