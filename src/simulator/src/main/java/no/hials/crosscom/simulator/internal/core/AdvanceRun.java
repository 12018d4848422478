package no.hials.crosscom.simulator.internal.core;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.internal.motion.ExternalAxes;
import no.hials.crosscom.simulator.internal.motion.Interpolator;
import no.hials.crosscom.simulator.internal.motion.Joints;
import no.hials.crosscom.simulator.internal.motion.MotionCommand;
import no.hials.crosscom.simulator.internal.motion.MotionEvent;
import no.hials.crosscom.simulator.internal.motion.MotionProblem;
import no.hials.crosscom.simulator.internal.motion.MotionRefusedException;
import no.hials.crosscom.simulator.internal.motion.SpeedLimit;
import no.hials.crosscom.simulator.internal.motion.SuspendedPlan;
import no.hials.crosscom.simulator.internal.program.BlockOrder;
import no.hials.crosscom.simulator.internal.program.MotionOrder;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The motions of the robot's program: those planned and under way, those that interrupts have
 * suspended, and steps that wait until the robot stands.
 */
final class AdvanceRun {
  private static final Logger LOG = LoggerFactory.getLogger(AdvanceRun.class);

  private static final TypeSwitch<AdvanceRun, MotionEvent, Void, RuntimeException> EVENTS =
      TypeSwitch.create(
          MotionEvent.class,
          cases ->
              cases
                  .run(MotionEvent.Started.class, (run, event) -> run.started(event.motion()))
                  .run(MotionEvent.Passed.class, (run, event) -> run.passed(event.motion()))
                  .run(
                      MotionEvent.Faulted.class,
                      (run, event) -> run.faulted(event.motion(), event.problem())));

  /** Called when the robot moves. */
  interface Listener {
    /** Called when the robot cannot move as the program says. */
    void failed(int number, String text);

    /** Called when the user has to know something that does not stop the robot. */
    void noticed(int number, String text);

    /**
     * Called when a motion starts, or the blend into it, with its base in the world and its tool.
     *
     * @param points its end; of a block all points
     */
    void started(List<Joints> points, Frame base, Frame tool);

    /**
     * Called when another motion is that of the main run, with its base in the world and its tool.
     */
    void current(Joints from, Joints to, Frame base, Frame tool);

    /** Called when the robot leaves its path for an interrupt. */
    void leftPath(Joints axes);
  }

  /** A step that waits until the robot stands, in the order of the requests. */
  private interface Step {
    /** Executes the step, and returns whether the next one may follow. */
    boolean execute(AdvanceRun run);
  }

  private static final Step PUT_ASIDE =
      run -> {
        run.putAside();
        return true;
      };

  private static final Step FORGET =
      run -> {
        run.restart();
        return true;
      };

  private record Begin(MotionOrder order) implements Step {
    @Override
    public boolean execute(AdvanceRun run) {
      return run.begin(order);
    }
  }

  /** A plan that an interrupt has suspended, and its statements. */
  private record Aside(SuspendedPlan plan, Map<Long, MotionOrder> orders) {}

  /** The numbers of KSS. */
  private static final int NOT_APPROXIMABLE = 1442;

  private static final int IDENTICAL_POINTS = 3171;

  private final SystemVariableAccess access;
  private final MotionSettings settings;

  /** The robot with the limits of its model. */
  private RobotModel unlimited;

  private final MotionResolver resolver;
  private final Triggers triggers;
  private final PathStops stops;
  private final Listener listener;
  private final ExternalAxesData externalData;

  /** The robot with the controller's software limits. */
  private RobotModel limited;

  private ExternalAxes external = ExternalAxes.NONE;
  private Interpolator interpolator;

  /** The statements of motions that were handed over and have not ended, by the motion's number. */
  private Map<Long, MotionOrder> orders = new HashMap<>();

  /** A motion that was planned: its base in the world, and its points. */
  private record Planned(Frame base, List<Joints> points) {}

  /** The motions that have not ended; also discarded ones, while the robot brakes. */
  private final Map<Long, Planned> plans = new HashMap<>();

  /** The plans that interrupts have suspended, the latest first. */
  private final Deque<Aside> aside = new ArrayDeque<>();

  /** The motion that was added last, while the robot has not stopped for another reason. */
  private @Nullable MotionOrder before;

  private final Deque<Step> waiting = new ArrayDeque<>();
  private long now;

  /** The number of the motion that the listener knows as that of the main run. */
  private long shown = -1;

  AdvanceRun(
      SystemVariableAccess access,
      RobotModel robot,
      Triggers triggers,
      PathStops stops,
      Listener listener) {
    this.stops = stops;
    this.access = access;
    settings = new MotionSettings(access);
    unlimited = robot;
    this.triggers = triggers;
    this.listener = listener;
    limited = robot;
    Joints start = access.joints("$AXIS_ACT", robot.home());
    externalData = new ExternalAxesData(access);
    resolver = new MotionResolver(access, robot, start);
    interpolator = new Interpolator(robot, ExternalAxes.NONE, start);
    readLimits();
  }

  Interpolator interpolator() {
    return interpolator;
  }

  MotionResolver resolver() {
    return resolver;
  }

  RobotModel model() {
    return limited;
  }

  /** Returns the number of motions whose plan is kept. */
  int plans() {
    return plans.size();
  }

  ExternalAxes externalAxes() {
    return external;
  }

  /** Reads the software limits, which clients and data lists can change. */
  void readLimits() {
    Axis low = unlimited.home();
    Axis high = unlimited.home();
    for (int i = 0; i < PositionValues.ROBOT_AXES; i++) {
      low = low.with(i, access.number("$SOFTN_END[" + (i + 1) + "]", unlimited.minimum(i)));
      high = high.with(i, access.number("$SOFTP_END[" + (i + 1) + "]", unlimited.maximum(i)));
    }
    ExternalAxes axes = externalData.read();
    if (isOf(limited, low, high) && axes.equals(external)) {
      return;
    }
    external = axes;
    try {
      limited = unlimited.withLimits(low, high);
    } catch (IllegalArgumentException e) {
      // a minimum above its maximum, perhaps because a client is about to change both
      LOG.debug("the software limits stay as they were: {}", e.getMessage());
    }
    resolver.robot(limited);
    interpolator.robot(limited, external);
  }

  private static boolean isOf(RobotModel model, Axis low, Axis high) {
    for (int i = 0; i < PositionValues.ROBOT_AXES; i++) {
      if (model.minimum(i) != low.get(i) || model.maximum(i) != high.get(i)) {
        return false;
      }
    }
    return true;
  }

  /** Replaces the robot by another one, which stands at the same axes. */
  void robot(RobotModel another) {
    unlimited = another;
    limited = another;
    resolver.robot(another);
    readLimits();
    place(interpolator.joints());
  }

  // requests of a program

  void move(MotionOrder order) throws KrlExecutionException {
    if (waiting.isEmpty()) {
      take(order);
    } else {
      waiting.add(new Begin(order));
    }
  }

  private void take(MotionOrder order) throws KrlExecutionException {
    readLimits();
    MotionCommand planned;
    try {
      planned = settings.with(order.settings(), () -> add(order));
    } catch (IllegalArgumentException e) {
      // numbers that cannot be computed with, such as a target of 1E38 mm
      throw new KrlExecutionException(MotionProblem.BAD_MOTION, String.valueOf(e.getMessage()));
    }
    orders.put(planned.id(), order);
    triggers.add(planned, order.triggers(), interpolator);
    stops.add(planned, order.stops());
  }

  private MotionCommand add(MotionOrder order) throws KrlExecutionException {
    MotionCommand planned = resolver.plan(order);
    boolean blends = before == null || before.spline() == order.spline();
    if (before != null && !blends && !before.approximations().isEmpty()) {
      listener.noticed(
          NOT_APPROXIMABLE,
          before.position() + ": a motion and a spline motion cannot be approximated");
    }
    try {
      interpolator.add(planned, resolver.externalTarget(order), blends);
    } catch (MotionRefusedException e) {
      throw new KrlExecutionException(e.problem().number(), e.problem().message());
    }
    interpolator
        .identicalPoints()
        .forEach(
            point ->
                listener.noticed(
                    IDENTICAL_POINTS,
                    pointPosition(order, point) + ": two points of the block are identical"));
    before = order;
    resolver.startAt(interpolator.plannedEnd());
    plans.put(planned.id(), new Planned(resolver.base(), interpolator.lastPoints()));
    return planned;
  }

  private static Position pointPosition(MotionOrder order, int point) {
    BlockOrder block = order.block();
    return block == null ? order.position() : block.segments().get(point - 1).position();
  }

  int ahead() {
    int ahead = interpolator.planned();
    for (Step step : waiting) {
      ahead += step instanceof Begin ? 1 : 0;
    }
    return ahead;
  }

  boolean finished() {
    return waiting.isEmpty() && interpolator.finished();
  }

  /** Returns whether all motions have ended and none is suspended. */
  boolean idle() {
    return finished() && aside.isEmpty();
  }

  void hold(boolean maximum) {
    waiting.add(PUT_ASIDE);
    interpolator.brake(maximum);
  }

  void release() {
    // empty if the robot was placed in the meantime
    if (!aside.isEmpty()) {
      Aside last = aside.pop();
      interpolator.resume(last.plan(), resolver.speeds().axes());
      orders = last.orders();
    }
    before = null;
    resolver.startAt(interpolator.plannedEnd());
  }

  void discard(int holds) {
    dropMotionsLast();
    for (int i = 0; i < holds; i++) {
      if (waiting.peekLast() == PUT_ASIDE) {
        waiting.removeLast();
        dropMotionsLast();
      } else {
        aside.poll();
      }
    }
    // motions that an earlier interrupt is about to suspend stay, and the robot brakes anyway
    if (!waiting.contains(PUT_ASIDE)) {
      waiting.add(FORGET);
      orders.clear();
      interpolator.cancel();
    }
    retain();
  }

  private void dropMotionsLast() {
    while (waiting.peekLast() instanceof Begin) {
      waiting.removeLast();
    }
  }

  private void retain() {
    Set<Long> kept = kept();
    triggers.retain(kept);
    stops.retain(kept);
  }

  private Set<Long> kept() {
    Set<Long> kept = new HashSet<>(orders.keySet());
    aside.forEach(plan -> kept.addAll(plan.orders().keySet()));
    return kept;
  }

  // requests of the controller

  /** Slows the robot down, and discards all motions when it stands. */
  void discardAll() {
    aside.clear();
    waiting.clear();
    orders.clear();
    triggers.clear();
    stops.clear();
    waiting.add(FORGET);
    interpolator.cancel();
    settle(false);
  }

  /** Puts the robot at a position immediately. */
  void place(Joints axes) {
    interpolator = new Interpolator(limited, external, axes);
    discardAll();
    listener.current(axes, axes, resolver.base(), resolver.tool());
  }

  /**
   * Executes the steps that waited until the robot stands.
   *
   * @param active whether the program runs; motions are planned only then
   */
  void settle(boolean active) {
    while (!waiting.isEmpty() && interpolator.standing()) {
      if (waiting.element() instanceof Begin && !active) {
        return;
      }
      if (!waiting.remove().execute(this)) {
        return;
      }
    }
  }

  private void putAside() {
    aside.push(new Aside(interpolator.suspend(), orders));
    orders = new HashMap<>();
    listener.leftPath(interpolator.joints());
    restart();
  }

  /** The next motion starts where the robot stands. */
  private void restart() {
    before = null;
    plans.keySet().retainAll(kept());
    resolver.startAt(interpolator.joints());
  }

  private boolean begin(MotionOrder order) {
    try {
      take(order);
      return true;
    } catch (KrlExecutionException e) {
      listener.failed(e.number(), order.position() + ": " + e.getMessage());
      return false;
    }
  }

  /**
   * Moves the robot for one cycle.
   *
   * @return whether triggers have fired
   */
  boolean cycle(long time, double override, boolean released, SpeedLimit speedLimit) {
    now = time;
    boolean moves = released;
    try {
      if (released) {
        stops.cycle(interpolator);
      }
    } catch (KrlExecutionException e) {
      listener.failed(e.number(), "STOP WHEN: " + e.getMessage());
      moves = false;
    }
    interpolator.cycle(override, moves, speedLimit).forEach(event -> EVENTS.run(this, event));
    interpolator.current().filter(motion -> motion.id() != shown).ifPresent(this::show);
    return triggers.cycle(time, interpolator);
  }

  private void started(MotionCommand motion) {
    Planned plan = plan(motion);
    listener.started(plan.points(), plan.base(), motion.tool());
    if (interpolator.current().isEmpty()) {
      show(motion); // it has ended in the same cycle
    }
    triggers.started(motion);
  }

  private void show(MotionCommand motion) {
    shown = motion.id();
    listener.current(
        interpolator.currentStart(), interpolator.currentEnd(), plan(motion).base(), motion.tool());
  }

  private Planned plan(MotionCommand motion) {
    return plans.getOrDefault(
        motion.id(), new Planned(resolver.base(), List.of(interpolator.currentEnd())));
  }

  private void passed(MotionCommand motion) {
    long next = interpolator.current().map(MotionCommand::id).orElse(-1L);
    triggers.passed(motion, now, next);
    orders.remove(motion.id());
    plans.remove(motion.id());
  }

  /**
   * Discards the motion. The motions after it are planned again when the program continues, and a
   * plan that an interrupt has suspended stays.
   */
  private void faulted(MotionCommand motion, MotionProblem problem) {
    MotionOrder order = orders.get(motion.id());
    String where = order == null ? "" : order.position() + ": ";
    List<MotionOrder> following =
        orders.entrySet().stream()
            .filter(entry -> entry.getKey() > motion.id())
            .sorted(Map.Entry.<Long, MotionOrder>comparingByKey().reversed())
            .map(Map.Entry::getValue)
            .toList();
    following.forEach(next -> waiting.addFirst(new Begin(next)));
    orders.clear();
    retain();
    restart();
    listener.failed(problem.number(), where + problem.message());
  }
}
