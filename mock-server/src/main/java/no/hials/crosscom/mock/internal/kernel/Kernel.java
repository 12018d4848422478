package no.hials.crosscom.mock.internal.kernel;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Supplier;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.kinematics.UnreachableException;
import no.hials.crosscom.mock.Message;
import no.hials.crosscom.mock.OperatingMode;
import no.hials.crosscom.mock.internal.data.Path;
import no.hials.crosscom.mock.internal.data.Scope;
import no.hials.crosscom.mock.internal.motion.Motion;
import no.hials.crosscom.mock.internal.motion.MotionEvent;
import no.hials.crosscom.mock.internal.motion.MotionRefusedException;
import no.hials.crosscom.mock.internal.motion.MotionSystem;
import no.hials.crosscom.mock.internal.motion.PointToPoint;
import no.hials.crosscom.mock.internal.motion.Problem;
import no.hials.crosscom.mock.internal.motion.Suspended;
import no.hials.crosscom.mock.internal.program.Environment;
import no.hials.crosscom.mock.internal.program.Interpreter;
import no.hials.crosscom.mock.internal.program.LinkException;
import no.hials.crosscom.mock.internal.program.MotionOrder;
import no.hials.crosscom.mock.internal.program.ProgramFault;
import no.hials.crosscom.mock.internal.program.ProgramLibrary;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * The simulated controller but for its network: programs, motion, modes, messages and time.
 *
 * <p>Everything happens in cycles of 12 ms, one after the other: timers, submit interpreter, robot
 * interpreter, motion, system variables. One lock is held during a cycle and during every other
 * call. What clients read between two cycles is the state after the last.
 */
public final class Kernel {
  /** The interpolation cycle of a KR C4 (krl.md 5: RSI's IPO cycle), ms. */
  public static final int CYCLE_MILLIS = 12;

  private static final double CYCLE_SECONDS = CYCLE_MILLIS / 1000.0;

  /**
   * How many instructions the interpreters execute in a cycle. Assumed: the reference does not say
   * how fast they are; it keeps a loop without end from stopping everything else.
   */
  private static final int ROBOT_INSTRUCTIONS = 1000;

  private static final int SUBMIT_INSTRUCTIONS = 500;

  private static final double PERCENT = 100;
  private static final Path OV_PRO = Machine.path("$OV_PRO");
  private static final Path ADVANCE = Machine.path("$ADVANCE");
  private static final Path RED_T1 = Machine.path("$RED_T1");
  private static final Path VEL_CP_T1 = Machine.path("$VEL_CP_T1");
  private static final int MAX_ADVANCE = 5;

  private final ReentrantLock lock = new ReentrantLock(true);
  private final Machine machine;
  private final RobotModel model;
  private final ProgramLibrary library;
  private final Interpreter robot;
  private final Interpreter submit;
  private final Messages messages = new Messages();
  private final Timers timers;
  private final Triggers triggers;
  private final Planner planner;
  private MotionSystem motion;
  private final SystemVariables variables;

  /** Motions that were handed over and have not ended. */
  private final Map<Long, MotionOrder> orders = new HashMap<>();

  /** The plans that interrupts have put aside, the last one first. */
  private final Deque<Suspended> aside = new ArrayDeque<>();

  /** Motions that were handed over while the robot still slows down for something else. */
  private final List<MotionOrder> waiting = new ArrayList<>();

  private volatile long time;
  private OperatingMode mode = OperatingMode.T1;
  private boolean emergency;

  /** What happens to the plan as soon as the robot stands. */
  private Settling settling = Settling.NOTHING;

  private enum Settling {
    NOTHING,
    PUT_ASIDE,
    FORGET
  }

  /**
   * Makes a controller that stands where {@code $AXIS_ACT} says.
   *
   * @param globals the variables that clients see
   * @param robot the robot; its software limits are replaced by {@code $SOFTN_END} and {@code
   *     $SOFTP_END}
   */
  public Kernel(Scope globals, RobotModel robot) {
    machine = new Machine(globals);
    model = limited(robot);
    Axes start = machine.position(Machine.path("$AXIS_ACT"), robot.home());
    library = new ProgramLibrary(globals, SystemVariables::stopsAdvanceRun);
    this.robot = new Interpreter(Interpreter.Kind.ROBOT, new RobotEnvironment());
    submit = new Interpreter(Interpreter.Kind.SUBMIT, new SubmitEnvironment());
    timers = new Timers(machine);
    triggers = new Triggers(this.robot::fire);
    planner = new Planner(machine, model, start);
    motion = new MotionSystem(model, start);
    variables = new SystemVariables(globals, machine, model, this.robot, submit, state());
    publish();
    variables.bind(() -> time);
  }

  private RobotModel limited(RobotModel robot) {
    Axes low = robot.home();
    Axes high = robot.home();
    for (int i = 0; i < Values.ROBOT_AXES; i++) {
      low = low.with(i, machine.number(Path.element("$SOFTN_END", i + 1), robot.minimum(i)));
      high = high.with(i, machine.number(Path.element("$SOFTP_END", i + 1), robot.maximum(i)));
    }
    return robot.withLimits(low, high);
  }

  // calls from outside

  private <T> T locked(Supplier<T> work) {
    lock.lock();
    try {
      T result = work.get();
      publish();
      return result;
    } finally {
      lock.unlock();
    }
  }

  private void locked(Runnable work) {
    locked(
        () -> {
          work.run();
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
   * @throws ProgramFault if the arguments do not suit it
   */
  public void select(Interpreter.Kind kind, String name, List<KrlValue> arguments)
      throws LinkException, ProgramFault {
    lock.lock();
    try {
      Interpreter interpreter = interpreter(kind);
      requireIdle(interpreter, "select");
      interpreter.select(library.program(name), arguments);
      if (kind == Interpreter.Kind.ROBOT) {
        discard();
      }
      publish();
    } finally {
      lock.unlock();
    }
  }

  private static void requireIdle(Interpreter interpreter, String what) {
    if (interpreter.state() == Interpreter.State.ACTIVE) {
      throw new IllegalStateException(what + ": a program is active, stop it first");
    }
  }

  private Interpreter interpreter(Interpreter.Kind kind) {
    return kind == Interpreter.Kind.ROBOT ? robot : submit;
  }

  /**
   * Starts the selected program or lets it go on.
   *
   * @param kind which interpreter
   * @param external whether the higher-level controller starts it and not the pendant
   */
  public void start(Interpreter.Kind kind, boolean external) {
    locked(() -> startLocked(kind, external));
  }

  private void startLocked(Interpreter.Kind kind, boolean external) {
    Interpreter interpreter = interpreter(kind);
    if (interpreter.state() == Interpreter.State.FREE) {
      throw new IllegalStateException("start: no program is selected");
    }
    requireIdle(interpreter, "start");
    if (kind == Interpreter.Kind.ROBOT) {
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
    }
    interpreter.start();
  }

  /**
   * Stops the program; the robot slows down on its path.
   *
   * @param kind which interpreter
   */
  public void stop(Interpreter.Kind kind) {
    locked(
        () -> {
          interpreter(kind).stop();
        });
  }

  /**
   * Sets the program back to its beginning.
   *
   * @param kind which interpreter
   */
  public void reset(Interpreter.Kind kind) {
    locked(
        () -> {
          Interpreter interpreter = interpreter(kind);
          interpreter.stop();
          if (!interpreter.reset()) {
            throw new IllegalStateException("reset: no program is selected");
          }
          if (kind == Interpreter.Kind.ROBOT) {
            discard();
          }
        });
  }

  /**
   * Takes the program away.
   *
   * @param kind which interpreter
   */
  public void cancel(Interpreter.Kind kind) {
    locked(
        () -> {
          Interpreter interpreter = interpreter(kind);
          interpreter.stop();
          interpreter.cancel();
          if (kind == Interpreter.Kind.ROBOT) {
            discard();
          }
        });
  }

  /** Slows the robot down, and forgets all that is planned when it stands. */
  private void discard() {
    aside.clear();
    waiting.clear();
    triggers.clear();
    settling = Settling.FORGET;
    motion.cancel();
    settle();
  }

  /** Does what had to wait until the robot stands. */
  private void settle() {
    if (settling == Settling.NOTHING || !motion.standing()) {
      return;
    }
    if (settling == Settling.PUT_ASIDE) {
      aside.push(motion.suspend());
    } else if (aside.isEmpty()) {
      orders.clear();
    }
    settling = Settling.NOTHING;
    planner.startAt(motion.axes());
    for (MotionOrder order : List.copyOf(waiting)) {
      waiting.remove(0);
      try {
        take(order);
      } catch (ProgramFault e) {
        stopFor(e.number(), order.position() + ": " + e.getMessage());
        discard();
        return;
      }
    }
  }

  private void take(MotionOrder order) throws ProgramFault {
    Motion planned = planner.plan(order);
    try {
      motion.add(planned);
    } catch (MotionRefusedException e) {
      throw new ProgramFault(number(e.problem()), e.problem().message());
    }
    planner.startAt(motion.plannedEnd());
    orders.put(planned.id(), order);
    triggers.add(planned, order.triggers());
  }

  /**
   * Gives the state of an interpreter.
   *
   * @param kind which
   * @return what {@code $PRO_STATE} tells
   */
  public Interpreter.State state(Interpreter.Kind kind) {
    return locked(() -> interpreter(kind).state());
  }

  /**
   * Names the selected program.
   *
   * @param kind which interpreter
   * @return the name of its module; nothing if none is selected
   */
  public Optional<String> program(Interpreter.Kind kind) {
    return locked(() -> interpreter(kind).program().map(program -> program.name()));
  }

  /**
   * Gives the place of the program pointer.
   *
   * @param kind which interpreter
   * @return the innermost call first
   */
  public List<Interpreter.Level> levels(Interpreter.Kind kind) {
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
    locked(
        () -> {
          if (newMode != mode && robot.stop()) {
            messages.add(
                Message.Kind.NOTIFICATION,
                Messages.MODE_CHANGED,
                "the operating mode was changed from " + mode + " to " + newMode,
                time);
          }
          mode = newMode;
        });
  }

  /**
   * Presses or releases the emergency stop.
   *
   * @param pressed whether it is pressed
   */
  public void emergencyStop(boolean pressed) {
    locked(
        () -> {
          if (pressed && !emergency) {
            robot.stop();
            messages.add(
                Message.Kind.ACKNOWLEDGEMENT, Messages.EMERGENCY_STOP, "emergency stop", time);
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
    return locked(messages::confirm);
  }

  /**
   * Puts the robot somewhere, at once.
   *
   * @param axes where
   */
  public void place(Axes axes) {
    locked(
        () -> {
          requireIdle(robot, "place");
          motion = new MotionSystem(model, axes);
          discard();
        });
  }

  /**
   * Gives where the robot stands.
   *
   * @return the commanded axis angles
   */
  public Axes axes() {
    return locked(motion::axes);
  }

  /**
   * Says whether the robot stands.
   *
   * @return whether no axis moves
   */
  public boolean standing() {
    return locked(motion::standing);
  }

  /**
   * Gives the robot.
   *
   * @return the model with the software limits of the controller
   */
  public RobotModel model() {
    return model;
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
            robot.state() == Interpreter.State.ACTIVE
                || submit.state() == Interpreter.State.ACTIVE
                || !motion.standing());
  }

  /**
   * Lets time pass.
   *
   * @param limit how much simulated time at most; rounded up to whole cycles
   * @param done is asked before each cycle
   * @return whether it was done in time
   */
  public boolean run(Duration limit, BooleanSupplier done) {
    long end = time + limit.toMillis();
    while (!done.getAsBoolean()) {
      if (time >= end) {
        return false;
      }
      cycle();
    }
    return true;
  }

  // the cycle

  /** Lets one cycle pass. */
  public void cycle() {
    lock.lock();
    try {
      advanceTime();
      timers.advance(time, CYCLE_MILLIS);
      submit.run(SUBMIT_INSTRUCTIONS);
      settle();
      robot.run(ROBOT_INSTRUCTIONS);
      for (MotionEvent event : motion.cycle(override(), released())) {
        handle(event);
      }
      triggers.cycle(
          time,
          motion.current().map(Motion::id).orElse(0L),
          motion.distanceToEnd(),
          motion.pathVelocity(),
          CYCLE_SECONDS);
      publish();
    } finally {
      lock.unlock();
    }
  }

  /** Only here, under the lock; others only read the time. */
  @SuppressWarnings("NonAtomicVolatileUpdate")
  private void advanceTime() {
    time += CYCLE_MILLIS;
  }

  private boolean released() {
    return !emergency && robot.state() == Interpreter.State.ACTIVE;
  }

  private double override() {
    double program = Math.max(0, Math.min(1, machine.number(OV_PRO, PERCENT) / PERCENT));
    if (mode != OperatingMode.T1) {
      return program;
    }
    return program * motion.current().map(this::reductionInT1).orElse(1.0);
  }

  /** krl.md 2.2: $RED_T1 for PTP, $VEL_CP_T1 for the path. */
  private double reductionInT1(Motion current) {
    if (current instanceof PointToPoint) {
      return Math.min(1, machine.number(RED_T1, PERCENT) / PERCENT);
    }
    double programmed = Planner.pathVelocity(current);
    return Math.min(1, machine.number(VEL_CP_T1, programmed) / programmed);
  }

  private void handle(MotionEvent event) {
    Motion of = event.motion();
    if (event instanceof MotionEvent.Started) {
      variables.started(motion.currentStart(), motion.currentEnd());
      triggers.started(of, time);
    } else if (event instanceof MotionEvent.Passed) {
      triggers.passed(of, time);
      orders.remove(of.id());
    } else if (event instanceof MotionEvent.Faulted fault) {
      MotionOrder order = orders.get(of.id());
      String where = order == null ? "" : order.position() + ": ";
      stopFor(number(fault.problem()), where + fault.problem().message());
      discard();
    }
  }

  private static int number(Problem problem) {
    if (problem instanceof Problem.AxisLimit) {
      return Messages.SOFTWARE_LIMIT;
    }
    if (problem instanceof Problem.Singularity) {
      return Messages.SINGULARITY;
    }
    return problem instanceof Problem.OutOfReach ? Messages.WORK_ENVELOPE : Messages.BAD_MOTION;
  }

  private void stopFor(int number, String text) {
    robot.stop();
    messages.add(Message.Kind.ACKNOWLEDGEMENT, number, text, time);
    variables.error(number);
  }

  private void publish() {
    variables.publish(state());
  }

  private SystemVariables.State state() {
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
        motion.finished() && waiting.isEmpty() && aside.isEmpty());
  }

  // what the interpreters ask for

  /** What both interpreters ask for. */
  private abstract class CommonEnvironment implements Environment {
    @Override
    public long time() {
      return time;
    }

    @Override
    public void pulse(int output, boolean level, double seconds) throws ProgramFault {
      timers.pulse(output, level, time + Math.round(seconds * 1000));
    }

    @Override
    public Optional<KrlStruct> forward(KrlStruct axes) {
      Axes position = Values.toAxes(axes, motion.axes());
      Frame tcp = planner.base().inverse().times(model.forward(position)).times(planner.tool());
      return Optional.of(Values.e6Pos(tcp, model.status(position), model.turn(position)));
    }

    @Override
    public Optional<KrlStruct> inverse(KrlStruct position, KrlStruct start) {
      try {
        return Optional.of(
            Values.e6Axis(planner.inverse(position, Values.toAxes(start, motion.axes()))));
      } catch (UnreachableException e) {
        return Optional.empty();
      }
    }

    @Override
    public void message(no.hials.crosscom.mock.internal.program.Message message) {
      messages.add(
          Message.Kind.valueOf(message.kind().name()),
          message.number(),
          message.position() + ": " + message.text(),
          time);
      if (message.kind() == no.hials.crosscom.mock.internal.program.Message.Kind.ACKNOWLEDGEMENT) {
        variables.error(message.number());
      }
    }
  }

  /** The robot interpreter's. */
  private final class RobotEnvironment extends CommonEnvironment {
    @Override
    public int advance() {
      return (int) Math.max(0, Math.min(MAX_ADVANCE, machine.number(ADVANCE, 0)));
    }

    @Override
    public int motionsAhead() {
      return motion.planned() + waiting.size();
    }

    @Override
    public boolean motionFinished() {
      return settling == Settling.NOTHING && waiting.isEmpty() && motion.finished();
    }

    @Override
    public void move(MotionOrder order) throws ProgramFault {
      if (settling == Settling.NOTHING) {
        take(order);
      } else {
        waiting.add(order);
      }
    }

    @Override
    public void holdMotion(boolean maximum) {
      settling = Settling.PUT_ASIDE;
      motion.brake(maximum);
    }

    @Override
    public void releaseMotion() {
      motion.resume(aside.pop(), planner.axisRates());
      planner.startAt(motion.plannedEnd());
    }

    @Override
    public void discardMotion(int holds) {
      waiting.clear();
      triggers.clear();
      for (int i = 0; i < holds; i++) {
        aside.pop();
      }
      settling = Settling.FORGET;
      motion.cancel();
    }
  }

  /** The submit interpreter's, which moves nothing. */
  private final class SubmitEnvironment extends CommonEnvironment {
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
    public void move(MotionOrder order) throws ProgramFault {
      throw new ProgramFault(
          ProgramFault.NOT_ALLOWED, "the submit interpreter cannot move the robot");
    }

    @Override
    public void holdMotion(boolean maximum) {}

    @Override
    public void releaseMotion() {}

    @Override
    public void discardMotion(int holds) {}
  }
}
