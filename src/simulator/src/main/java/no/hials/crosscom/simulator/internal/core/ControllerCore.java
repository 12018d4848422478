package no.hials.crosscom.simulator.internal.core;

import java.time.Duration;
import java.time.LocalDateTime;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Supplier;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.ProgramState;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.motion.Interpolator;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter;
import no.hials.crosscom.simulator.internal.program.LinkException;
import no.hials.crosscom.simulator.internal.program.ProgramLibrary;
import no.hials.crosscom.simulator.internal.program.TriggerOrder;
import org.jspecify.annotations.Nullable;

/**
 * The simulated controller but for its network: programs, motion, modes, messages and time.
 *
 * <p>Everything happens in cycles of 12 ms, one after the other: timers, submit interpreter, robot
 * interpreter, motion, system variables. One lock is held during a cycle and during every other
 * call. What clients read between two cycles is the state after the last.
 */
public final class ControllerCore {
  /** The interpolation cycle of a KR C4 (docs/reference/access-times.md#cycles), ms. */
  public static final int CYCLE_MILLIS = 12;

  /**
   * How many instructions the interpreters execute in a cycle. Assumed: the reference does not say
   * how fast they are; it keeps a loop without end from stopping everything else.
   */
  private static final int ROBOT_INSTRUCTIONS = 1000;

  private static final int SUBMIT_INSTRUCTIONS = 500;

  /** Fair, so that a clock without a limit lets others in between its cycles. */
  private final ReentrantLock lock = new ReentrantLock(true);

  private final ProgramLibrary library;
  private final KrlInterpreter robot;
  private final KrlInterpreter submit;
  private final OperatorPanel panel;
  private final ManualMotion manual;
  private final SpeedReduction speed;
  private final Timers timers;
  private final AdvanceRun motions;
  private final SystemVariables variables;
  private volatile long time;
  private volatile boolean closed;

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
    SystemVariableAccess access = new SystemVariableAccess(globals);
    library = new ProgramLibrary(globals, SystemVariables::stopsAdvanceRun);
    timers = new Timers(access);
    panel = new OperatorPanel(access, this::time);
    motions = new AdvanceRun(access, model, new Triggers(this::fire), new MotionListener());
    robot =
        new KrlInterpreter(
            Interpreter.ROBOT,
            new RobotEnvironment(access, this::time, timers, motions, this::failed));
    submit =
        new KrlInterpreter(
            Interpreter.SUBMIT, new SubmitEnvironment(this::time, timers, motions, this::failed));
    manual = new ManualMotion(robot, motions, panel);
    speed = new SpeedReduction(access, motions, panel, manual);
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

  static void requireIdle(KrlInterpreter interpreter, String what) {
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
      panel.requireStart(external);
      panel.requireReleased("start");
      if (manual.active()) {
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
            manual.end();
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
    return locked(panel::mode);
  }

  /**
   * Turns the key switch. A program that runs is stopped.
   *
   * @param newMode the mode
   */
  public void setMode(OperatingMode newMode) {
    change(() -> panel.setMode(newMode, this::stopRobot));
  }

  /**
   * Presses or releases the emergency stop.
   *
   * @param pressed whether it is pressed
   */
  public void emergencyStop(boolean pressed) {
    change(() -> panel.emergencyStop(pressed, this::stopRobot));
  }

  private boolean stopRobot() {
    boolean running = robot.stop();
    manual.end();
    return running;
  }

  /**
   * Gives the messages.
   *
   * @return the last 1000, the oldest first
   */
  public List<Message> messages() {
    return locked(panel::messages);
  }

  /**
   * Confirms all messages.
   *
   * @return how many had to be
   */
  public int confirmAll() {
    return locked(
        () -> {
          int confirmed = panel.confirmAll();
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
    return locked(() -> motions.interpolator().axes());
  }

  /**
   * Says whether the robot stands.
   *
   * @return whether no axis moves
   */
  public boolean standing() {
    return locked(() -> motions.interpolator().standing());
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
                || manual.active()
                || !motions.interpolator().standing());
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
      manual.move(kind, target);
      publish();
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
      manual.jog(kind, target);
      publish();
    } finally {
      lock.unlock();
    }
  }

  /** Slows down a robot that is jogged. */
  public void releaseJog() {
    change(
        () -> {
          if (manual.jogging()) {
            manual.end();
          }
        });
  }

  // the cycle

  /** Lets one cycle pass. */
  public void cycle() {
    lock.lock();
    try {
      advanceTime();
      timers.advance(time, CYCLE_MILLIS);
      submit.run(SUBMIT_INSTRUCTIONS);
      motions.settle(robot.state() == ProgramState.ACTIVE || manual.active());
      robot.run(ROBOT_INSTRUCTIONS);
      motions.cycle(time, speed.override(), released(), speed.limit());
      manual.cycle();
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
    return !panel.emergency() && (robot.state() == ProgramState.ACTIVE || manual.active());
  }

  private void stopFor(int number, String text) {
    robot.stop();
    panel.show(Message.Kind.ACKNOWLEDGEMENT, number, text);
    variables.error(number, Interpreter.ROBOT);
  }

  private void failed(Interpreter kind, KrlExecutionException fault, Position position) {
    panel.show(Message.Kind.ACKNOWLEDGEMENT, fault.number(), position + ": " + fault.getMessage());
    variables.error(fault.number(), kind);
  }

  private void fire(TriggerOrder order) {
    robot.fire(order);
  }

  private void publish() {
    variables.publish(state());
  }

  private SystemVariables.State state() {
    Interpolator motion = motions.interpolator();
    return new SystemVariables.State(
        motion.axes(),
        motion.axisVelocity(),
        motion.pathVelocity(),
        motion.standing(),
        motion.planned(),
        motion.distanceToEnd(),
        panel.mode(),
        panel.emergency(),
        panel.stopMessage(),
        motions.idle());
  }

  /** Shows what the robot does. */
  private final class MotionListener implements AdvanceRun.Listener {
    @Override
    public void failed(int number, String text) {
      boolean jogged = manual.jogging();
      manual.end();
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
}
