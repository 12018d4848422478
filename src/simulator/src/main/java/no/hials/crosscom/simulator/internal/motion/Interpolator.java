package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Faulted;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import org.jspecify.annotations.Nullable;

/**
 * Moves the robot through its planned motions, cycle by cycle. Not thread-safe; the same calls give
 * the same trajectory, bit by bit.
 *
 * <p>A motion has a trapezoid profile, or a triangle, within its rates. A PTP is limited by the
 * axes alone. A LIN or CIRC is limited by path and orientation, whichever takes longer. Its axes
 * are computed when it is added. Where one of them would exceed its speed, or half of its
 * acceleration by a bend or a ramp, the profile is slower, so the robot creeps past a singularity.
 * A motion without a distance takes one cycle, and a motion that starts from standstill starts with
 * a cycle (both assumed).
 *
 * <p>In a blend over the time (C_PTP, C_VEL, C_ORI) the end of a motion and the start of the next
 * add up, so an axis that reverses has up to twice its acceleration. Speeds stay within their
 * limits. A corner that is cut (C_DIS, C_SPL) is a path of its own; when a motion is added, the
 * speeds of all motions before it that are passed without a stop are planned again.
 *
 * <p>Override, hold and brakes stretch the time of the plan: the robot stays on its path. They keep
 * within the accelerations of the axes, and on a LIN or CIRC of the TCP, to 2 %. Where the plan
 * slows down anyway, for a target or in a blend, it takes no less time than planned.
 *
 * <p>The class is long because all changes of the plan and all ways to leave it share its state.
 */
public final class Interpolator {
  /** The simulated time of one cycle, s. */
  public static final double CYCLE = 0.012;

  /** Two positions of an axis are the same if they are closer than this, degrees. */
  private static final double SAME = 1e-9;

  /** The robot stays at a stop this much before it is there, s: the motion has not ended yet. */
  private static final double AT_STOP = 1e-6;

  /** The attempts to find the step of a cycle: it depends on the path ahead, which may bend. */
  private static final int ATTEMPTS = 4;

  private enum Brake {
    NONE,
    PROGRAMMED,
    MAXIMUM
  }

  /** A place at which the robot stays. */
  private record Stop(long motion, PathPoint at) {}

  private Arm arm;
  private TrajectoryPlanner planner;
  private Blend blend;
  private PathLengths lengths;

  /** The limits of the current motions: the widest since they were added. */
  private RobotModel widest;

  private Blend way;
  private final List<PathSegment> planned = new ArrayList<>();
  private PathCursor cursor = PathCursor.NOWHERE;
  private Joints plannedEnd;
  private Joints last;
  private Joints now;
  private Frame tool = Frame.IDENTITY;
  private Brake brake = Brake.NONE;
  private boolean cancelled;
  private double rate;
  private @Nullable Stop stop;
  private @Nullable SuspendedPlan returning;

  /** Creates the interpolator of a robot without external axes. */
  public Interpolator(RobotModel robot, Axis start) {
    this(robot, ExternalAxes.NONE, new Joints(start, Axis.ZERO));
  }

  public Interpolator(RobotModel robot, ExternalAxes external, Joints start) {
    widest = robot;
    arm = new Arm(robot, external);
    planner = new TrajectoryPlanner(arm);
    blend = new Blend(arm);
    lengths = new PathLengths(arm);
    way = blend;
    plannedEnd = start;
    last = start;
    now = start;
  }

  /** Changes the limits for motions that are added from now on. */
  public void robot(RobotModel limited, ExternalAxes external) {
    arm = new Arm(limited, external);
    planner = new TrajectoryPlanner(arm);
    blend = new Blend(arm);
    lengths = new PathLengths(arm);
    Axis low = limited.home();
    Axis high = limited.home();
    for (int axis = 0; axis < Arm.AXES; axis++) {
      low = low.with(axis, Math.min(widest.minimum(axis), limited.minimum(axis)));
      high = high.with(axis, Math.max(widest.maximum(axis), limited.maximum(axis)));
    }
    widest = limited.withLimits(low, high);
    way = new Blend(new Arm(widest, external));
  }

  /**
   * Adds a motion after the planned ones. It blends with the one before unless the robot has
   * already passed the start of the blend, as on a real controller whose advance run is too late. A
   * corner that is cut is then smaller: it starts where the robot is; if it is too fast for that,
   * it turns at the target itself (assumed).
   *
   * @throws MotionRefusedException if an axis target is outside the limits, or the points define no
   *     circle
   */
  public void add(MotionCommand motion) throws MotionRefusedException {
    add(motion, ExternalTarget.of(plannedEnd.external()));
  }

  /**
   * Adds a motion, as {@link #add(MotionCommand)} does.
   *
   * @param external the end of the external axes, which start and end with the robot
   */
  public void add(MotionCommand motion, ExternalTarget external) throws MotionRefusedException {
    add(motion, external, true);
  }

  /**
   * Adds a motion, as {@link #add(MotionCommand)} does.
   *
   * @param external the end of the external axes, which start and end with the robot
   * @param blends whether it can blend with the one before
   */
  public void add(MotionCommand motion, ExternalTarget external, boolean blends)
      throws MotionRefusedException {
    if (cancelled) {
      throw new IllegalStateException("no motion can be added while the robot brakes to cancel");
    }
    PathSegment segment = planner.plan(motion, plannedEnd, external);
    PathSegment before = path().last();
    PlannedPath joined = blends && before != null ? joined(before, segment) : null;
    if (joined == null) {
      double overlap = blends && before != null ? blend.overlap(before, segment) : 0;
      boolean late = planned.isEmpty() && position().isBeyond(overlap);
      planned.add(late ? segment : segment.withOverlap(overlap));
    } else {
      follow(joined);
    }
    plannedEnd = segment.end();
  }

  private PathCursor position() {
    return returning == null ? cursor : returning.cursor();
  }

  private PlannedPath path() {
    return new PlannedPath(position().last(), position().lastTime(), planned);
  }

  /**
   * Adds a segment with a corner in place of the end of the one before; null if that is not
   * possible, or too late.
   */
  private @Nullable PlannedPath joined(PathSegment before, PathSegment segment) {
    double earliest = planned.isEmpty() ? path().earliestLeave() : 0;
    PathSegment joined = blend.joined(before, earliest, segment).orElse(null);
    Corner corner = joined == null ? null : joined.corner();
    if (joined == null || corner == null) {
      return null;
    }
    return path()
        .with(planned.size() - 1, before.until(corner.leave()))
        .with(planned.size(), joined)
        .replanned(planned.size(), 0)
        .orElse(null);
  }

  /** Changes the plan. */
  private void follow(PlannedPath path) {
    List<PathSegment> segments = List.copyOf(path.planned());
    planned.clear();
    planned.addAll(segments);
    if (path.running() == null) {
      return;
    }
    PathCursor there = position().withLast(path.running());
    if (returning == null) {
      cursor = there;
    } else {
      returning =
          new SuspendedPlan(
              returning.axes(),
              there,
              returning.planned(),
              returning.plannedEnd(),
              returning.before());
    }
  }

  /**
   * Returns the time in which the robot is at a place of a motion by the plan, s at 100 % override;
   * negative if it has passed it. Empty if the place is not planned yet, or no longer, or the robot
   * is not on its path.
   */
  public OptionalDouble timeTo(long motion, PathPoint at) {
    if (returning != null) {
      return OptionalDouble.empty();
    }
    try {
      PlannedPath path = path();
      if (cursor.next() != null && cursor.requireSegment().requireMotion().id() == motion) {
        return timeInBlend(cursor.requireSegment(), cursor.next(), at);
      }
      return path.find(motion, at, lengths)
          .map(place -> OptionalDouble.of(path.timeTo(place)))
          .orElse(OptionalDouble.empty());
    } catch (MotionRefusedException e) {
      return OptionalDouble.empty();
    }
  }

  /**
   * Returns how far after the end of the last motion a place of it is, mm; 0 or less if it is not.
   */
  public double beyondEnd(PathPoint at) {
    PathSegment last = path().last();
    if (last == null || at.mm() <= 0) {
      return 0;
    }
    try {
      return at.mm() - lengths.length(last, last.path().parameter(at.point()));
    } catch (MotionRefusedException e) {
      return 0;
    }
  }

  /** Returns the time to a place of a motion into which the next one is being blended. */
  private OptionalDouble timeInBlend(PathSegment segment, PathSegment next, PathPoint at)
      throws MotionRefusedException {
    double point = segment.path().parameter(at.point());
    if (at.mm() > lengths.length(segment, point)) {
      return OptionalDouble.empty();
    }
    double position = lengths.position(segment, point, at.mm());
    double middle = segment.duration() - next.overlap() / 2;
    double time = Math.min(middle, segment.profile().time(position));
    return OptionalDouble.of(time - cursor.time());
  }

  /** Returns the part of the planned time that the last cycle took: 0 if the robot stands. */
  public double rate() {
    return standing() ? 0 : rate;
  }

  /**
   * Plans a stop at a place of a motion; the robot stays there until {@link #passStop()}.
   *
   * @return whether the robot can still stop there
   */
  public boolean planStop(long motion, PathPoint at) {
    PlannedPath changed = path().stopping(motion, at, 0, lengths);
    if (changed == null) {
      return false;
    }
    follow(changed);
    stop = new Stop(motion, at);
    return true;
  }

  /** Returns whether the robot could still stop at a place if this is planned a cycle later. */
  public boolean canStopLater(long motion, PathPoint at) {
    return path().stopping(motion, at, CYCLE, lengths) != null;
  }

  /** Returns whether the robot is at the place of {@link #planStop}. */
  public boolean atStop() {
    return stop != null && timeToStop() <= 2 * AT_STOP;
  }

  /** Lets the robot go on from the place of {@link #planStop}. */
  public void passStop() {
    stop = null;
  }

  private double timeToStop() {
    return stop == null
        ? Double.POSITIVE_INFINITY
        : timeTo(stop.motion(), stop.at()).orElse(Double.POSITIVE_INFINITY);
  }

  /** Returns the points of the last motion that are the same as the ones before them. */
  public List<Integer> identicalPoints() {
    PathSegment last = path().last();
    SplineCurve curve = last == null ? null : SplinePlanner.curve(last.path());
    return curve == null ? List.of() : curve.identical();
  }

  /** Returns the points of the motion that was added last: of a block all, else its end. */
  public List<Joints> lastPoints() {
    PathSegment last = path().last();
    if (last != null && last.problem() != null) {
      return List.of();
    }
    return last == null ? List.of(plannedEnd) : last.points();
  }

  /** Returns the number of motions that have not started, which {@code $ADVANCE} limits. */
  public int planned() {
    return planned.size();
  }

  /**
   * Returns the end of the planned motions, where the next one will start; of a path that leaves
   * the limits, its last point within them.
   */
  public Joints plannedEnd() {
    return plannedEnd;
  }

  /**
   * Returns the motion of the main run; empty between motions. From the middle of a blend it is the
   * next one, on the way back to a path the interrupted one.
   */
  public Optional<MotionCommand> current() {
    return Optional.ofNullable(currentSegment()).map(PathSegment::motion);
  }

  /**
   * Returns the start of the main run's motion ({@code $AXIS_BACK}); between motions the current
   * axes.
   */
  public Joints currentStart() {
    PathSegment segment = currentSegment();
    return segment == null ? now : segment.start();
  }

  /**
   * Returns the end of the main run's motion ({@code $AXIS_FOR}); between motions the current axes.
   */
  public Joints currentEnd() {
    PathSegment segment = currentSegment();
    return segment == null ? now : segment.end();
  }

  /** Returns whether nothing is planned and the robot stands at the end of the last motion. */
  public boolean finished() {
    return cursor.segment() == null && planned.isEmpty() && returning == null;
  }

  /**
   * Returns whether the robot stands after the last cycle: held on its path, or at the end of a
   * motion that it has just reached.
   */
  public boolean standing() {
    return cursor.segment() == null || rate == 0;
  }

  /** Runs a cycle without a speed limit. */
  public List<MotionEvent> cycle(double override, boolean released) {
    return cycle(override, released, SpeedLimit.NONE);
  }

  /**
   * Runs a cycle.
   *
   * @param override the wanted speed, 0 to 1; at 0 the robot holds
   * @param released whether the robot may move; if not, it slows down on its path and holds
   * @param speedLimit the highest speed
   * @return the events of the cycle, in order
   */
  public List<MotionEvent> cycle(double override, boolean released, SpeedLimit speedLimit) {
    if (!(override >= 0 && override <= 1)) {
      throw new IllegalArgumentException("the override must be 0 to 1, is " + override);
    }
    double wanted = released && brake == Brake.NONE && !cancelled ? override : 0;
    List<MotionEvent> events = new ArrayList<>();
    if (cursor.segment() == null && !planned.isEmpty() && returning == null && wanted > 0) {
      cursor = PathCursor.at(planned.remove(0));
      events.add(new Started(cursor.requireSegment().requireMotion()));
    }
    if (atStop()) {
      last = now;
      rate = 0;
    } else if (cursor.segment() == null || (wanted == 0 && rate == 0)) {
      last = now;
    } else {
      move(wanted, speedLimit, events);
    }
    if (cancelled && standing()) {
      forget();
    }
    return List.copyOf(events);
  }

  /**
   * Slows down on the path and holds until {@link #goOn()} or {@link #suspend()} (KRL's BRAKE).
   *
   * @param maximum whether each axis brakes as hard as it can, not as programmed (BRAKE F)
   */
  public void brake(boolean maximum) {
    brake = maximum ? Brake.MAXIMUM : Brake.PROGRAMMED;
  }

  /** Ends {@link #brake(boolean)}: the next cycle continues. */
  public void goOn() {
    brake = Brake.NONE;
  }

  /**
   * Discards the current and all planned motions: immediately if the robot stands, else when it has
   * slowed down on its path.
   */
  public void cancel() {
    cancelled = true;
    if (standing()) {
      forget();
    }
  }

  /**
   * Suspends the plan, so that an interrupt can move the robot; ends {@link #brake(boolean)}.
   *
   * @return the plan for {@link #resume(SuspendedPlan, AxisRates)}
   * @throws IllegalStateException if the robot does not stand
   */
  public SuspendedPlan suspend() {
    if (!standing()) {
      throw new IllegalStateException("the robot must stand still before its plan is suspended");
    }
    SuspendedPlan suspended = new SuspendedPlan(now, cursor, planned, plannedEnd, returning);
    forget();
    return suspended;
  }

  /**
   * Resumes a plan. A robot that has moved in the meantime first returns by PTP to where it left
   * its path (assumed).
   *
   * @param rates the speed of the return
   * @throws IllegalStateException if the motions of the interrupt have not ended
   */
  public void resume(SuspendedPlan suspended, AxisRates rates) {
    if (!finished()) {
      throw new IllegalStateException("cannot resume a plan while another one runs");
    }
    planned.addAll(suspended.planned());
    plannedEnd = suspended.plannedEnd();
    rate = 0;
    if (now.largestDifference(suspended.axes()) > SAME) {
      returning = suspended;
      cursor = PathCursor.at(planner.back(now, suspended.axes(), rates));
    } else {
      cursor = suspended.cursor();
      returning = suspended.before();
    }
  }

  /** Returns the current axes, degrees. */
  public Axis axes() {
    return now.robot();
  }

  /** Returns the current axes with the external ones. */
  public Joints joints() {
    return now;
  }

  /** Returns the flange in {@code $ROBROOT}. */
  public Frame flange() {
    return arm.forward(now.robot());
  }

  /** Returns the mean speeds of the axes in the last cycle, degrees/s; 0 if the robot stands. */
  public Axis axisVelocity() {
    return velocity(now.minus(last).robot());
  }

  /** Returns the mean speeds of the external axes in the last cycle, in % of their highest. */
  public Axis externalVelocity() {
    Axis percent = velocity(now.minus(last).external());
    for (int i = 0; i < arm.external().count(); i++) {
      percent = percent.with(i, 100 * percent.get(i) / arm.external().limits().get(i).speed());
    }
    return percent;
  }

  private Axis velocity(Axis way) {
    if (standing()) {
      return Axis.ZERO;
    }
    double[] speeds = way.toArray();
    for (int axis = 0; axis < speeds.length; axis++) {
      speeds[axis] /= CYCLE;
    }
    return Axis.of(speeds);
  }

  /** Returns the mean speed of the TCP in the last cycle, m/s; 0 if the robot stands. */
  public double pathVelocity() {
    return standing() ? 0 : arm.tcp(now, tool).distance(arm.tcp(last, tool)) / CYCLE / 1000;
  }

  /**
   * Returns the distance of the TCP from the end of the main run's motion ({@code $DIST_NEXT}), mm;
   * 0 between motions. It is measured along the path of a LIN or CIRC, and in a straight line for a
   * PTP, in a blend and off the path (assumed).
   */
  @SuppressWarnings("ReferenceEquality") // two segments can be alike
  public double distanceToEnd() {
    PathSegment segment = currentSegment();
    if (segment == null) {
      return 0;
    }
    if (segment == cursor.segment()
        && cursor.next() == null
        && segment.path() instanceof JointPath.OfTcp path) {
      double position = segment.profile().position(cursor.time());
      Corner corner = segment.corner();
      if (corner == null || position >= corner.join()) {
        return path.curve().length() * (path.sampler().lastParameter() - position);
      }
    }
    return arm.tcp(now, segment.tool()).distance(arm.tcp(segment.end(), segment.tool()));
  }

  private @Nullable PathSegment currentSegment() {
    return returning == null ? cursor.current() : returning.cursor().current();
  }

  private void move(double wanted, SpeedLimit speedLimit, List<MotionEvent> events) {
    PathSegment segment = cursor.requireSegment();
    AccelerationLimits limits = AccelerationLimits.of(segment, cursor.next());
    if (brake == Brake.MAXIMUM) {
      limits = limits.withoutPath(planner.accelerations());
    }
    tool = segment.tool();
    SpeedGovernor governor = new SpeedGovernor(arm, CYCLE, limits, last, now, speedLimit);
    try {
      double part = rate;
      double horizon;
      PathCursor.Step step;
      Joints there;
      int attempts = 0;
      do {
        horizon = Math.max(SpeedGovernor.SHORTEST, part);
        step = advance(horizon);
        there = axes(step);
        part = governor.rate(wanted, rate, horizon, there);
        attempts++;
      } while (part != horizon && attempts < ATTEMPTS);
      if (part != horizon) {
        step = advance(part);
        there = axes(step);
      }
      rate = part;
      take(step, there, events);
    } catch (MotionRefusedException e) {
      events.add(new Faulted(segment.requireMotion(), e.problem(), now.robot()));
      forget();
    }
  }

  private PathCursor.Step advance(double part) {
    double seconds = Math.min(part * CYCLE, Math.max(0, timeToStop() - AT_STOP));
    return cursor.advance(seconds, returning == null ? planned : List.of());
  }

  private Joints axes(PathCursor.Step step) throws MotionRefusedException {
    return step.ended() == null
        ? new Joints(way.axes(step.cursor()), step.cursor().external())
        : step.ended().end();
  }

  private void take(PathCursor.Step step, Joints there, List<MotionEvent> events) {
    last = now;
    now = there;
    cursor = step.cursor();
    planned.subList(0, step.taken()).clear();
    events.addAll(step.events());
    if (step.ended() != null && step.ended().problem() != null) {
      forget();
    } else if (cursor.segment() == null && returning != null) {
      cursor = returning.cursor();
      returning = returning.before();
      rate = 0;
    }
  }

  /** Stops the robot where it is, with nothing planned. */
  private void forget() {
    cursor = PathCursor.NOWHERE;
    stop = null;
    planned.clear();
    plannedEnd = now;
    returning = null;
    brake = Brake.NONE;
    cancelled = false;
    rate = 0;
  }
}
