package no.hials.crosscom.simulator.internal.core;

import java.time.Duration;
import java.time.LocalDateTime;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Supplier;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.kinematics.UnreachableException;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.ProgramState;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import no.hials.crosscom.simulator.internal.motion.Interpolator;
import no.hials.crosscom.simulator.internal.motion.PointToPoint;
import no.hials.crosscom.simulator.internal.motion.SpeedLimit;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter;
import no.hials.crosscom.simulator.internal.program.LinkException;
import no.hials.crosscom.simulator.internal.program.MotionOrder;
import no.hials.crosscom.simulator.internal.program.ProgramEnvironment;
import no.hials.crosscom.simulator.internal.program.ProgramLibrary;
import org.jspecify.annotations.Nullable;

/**
 * The simulated controller but for its network: programs, motion, modes, messages and time.
 *
 * <p>Everything happens in cycles of 12 ms, one after the other: timers, submit interpreter, robot
 * interpreter, motion, system variables. One lock is held during a cycle and during every other
 * call. What clients read between two cycles is the state after the last.
 */
public final class ControllerCore {
  /** The interpolation cycle of a KR C4 (krl.md 5: RSI's IPO cycle), ms. */
  public static final int CYCLE_MILLIS = 12;

  /**
   * How many instructions the interpreters execute in a cycle. Assumed: the reference does not say
   * how fast they are; it keeps a loop without end from stopping everything else.
   */
  private static final int ROBOT_INSTRUCTIONS = 1000;

  private static final int SUBMIT_INSTRUCTIONS = 500;

  private static final double PERCENT = 100;
  private static final VariablePath OV_PRO = SystemVariableAccess.path("$OV_PRO");
  private static final VariablePath OV_JOG = SystemVariableAccess.path("$OV_JOG");
  private static final VariablePath ADVANCE = SystemVariableAccess.path("$ADVANCE");
  private static final VariablePath RED_T1 = SystemVariableAccess.path("$RED_T1");
  private static final VariablePath VEL_CP_T1 = SystemVariableAccess.path("$VEL_CP_T1");
  private static final int MAX_ADVANCE = 5;

  private static final VariablePath VEL_LIMIT_T1 =
      SystemVariableAccess.path("$SPEED_LIMIT_TEACH_MODE");
  private static final VariablePath T2_OV_REDUCE = SystemVariableAccess.path("$T2_OV_REDUCE");

  /** krl.md 2.2: the override falls to 10 % on entry to T2. */
  private static final int OVERRIDE_IN_T2 = 10;

  /** Fair, so that a clock without a limit lets others in between its cycles. */
  private final ReentrantLock lock = new ReentrantLock(true);

  private final SystemVariableAccess access;
  private final ProgramLibrary library;
  private final KrlInterpreter robot;
  private final KrlInterpreter submit;
  private final MessageWindow messages = new MessageWindow();
  private final Timers timers;
  private final AdvanceRun motions;
  private final SystemVariables variables;
  private volatile long time;
  private volatile boolean closed;
  private OperatingMode mode = OperatingMode.T1;
  private boolean emergency;

  /** What moves the robot while no program is active. */
  private Manual manual = Manual.NOTHING;

  private enum Manual {
    NOTHING,
    MOTION,
    JOG
  }

  /** The simulation's own error after which nothing moves any more. */
  private @Nullable RuntimeException failure;

  /**
   * Makes a controller that stands where {@code $AXIS_ACT} says.
   *
   * @param globals the variables that clients see
   * @param model the robot; its software limits are replaced by {@code $SOFTN_END} and {@code
   *     $SOFTP_END}
   * @param begin what {@code $DATE} shows at first
   */
  public ControllerCore(Scope globals, RobotModel model, LocalDateTime begin) {
    access = new SystemVariableAccess(globals);
    library = new ProgramLibrary(globals, SystemVariables::stopsAdvanceRun);
    robot = new KrlInterpreter(Interpreter.ROBOT, new RobotEnvironment());
    submit = new KrlInterpreter(Interpreter.SUBMIT, new SubmitEnvironment());
    timers = new Timers(access);
    Triggers triggers = new Triggers(robot::fire);
    motions = new AdvanceRun(access, model, triggers, new MotionListener());
    variables = new SystemVariables(globals, access, model, robot, submit, state());
    publish();
    variables.bind(() -> time, begin);
  }

  // calls from outside

  /** Looks at something, or works with what no variable shows. */
  private <T> T locked(Supplier<T> work) {
    lock.lock();
    try {
      return work.get();
    } finally {
      lock.unlock();
    }
  }

  /** Changes something, and has the variables show it. */
  private void change(Runnable work) {
    locked(
        () -> {
          work.run();
          publish();
          return true;
        });
  }

  /**
   * Works with the modules on the controller.
   *
   * @param work what to do
   * @param <T> the type of its result
   * @return the result
   */
  public <T> T withLibrary(Function<ProgramLibrary, T> work) {
    return locked(() -> work.apply(library));
  }

  /**
   * Selects a program.
   *
   * @param kind which interpreter shall run it
   * @param name its name
   * @param arguments the values of its first parameters
   * @throws LinkException if there is no such program or something is wrong with it
   * @throws KrlExecutionException if the arguments do not suit it
   */
  public void select(Interpreter kind, String name, List<KrlValue> arguments)
      throws LinkException, KrlExecutionException {
    lock.lock();
    try {
      KrlInterpreter interpreter = interpreter(kind);
      requireIdle(interpreter, "select");
      interpreter.select(library.program(name), arguments);
      if (kind == Interpreter.ROBOT) {
        motions.discardAll();
      }
      publish();
    } finally {
      lock.unlock();
    }
  }

  private static void requireIdle(KrlInterpreter interpreter, String what) {
    if (interpreter.state() == ProgramState.ACTIVE) {
      throw new IllegalStateException(what + ": a program is active, stop it first");
    }
  }

  private KrlInterpreter interpreter(Interpreter kind) {
    return kind == Interpreter.ROBOT ? robot : submit;
  }

  /**
   * Starts the selected program or lets it go on.
   *
   * @param kind which interpreter
   * @param external whether the higher-level controller starts it and not the pendant
   */
  public void start(Interpreter kind, boolean external) {
    change(() -> startLocked(kind, external));
  }

  private void startLocked(Interpreter kind, boolean external) {
    if (failure != null) {
      throw new IllegalStateException("start: the simulation has failed: " + failure, failure);
    }
    KrlInterpreter interpreter = interpreter(kind);
    if (interpreter.state() == ProgramState.FREE) {
      throw new IllegalStateException("start: no program is selected");
    }
    requireIdle(interpreter, "start");
    if (kind == Interpreter.ROBOT) {
      if (external != (mode == OperatingMode.EXT)) {
        throw new IllegalStateException(
            external
                ? "start: the external start works in EXT only, the mode is " + mode
                : "start: in EXT only the external start works");
      }
      if (emergency) {
        throw new IllegalStateException("start: the emergency stop is pressed");
      }
      if (messages.stop()) {
        throw new IllegalStateException("start: a message has to be confirmed first");
      }
      if (manual != Manual.NOTHING) {
        throw new IllegalStateException("start: the robot is moved without a program");
      }
    }
    interpreter.start();
  }

  /**
   * Stops the program; the robot slows down on its path.
   *
   * @param kind which interpreter
   */
  public void stop(Interpreter kind) {
    change(
        () -> {
          interpreter(kind).stop();
          if (kind == Interpreter.ROBOT) {
            endManual();
          }
        });
  }

  /**
   * Sets the program back to its beginning.
   *
   * @param kind which interpreter
   */
  public void reset(Interpreter kind) {
    change(
        () -> {
          KrlInterpreter interpreter = interpreter(kind);
          interpreter.stop();
          if (!interpreter.reset()) {
            throw new IllegalStateException("reset: no program is selected");
          }
          if (kind == Interpreter.ROBOT) {
            motions.discardAll();
          }
        });
  }

  /**
   * Takes the program away.
   *
   * @param kind which interpreter
   */
  public void cancel(Interpreter kind) {
    change(
        () -> {
          KrlInterpreter interpreter = interpreter(kind);
          interpreter.stop();
          interpreter.cancel();
          if (kind == Interpreter.ROBOT) {
            motions.discardAll();
          }
        });
  }

  /**
   * Gives the state of an interpreter.
   *
   * @param kind which
   * @return what {@code $PRO_STATE} tells
   */
  public ProgramState state(Interpreter kind) {
    return locked(() -> interpreter(kind).state());
  }

  /**
   * Names the selected program.
   *
   * @param kind which interpreter
   * @return the name of its module; nothing if none is selected
   */
  public Optional<String> program(Interpreter kind) {
    return locked(() -> interpreter(kind).program().map(program -> program.name()));
  }

  /**
   * Gives the place of the program pointer.
   *
   * @param kind which interpreter
   * @return the innermost call first
   */
  public List<KrlInterpreter.Level> levels(Interpreter kind) {
    return locked(() -> interpreter(kind).levels());
  }

  /**
   * Gives the operating mode.
   *
   * @return the mode
   */
  public OperatingMode mode() {
    return locked(() -> mode);
  }

  /**
   * Turns the key switch. A program that runs is stopped.
   *
   * @param newMode the mode
   */
  public void setMode(OperatingMode newMode) {
    change(
        () -> {
          if (newMode == mode) {
            return;
          }
          if (robot.stop()) {
            messages.add(
                Message.Kind.NOTIFICATION,
                MessageWindow.MODE_CHANGED,
                "the operating mode was changed from " + mode + " to " + newMode,
                time);
          }
          endManual();
          mode = newMode;
          if (mode == OperatingMode.T2 && access.bool(T2_OV_REDUCE, false)) {
            int reduced = (int) Math.min(OVERRIDE_IN_T2, access.number(OV_PRO, PERCENT));
            access.write(OV_PRO, new KrlInt(reduced));
          }
        });
  }

  /**
   * Presses or releases the emergency stop.
   *
   * @param pressed whether it is pressed
   */
  public void emergencyStop(boolean pressed) {
    change(
        () -> {
          if (pressed && !emergency) {
            robot.stop();
            endManual();
            messages.add(
                Message.Kind.ACKNOWLEDGEMENT, MessageWindow.EMERGENCY_STOP, "emergency stop", time);
          }
          emergency = pressed;
        });
  }

  /**
   * Gives the messages.
   *
   * @return the last 1000, the oldest first
   */
  public List<Message> messages() {
    return locked(messages::list);
  }

  /**
   * Confirms all messages.
   *
   * @return how many had to be
   */
  public int confirmAll() {
    return locked(
        () -> {
          int confirmed = messages.confirm();
          publish();
          return confirmed;
        });
  }

  /**
   * Puts the robot somewhere, at once.
   *
   * @param axes where
   */
  public void place(Axes axes) {
    change(
        () -> {
          requireIdle(robot, "place");
          motions.readLimits();
          List<Integer> outside = motions.model().axesOutsideLimits(axes);
          if (!outside.isEmpty()) {
            throw new IllegalArgumentException(
                "place: A"
                    + (outside.get(0) + 1)
                    + " must be within its software limits, would be "
                    + axes.get(outside.get(0)));
          }
          motions.place(axes);
        });
  }

  /**
   * Gives where the robot stands.
   *
   * @return the commanded axis angles
   */
  public Axes axes() {
    return locked(() -> motions.system().axes());
  }

  /**
   * Says whether the robot stands.
   *
   * @return whether no axis moves
   */
  public boolean standing() {
    return locked(() -> motions.system().standing());
  }

  /**
   * Gives the robot.
   *
   * @return the model with the software limits of the controller
   */
  public RobotModel model() {
    return locked(
        () -> {
          motions.readLimits();
          return motions.model();
        });
  }

  /**
   * Gives the simulated time.
   *
   * @return ms since the start
   */
  public long time() {
    return time;
  }

  /**
   * Says whether anything happens by itself.
   *
   * @return whether a program runs or the robot moves
   */
  public boolean busy() {
    return locked(
        () ->
            robot.state() == ProgramState.ACTIVE
                || submit.state() == ProgramState.ACTIVE
                || manual != Manual.NOTHING
                || !motions.system().standing());
  }

  /**
   * Lets time pass.
   *
   * @param limit how much simulated time at most; rounded up to whole cycles
   * @param done is asked before each cycle
   * @return whether it was done in time
   */
  public boolean run(Duration limit, BooleanSupplier done) {
    Duration cycle = Duration.ofMillis(CYCLE_MILLIS);
    long cycles = limit.dividedBy(cycle);
    cycles += limit.compareTo(cycle.multipliedBy(cycles)) > 0 ? 1 : 0;
    while (!done.getAsBoolean()) {
      if (cycles-- <= 0) {
        return false;
      }
      if (closed) {
        throw new IllegalStateException("step: the server is closed");
      }
      cycle();
    }
    return true;
  }

  /** Ends a {@link #run} that is under way on another thread. */
  public void close() {
    closed = true;
  }

  // motions without a program, as C3 Bridge's messages 11 and 12 ask for them

  /**
   * Moves the robot without a program: after the motions that were asked for before, exactly to the
   * end.
   *
   * @param kind the kind of motion; not a circle
   * @param target a Cartesian or an axis position, or for a relative motion a difference
   * @throws KrlExecutionException if the robot cannot go there
   * @throws IllegalStateException if the state of the controller does not allow it
   */
  public void move(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    lock.lock();
    try {
      requireReleased("move");
      if (manual == Manual.JOG) {
        throw new IllegalStateException("move: a jog key is pressed");
      }
      moveLocked(Manual.MOTION, kind, target);
    } finally {
      lock.unlock();
    }
  }

  /**
   * Moves the robot until {@link #releaseJog}: in T1 and T2, with {@code $OV_JOG}, at most to the
   * end of its reach.
   *
   * @param kind PTP to an axis position far away, or LIN_REL by a difference far out
   * @param target the position
   * @throws KrlExecutionException if the robot cannot go there at all
   * @throws IllegalStateException if the state of the controller does not allow it
   */
  public void jog(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    lock.lock();
    try {
      requireReleased("jog");
      if (!mode.manual()) {
        throw new IllegalStateException("jog: the operating mode must be T1 or T2, is " + mode);
      }
      endManual();
      moveLocked(Manual.JOG, kind, target);
    } finally {
      lock.unlock();
    }
  }

  /** Slows down a robot that is jogged. */
  public void releaseJog() {
    change(
        () -> {
          if (manual == Manual.JOG) {
            endManual();
          }
        });
  }

  private void moveLocked(Manual why, MotionKind kind, KrlStruct target)
      throws KrlExecutionException {
    MotionOrder order =
        new MotionOrder(
            kind,
            null,
            target,
            OptionalDouble.empty(),
            Set.of(),
            null,
            "",
            "",
            new Position(kind.name(), 1, 1),
            List.of());
    motions.move(order);
    manual = why;
    publish();
  }

  private void requireReleased(String what) {
    requireIdle(robot, what);
    if (emergency) {
      throw new IllegalStateException(what + ": the emergency stop is pressed");
    }
    if (messages.stop()) {
      throw new IllegalStateException(what + ": a message has to be confirmed first");
    }
    boolean within = !motions.idle();
    if (robot.state() == ProgramState.STOP && manual == Manual.NOTHING && within) {
      throw new IllegalStateException(
          what + ": a program is stopped within a motion, reset or cancel it first");
    }
  }

  private void endManual() {
    if (manual != Manual.NOTHING) {
      motions.discardAll();
      manual = Manual.NOTHING;
    }
  }

  // the cycle

  /** Lets one cycle pass. */
  public void cycle() {
    lock.lock();
    try {
      advanceTime();
      timers.advance(time, CYCLE_MILLIS);
      submit.run(SUBMIT_INSTRUCTIONS);
      motions.settle(robot.state() == ProgramState.ACTIVE || manual != Manual.NOTHING);
      robot.run(ROBOT_INSTRUCTIONS);
      motions.cycle(time, override(), released(), speedLimit());
      if (motions.finished()) {
        manual = Manual.NOTHING;
      }
      publish();
    } catch (RuntimeException e) {
      fail(e);
      throw e;
    } finally {
      lock.unlock();
    }
  }

  /** An error of the simulation itself: it says so once, and starts nothing any more. */
  private void fail(RuntimeException error) {
    if (failure == null) {
      failure = error;
      submit.stop();
      stopFor(MessageWindow.FAILED, "the simulation has failed: " + error);
      publish();
    }
  }

  /** Only here, under the lock; others only read the time. */
  @SuppressWarnings("NonAtomicVolatileUpdate")
  private void advanceTime() {
    time += CYCLE_MILLIS;
  }

  private boolean released() {
    return !emergency && (robot.state() == ProgramState.ACTIVE || manual != Manual.NOTHING);
  }

  private double override() {
    VariablePath set = manual == Manual.JOG ? OV_JOG : OV_PRO;
    double program = Math.max(0, Math.min(1, access.number(set, PERCENT) / PERCENT));
    boolean reduced = mode == OperatingMode.T1 && isPointToPoint();
    // krl.md 2.2: the reduction of PTP motions in T1
    return reduced ? program * Math.min(1, access.number(RED_T1, PERCENT) / PERCENT) : program;
  }

  private boolean isPointToPoint() {
    return motions.system().current().map(current -> current instanceof PointToPoint).orElse(true);
  }

  /** krl.md 2.2: the limits of T1 for TCP and flange, and on a path for the axes, too. */
  private SpeedLimit speedLimit() {
    if (mode != OperatingMode.T1) {
      return SpeedLimit.NONE;
    }
    double most = access.number(VEL_LIMIT_T1, Double.POSITIVE_INFINITY);
    if (isPointToPoint()) {
      return new SpeedLimit(most, SpeedLimit.NONE.axes());
    }
    return new SpeedLimit(
        Math.min(most, access.number(VEL_CP_T1, most)), access.axes("$VEL_CPT1_MA", PERCENT));
  }

  private void stopFor(int number, String text) {
    robot.stop();
    messages.add(Message.Kind.ACKNOWLEDGEMENT, number, text, time);
    variables.error(number, Interpreter.ROBOT);
  }

  private void publish() {
    variables.publish(state());
  }

  private SystemVariables.State state() {
    Interpolator motion = motions.system();
    return new SystemVariables.State(
        motion.axes(),
        motion.axisVelocity(),
        motion.pathVelocity(),
        motion.standing(),
        motion.planned(),
        motion.distanceToEnd(),
        mode,
        emergency,
        messages.stop(),
        motions.idle());
  }

  /** Shows what the robot does. */
  private final class MotionListener implements AdvanceRun.Listener {
    @Override
    public void failed(int number, String text) {
      boolean jogged = manual == Manual.JOG;
      endManual();
      // who jogs to the end of the reach sees that the robot stands
      if (!jogged) {
        stopFor(number, text);
      }
    }

    @Override
    public void started(Axes from, Axes to, Frame base, Frame tool) {
      variables.started(from, to, base, tool);
    }

    @Override
    public void leftPath(Axes axes) {
      variables.leftPath(axes);
    }
  }

  // what the interpreters ask for

  /** What both interpreters ask for. */
  private abstract class CommonEnvironment implements ProgramEnvironment {
    @Override
    public long time() {
      return time;
    }

    abstract Interpreter kind();

    @Override
    public void pulse(int output, boolean level, double seconds) throws KrlExecutionException {
      if (!(seconds > 0)) {
        throw new KrlExecutionException(
            KrlExecutionException.OUT_OF_RANGE,
            "a pulse takes more than 0 s, was given " + seconds);
      }
      if (!timers.pulse(output, level, time + Math.round(seconds * 1000))) {
        throw new KrlExecutionException(
            KrlExecutionException.BAD_INDEX, "there is no $OUT[" + output + "]");
      }
    }

    @Override
    public Optional<KrlStruct> forward(KrlStruct axes) {
      Axes position = PositionValues.toAxes(axes, motions.system().axes());
      Frame tcp =
          motions
              .planner()
              .base()
              .inverse()
              .times(motions.model().forward(position))
              .times(motions.planner().tool());
      return Optional.of(
          PositionValues.e6Pos(
              tcp, motions.model().status(position), motions.model().turn(position)));
    }

    @Override
    public Optional<KrlStruct> inverse(KrlStruct position, KrlStruct start) {
      try {
        return Optional.of(
            PositionValues.e6Axis(
                motions
                    .planner()
                    .inverse(position, PositionValues.toAxes(start, motions.system().axes()))));
      } catch (UnreachableException e) {
        return Optional.empty();
      }
    }

    @Override
    public void fault(KrlExecutionException fault, Position position) {
      messages.add(
          Message.Kind.ACKNOWLEDGEMENT, fault.number(), position + ": " + fault.getMessage(), time);
      variables.error(fault.number(), kind());
    }
  }

  /** The robot interpreter's. */
  private final class RobotEnvironment extends CommonEnvironment {
    @Override
    public int advance() {
      return (int) Math.max(0, Math.min(MAX_ADVANCE, access.number(ADVANCE, 0)));
    }

    @Override
    Interpreter kind() {
      return Interpreter.ROBOT;
    }

    @Override
    public int motionsAhead() {
      return motions.ahead();
    }

    @Override
    public boolean motionFinished() {
      return motions.finished();
    }

    @Override
    public void move(MotionOrder order) throws KrlExecutionException {
      motions.move(order);
    }

    @Override
    public void holdMotion(boolean maximum) {
      motions.hold(maximum);
    }

    @Override
    public void releaseMotion() {
      motions.release();
    }

    @Override
    public void discardMotion(int holds) {
      motions.discard(holds);
    }
  }

  /** The submit interpreter's, which moves nothing. */
  private final class SubmitEnvironment extends CommonEnvironment {
    @Override
    Interpreter kind() {
      return Interpreter.SUBMIT;
    }

    @Override
    public int advance() {
      return 0;
    }

    @Override
    public int motionsAhead() {
      return 0;
    }

    @Override
    public boolean motionFinished() {
      return true;
    }

    @Override
    public void move(MotionOrder order) throws KrlExecutionException {
      throw new KrlExecutionException(
          KrlExecutionException.NOT_ALLOWED, "the submit interpreter cannot move the robot");
    }

    @Override
    public void holdMotion(boolean maximum) {}

    @Override
    public void releaseMotion() {}

    @Override
    public void discardMotion(int holds) {}
  }
}
