package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Faulted;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import org.jspecify.annotations.Nullable;

/**
 * Moves the robot through the motions that are planned for it, cycle by cycle. Not safe for use by
 * several threads; the same calls give the same trajectory, bit by bit.
 *
 * <p>A motion has a trapezoid profile, or a triangle, that keeps to its rates. A PTP is limited by
 * the axes alone. A LIN or CIRC is limited by path and orientation, whichever takes longer; its
 * axes are found when it is added, and where one of them would exceed its speed, or half of its
 * acceleration by a bend or a ramp, the profile is slower there: so it crawls past a singularity. A
 * motion that leads nowhere takes one cycle, and every motion that starts from standing starts with
 * a cycle (both assumed).
 *
 * <p>In a blend the end of a motion and the beginning of the next add up, so an axis that goes back
 * the way it came has up to twice its acceleration. Speeds stay within their limits.
 *
 * <p>Override, hold and brakes stretch the time of the plan: the robot stays on its path. They keep
 * to the accelerations of the axes, and on a LIN or CIRC of the TCP, within 2 %; but where the plan
 * slows down anyway, for a target or in a blend, it takes no less time than planned.
 */
public final class Interpolator {
  /**
   * The simulated time of one cycle, s: the interpolation cycle of 12 ms
   * (docs/reference/access-times.md#cycles).
   */
  public static final double CYCLE = 0.012;

  /** Two positions of an axis are the same if they are nearer, degrees. */
  private static final double SAME = 1e-9;

  /** How often the step of a cycle is sought: the path may bend, so what is ahead depends on it. */
  private static final int ATTEMPTS = 4;

  private enum Brake {
    NONE,
    PROGRAMMED,
    MAXIMUM
  }

  private Arm arm;
  private TrajectoryPlanner planner;
  private Blend blend;

  /** Where the motions under way may go: within the limits that there were when they were added. */
  private RobotModel widest;

  private Blend way;
  private final List<PathSegment> planned = new ArrayList<>();
  private PathCursor cursor = PathCursor.NOWHERE;
  private Axes plannedEnd;
  private Axes last;
  private Axes now;
  private Frame tool = Frame.IDENTITY;
  private Brake brake = Brake.NONE;
  private boolean cancelled;
  private double rate;
  private @Nullable SuspendedPlan returning;

  /**
   * Puts a robot somewhere, standing.
   *
   * @param robot the robot
   * @param start where its axes are, degrees
   */
  public Interpolator(RobotModel robot, Axes start) {
    widest = robot;
    arm = new Arm(robot);
    planner = new TrajectoryPlanner(arm);
    blend = new Blend(arm);
    way = blend;
    plannedEnd = start;
    last = start;
    now = start;
  }

  /**
   * Changes the software limits, for motions that are added from now on.
   *
   * @param limited the same robot with other limits
   */
  public void robot(RobotModel limited) {
    arm = new Arm(limited);
    planner = new TrajectoryPlanner(arm);
    blend = new Blend(arm);
    Axes low = limited.home();
    Axes high = limited.home();
    for (int axis = 0; axis < Arm.AXES; axis++) {
      low = low.with(axis, Math.min(widest.minimum(axis), limited.minimum(axis)));
      high = high.with(axis, Math.max(widest.maximum(axis), limited.maximum(axis)));
    }
    widest = limited.withLimits(low, high);
    way = new Blend(new Arm(widest));
  }

  /**
   * Adds a motion after those that are planned. It blends with the one before only if that has not
   * yet come to where the blend would begin, as the advance run of KSS then is too late.
   *
   * @param motion the motion, with its target resolved
   * @throws MotionRefusedException if an axis target is outside the limits, or there is no circle
   */
  public void add(MotionCommand motion) throws MotionRefusedException {
    if (cancelled) {
      throw new IllegalStateException("no motion can be added while the robot brakes to cancel");
    }
    PathSegment segment = planner.plan(motion, plannedEnd);
    PathCursor path = returning == null ? cursor : returning.cursor();
    PathSegment before = planned.isEmpty() ? path.last() : planned.get(planned.size() - 1);
    double overlap = before == null ? 0 : blend.overlap(before, segment);
    boolean late = planned.isEmpty() && path.isBeyond(overlap);
    planned.add(late ? segment : segment.withOverlap(overlap));
    plannedEnd = segment.path().end();
  }

  /**
   * Counts the motions that are added and have not begun.
   *
   * @return the number, which {@code $ADVANCE} limits
   */
  public int planned() {
    return planned.size();
  }

  /**
   * Gives where the planned motions end: where the next one that is added will start.
   *
   * @return the axes; of a path that leaves the limits, its last point within
   */
  public Axes plannedEnd() {
    return plannedEnd;
  }

  /**
   * Gives the motion that the main run is on. From the middle of a blend it is the next one. On the
   * way back to a path it is the motion that was interrupted.
   *
   * @return the motion, or none between motions
   */
  public Optional<MotionCommand> current() {
    return Optional.ofNullable(currentSegment()).map(PathSegment::motion);
  }

  /**
   * Gives where the motion of the main run starts ({@code $AXIS_BACK}).
   *
   * @return the axes; those of now between motions
   */
  public Axes currentStart() {
    PathSegment segment = currentSegment();
    return segment == null ? now : segment.path().start();
  }

  /**
   * Gives where the motion of the main run ends ({@code $AXIS_FOR}).
   *
   * @return the axes; those of now between motions
   */
  public Axes currentEnd() {
    PathSegment segment = currentSegment();
    return segment == null ? now : segment.path().end();
  }

  /**
   * Says whether nothing is left to do.
   *
   * @return whether nothing is planned and the robot stands at the end of the last motion
   */
  public boolean finished() {
    return cursor.segment() == null && planned.isEmpty() && returning == null;
  }

  /**
   * Says whether the robot stands: held on its path, or at the end of a motion that it has just
   * reached.
   *
   * @return whether it stands at the end of the last cycle
   */
  public boolean standing() {
    return cursor.segment() == null || rate == 0;
  }

  /**
   * Runs for a cycle.
   *
   * @param override the speed that is wanted, 0 to 1; at 0 the robot holds
   * @param released whether the robot may move; if not, it slows down on its path and holds
   * @return what happened, in order
   */
  public List<MotionEvent> cycle(double override, boolean released) {
    return cycle(override, released, SpeedLimit.NONE);
  }

  /**
   * Runs for a cycle in which the robot must not be too fast.
   *
   * @param override the speed that is wanted, 0 to 1; at 0 the robot holds
   * @param released whether the robot may move; if not, it slows down on its path and holds
   * @param speedLimit how fast it may be
   * @return what happened, in order
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
    if (cursor.segment() == null || (wanted == 0 && rate == 0)) {
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
   * Slows down on the path and holds, whatever the cycle says, until {@link #goOn()} or {@link
   * #suspend()} (KRL's BRAKE).
   *
   * @param maximum whether each axis brakes as fast as it can, not as programmed (BRAKE F)
   */
  public void brake(boolean maximum) {
    brake = maximum ? Brake.MAXIMUM : Brake.PROGRAMMED;
  }

  /** Ends {@link #brake(boolean)}: the next cycle goes on. */
  public void goOn() {
    brake = Brake.NONE;
  }

  /**
   * Forgets the motion under way and all that are planned, at once if the robot stands, and
   * otherwise when it has slowed down on its path.
   */
  public void cancel() {
    cancelled = true;
    if (standing()) {
      forget();
    }
  }

  /**
   * Puts the plan aside, so that an interrupt can move the robot; ends {@link #brake(boolean)}.
   *
   * @return what {@link #resume(SuspendedPlan, AxisRates)} needs
   * @throws IllegalStateException if the robot does not stand
   */
  public SuspendedPlan suspend() {
    if (!standing()) {
      throw new IllegalStateException("a plan can be put aside when the robot stands");
    }
    SuspendedPlan suspended = new SuspendedPlan(now, cursor, planned, plannedEnd, returning);
    forget();
    return suspended;
  }

  /**
   * Takes up a plan again. A robot that has moved in between goes back by PTP to where it left its
   * path (assumed), and then on.
   *
   * @param suspended the plan
   * @param rates how fast it goes back
   * @throws IllegalStateException if the motions of the interrupt have not ended
   */
  public void resume(SuspendedPlan suspended, AxisRates rates) {
    if (!finished()) {
      throw new IllegalStateException("a plan can be taken up when no other is under way");
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

  /**
   * Gives where the axes are.
   *
   * @return the axes, degrees
   */
  public Axes axes() {
    return now;
  }

  /**
   * Gives where the flange is.
   *
   * @return the flange in {@code $ROBROOT}
   */
  public Frame flange() {
    return arm.forward(now);
  }

  /**
   * Gives how fast the axes were on average in the last cycle.
   *
   * @return the speeds, degrees/s; 0 if the robot stands
   */
  public Axes axisVelocity() {
    if (standing()) {
      return Axes.ZERO;
    }
    double[] speeds = now.minus(last).toArray();
    for (int axis = 0; axis < speeds.length; axis++) {
      speeds[axis] /= CYCLE;
    }
    return Axes.of(speeds);
  }

  /**
   * Gives how fast the TCP was on average in the last cycle.
   *
   * @return the speed, m/s; 0 if the robot stands
   */
  public double pathVelocity() {
    return standing() ? 0 : arm.tcp(now, tool).distance(arm.tcp(last, tool)) / CYCLE / 1000;
  }

  /**
   * Gives how far the TCP is from the end of the motion of the main run ({@code $DIST_NEXT}): along
   * the path of a LIN or CIRC, as the crow flies for a PTP, in a blend and off the path (assumed).
   *
   * @return the distance, mm; 0 between motions
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
      return path.curve().length()
          * (path.sampler().lastParameter() - segment.profile().position(cursor.time()));
    }
    return arm.tcp(now, segment.tool()).distance(arm.tcp(segment.path().end(), segment.tool()));
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
      Axes there;
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
    } catch (NoPointException e) {
      events.add(new Faulted(segment.requireMotion(), e.problem(), now));
      forget();
    }
  }

  private PathCursor.Step advance(double part) {
    return cursor.advance(part * CYCLE, returning == null ? planned : List.of());
  }

  private Axes axes(PathCursor.Step step) throws NoPointException {
    return step.ended() == null ? way.axes(step.cursor()) : step.ended().path().end();
  }

  private void take(PathCursor.Step step, Axes there, List<MotionEvent> events) {
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

  /** Has the robot stand where it is, with nothing planned. */
  private void forget() {
    cursor = PathCursor.NOWHERE;
    planned.clear();
    plannedEnd = now;
    returning = null;
    brake = Brake.NONE;
    cancelled = false;
    rate = 0;
  }
}
