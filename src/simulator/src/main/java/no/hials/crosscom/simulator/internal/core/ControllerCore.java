package no.hials.crosscom.simulator.internal.core;

import java.time.Duration;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Supplier;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.JogCoordinates;
import no.hials.crosscom.simulator.KrlExecutionException;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.Message;
import no.hials.crosscom.simulator.MotionTarget;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.motion.Interpolator;
import no.hials.crosscom.simulator.internal.motion.Joints;
import no.hials.crosscom.simulator.internal.program.KrlInterpreter;
import no.hials.crosscom.simulator.internal.program.MotionOrder;
import no.hials.crosscom.simulator.internal.program.ProgramLibrary;
import no.hials.crosscom.simulator.internal.program.TriggerOrder;
import org.jspecify.annotations.Nullable;

/**
 * Connects the parts of the simulated controller: programs, motion, modes, messages and time.
 *
 * <p>Everything happens in cycles of 12 ms, one after the other: timers, submit interpreter, robot
 * interpreter, motion, system variables. One lock is held during a cycle and during every other
 * call. Clients that read between two cycles see the state after the last. The class is long,
 * because all of these calls work under its one lock.
 */
public final class ControllerCore {
  /**
   * The cycle in ms: the interpolation cycle of a KR C4 (docs/reference/access-times.md#cycles).
   */
  public static final int CYCLE_MILLIS = 12;

  /**
   * The maximum number of instructions that an interpreter executes in a cycle, so that an endless
   * loop does not stop everything else. Assumed: the speed of the real interpreters is not known.
   */
  private static final int ROBOT_INSTRUCTIONS = 1000;

  private static final int SUBMIT_INSTRUCTIONS = 500;

  /** Fair, so that a clock without a limit lets other threads in between its cycles. */
  private final ReentrantLock lock = new ReentrantLock(true);

  private final ProgramLibrary library;
  private final KrlInterpreter robot;
  private final KrlInterpreter submit;
  private final OperatorPanel panel;
  private final ManualMotion manual;
  private final AutomaticExternal external;
  private final BlockCoincidence coincidence;
  private final SpeedReduction speed;
  private final Timers timers;
  private final MotorLoad motors = new MotorLoad();
  private final AdvanceRun motions;
  private final SystemVariables variables;
  private final List<MotionTarget> started = new ArrayList<>();
  private final RobotChanger robots;
  private volatile long time;
  private volatile boolean closed;

  /** An error in the simulation itself; nothing moves after it. */
  private @Nullable Throwable failure;

  private boolean failureShown;

  /**
   * Creates a controller whose robot is at {@code $AXIS_ACT}.
   *
   * @param globals the variables that clients see
   * @param model the robot; its software limits are replaced by {@code $SOFTN_END} and {@code
   *     $SOFTP_END}
   * @param begin the first value of {@code $DATE}
   */
  public ControllerCore(Scope globals, RobotModel model, LocalDateTime begin) {
    SystemVariableAccess access = new SystemVariableAccess(globals);
    library = new ProgramLibrary(globals, SystemVariables::stopsAdvanceRun);
    timers = new Timers(access);
    panel = new OperatorPanel(access, this::time);
    motions =
        new AdvanceRun(
            access,
            model,
            new Triggers(this::fire),
            new PathStops(this::isTrue),
            new MotionListener());
    robot = interpreter(Interpreter.ROBOT, access);
    submit = interpreter(Interpreter.SUBMIT, access);
    manual = new ManualMotion(robot, motions, panel);
    external = new AutomaticExternal(access, new PlcActions());
    coincidence = new BlockCoincidence(robot, motions, panel, new StepModeVariable(access));
    speed = new SpeedReduction(access, motions, panel, manual, coincidence);
    variables = new SystemVariables(globals, access, model, robot, submit, state());
    robots = new RobotChanger(access, motions, variables, panel);
    publish();
    variables.bind(() -> time, begin);
  }

  private KrlInterpreter interpreter(Interpreter kind, SystemVariableAccess access) {
    return new KrlInterpreter(
        kind,
        new InterpreterEnvironment(
            kind,
            access,
            this::time,
            timers,
            motions,
            this::coincidence,
            panel.programs(),
            this::showError,
            this::failed));
  }

  /** Returns the BCO run, which is created after the interpreters. */
  private BlockCoincidence coincidence() {
    return coincidence;
  }

  // calls from outside

  private <T> T locked(Supplier<T> work) {
    lock.lock();
    try {
      return work.get();
    } finally {
      lock.unlock();
    }
  }

  private interface Change<E extends Exception> {
    void run() throws E;
  }

  /** Changes the state and publishes it in the variables. */
  private <E extends Exception> void change(Change<E> work) throws E {
    lock.lock();
    try {
      work.run();
      publish();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Replaces the robot after its machine data were loaded, and puts one that has not moved yet at
   * its home position. If they describe no robot that can be simulated, a message says why, and the
   * robot stays, with the data that it had.
   *
   * @return the reasons for which data are not used
   */
  public List<RobotData.UnusedData> loaded(RobotData data) {
    List<RobotData.UnusedData> refusals = new ArrayList<>();
    if (data.isMachineData() || data.isHome()) {
      change(() -> refusals.addAll(robots.loaded(data, robot.state() == ProgramState.ACTIVE)));
    }
    return refusals;
  }

  /** Runs work on the loaded modules under the lock. */
  public <T> T withLibrary(Function<ProgramLibrary, T> work) {
    return locked(() -> work.apply(library));
  }

  public void select(Interpreter kind, String name, List<KrlValue> arguments)
      throws KrlFileException, KrlExecutionException {
    lock.lock();
    try {
      KrlInterpreter interpreter = interpreter(kind);
      requireIdle(interpreter, "select");
      interpreter.select(library.program(name), arguments);
      if (kind == Interpreter.ROBOT) {
        motions.discardAll();
        coincidence.require();
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
   * Starts the selected program or continues it.
   *
   * @param external whether the higher-level controller starts it, not the pendant
   */
  public void start(Interpreter kind, boolean external) {
    change(() -> startLocked(kind, external, false));
  }

  /** Starts the robot's program and presses Start again at the end of its BCO run. */
  public void runRobot(boolean external) {
    change(() -> startLocked(Interpreter.ROBOT, external, true));
  }

  private void startLocked(Interpreter kind, boolean external, boolean pressAgain) {
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
      if (interpreter.state() == ProgramState.END) {
        coincidence.require();
      }
      coincidence.started(pressAgain);
    }
    interpreter.start();
  }

  public void stop(Interpreter kind) {
    change(
        () -> {
          interpreter(kind).stop();
          if (kind == Interpreter.ROBOT) {
            manual.end();
          }
        });
  }

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
            coincidence.require();
          }
        });
  }

  public void cancel(Interpreter kind) {
    change(
        () -> {
          KrlInterpreter interpreter = interpreter(kind);
          interpreter.stop();
          interpreter.cancel();
          if (kind == Interpreter.ROBOT) {
            motions.discardAll();
            coincidence.forget();
          }
        });
  }

  public ProgramState state(Interpreter kind) {
    return locked(() -> interpreter(kind).state());
  }

  public Optional<String> program(Interpreter kind) {
    return locked(() -> interpreter(kind).program().map(program -> program.name()));
  }

  /** Returns the calls of the selected program, the innermost first. */
  public List<KrlInterpreter.Level> levels(Interpreter kind) {
    return locked(() -> interpreter(kind).levels());
  }

  /** Sets whether the first motion of a program is a BCO run. */
  public void simulateBco(boolean simulated) {
    change(() -> coincidence.simulate(simulated));
  }

  /** Sets the pointer of the robot's program to a line. */
  public void selectLine(int line) {
    change(
        () -> {
          requireIdle(robot, "select a line");
          robot.selectLine(line);
          motions.discardAll();
          coincidence.require();
        });
  }

  public OperatingMode mode() {
    return locked(panel::mode);
  }

  public void setMode(OperatingMode newMode) {
    change(() -> panel.setMode(newMode, this::stopRobot));
  }

  public void emergencyStop(boolean pressed) {
    change(() -> panel.emergencyStop(pressed, this::stopRobot));
  }

  private boolean stopRobot() {
    boolean running = robot.stop();
    manual.end();
    return running;
  }

  public List<Message> messages() {
    return locked(panel::messages);
  }

  public Optional<Message> dialogue() {
    return locked(panel::dialogue);
  }

  public void answer(int key) {
    change(() -> panel.answer(key));
  }

  public void answer(Message dialogue, int key) {
    change(() -> panel.answer(dialogue, key));
  }

  public int confirmAll() {
    return locked(
        () -> {
          int confirmed = panel.confirmAll();
          publish();
          return confirmed;
        });
  }

  public void place(Axis axes) {
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
          motions.place(new Joints(axes, motions.interpolator().joints().external()));
        });
  }

  public Axis axes() {
    return locked(() -> motions.interpolator().axes());
  }

  public boolean waitsForCondition(Interpreter kind) {
    return locked(() -> interpreter(kind).waitsForCondition());
  }

  public boolean standing() {
    return locked(() -> motions.interpolator().standing());
  }

  /** Returns the targets of the motions that have started in the last cycle. */
  public List<MotionTarget> startedMotions() {
    return locked(() -> List.copyOf(started));
  }

  /** Returns the robot with the controller's software limits. */
  public RobotModel model() {
    return locked(
        () -> {
          motions.readLimits();
          return motions.model();
        });
  }

  /** Returns the simulated time in ms since the start. */
  public long time() {
    return time;
  }

  /** Returns whether a program runs or the robot moves. */
  public boolean busy() {
    return locked(
        () ->
            robot.state() == ProgramState.ACTIVE
                || submit.state() == ProgramState.ACTIVE
                || manual.active()
                || !motions.interpolator().standing());
  }

  /**
   * Runs cycles until a condition is true.
   *
   * @param limit the maximum simulated time; rounded up to whole cycles
   * @param done called before each cycle
   * @return whether it became true within the limit
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
        throw new IllegalStateException("step: the controller is closed");
      }
      cycle();
    }
    return true;
  }

  /** Ends a {@link #run} on another thread. */
  public void close() {
    closed = true;
  }

  // motions without a program

  public void move(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    change(() -> manual.move(kind, target));
  }

  public void jog(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    change(() -> manual.jog(kind, target));
  }

  /** Jogs in a direction: 1 to 6 for A1 to A6 or X, Y, Z, A, B and C, 7 to 12 for E1 to E6. */
  public void jog(JogCoordinates coordinates, int number, boolean positive)
      throws KrlExecutionException {
    change(() -> manual.jog(coordinates, number, positive));
  }

  public void releaseJog() {
    change(
        () -> {
          if (manual.jogging()) {
            manual.end();
          }
        });
  }

  // the cycle

  public void cycle() {
    lock.lock();
    try {
      showFailure();
      started.clear();
      advanceTime();
      timers.advance(time, CYCLE_MILLIS);
      external.cycle(panel.mode());
      submit.run(SUBMIT_INSTRUCTIONS);
      motions.settle(robot.state() == ProgramState.ACTIVE || manual.active());
      coincidence.prepare();
      robot.run(ROBOT_INSTRUCTIONS, coincidence.lineStep());
      if (motions.cycle(time, speed.override(), released(), speed.limit())) {
        robot.runTriggers(ROBOT_INSTRUCTIONS);
      }
      motors.cycle(motions.interpolator().axisVelocity(), motions.model(), Interpolator.CYCLE);
      manual.cycle();
      coincidence.cycle();
      publish();
    } catch (RuntimeException e) {
      failure = failure == null ? e : failure;
      showFailure();
      throw e;
    } catch (VirtualMachineError e) {
      // there may be no memory for the message: the next cycle shows it, before anything moves
      failure = failure == null ? e : failure;
      throw e;
    } finally {
      lock.unlock();
    }
  }

  /** Shows an error in the simulation once; no program can be started after it. */
  private void showFailure() {
    if (failure != null && !failureShown) {
      submit.stop();
      stopFor(KrlExecutionException.SIMULATION_FAILED, "the simulation has failed: " + failure);
      publish();
      failureShown = true;
    }
  }

  /** Written only here, under the lock; other threads only read the time. */
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
    // assumed: the robot's program goes on without the submit program
    Message.Kind shown =
        kind == Interpreter.ROBOT ? Message.Kind.ACKNOWLEDGEMENT : Message.Kind.NOTIFICATION;
    panel.show(shown, fault.number(), position + ": " + fault.getMessage());
    variables.error(fault.number(), kind);
  }

  /** Sets $ERR for an error that does not stop the program. */
  private void showError(int number, Interpreter kind) {
    variables.error(number, kind);
  }

  private void fire(TriggerOrder order) {
    robot.fire(order);
  }

  private boolean isTrue(MotionOrder.Stop stop) throws KrlExecutionException {
    return robot.isTrue(stop);
  }

  private void publish() {
    coincidence.show();
    variables.publish(state());
  }

  private SystemVariables.State state() {
    Interpolator motion = motions.interpolator();
    return new SystemVariables.State(
        motion.joints(),
        motion.axisVelocity(),
        motion.externalVelocity(),
        motion.pathVelocity(),
        motion.standing(),
        motion.planned(),
        motion.distanceToEnd(),
        panel.mode(),
        panel.emergency(),
        panel.stopMessage(),
        motions.idle(),
        external.drives(),
        motors.torques(),
        motors.currents(),
        motors.temperatureRises(),
        coincidence.due(),
        coincidence.running());
  }

  /** Executes the signals of a higher-level controller. */
  private final class PlcActions implements AutomaticExternal.Actions {
    @Override
    public void confirm() {
      panel.confirmAll();
    }

    @Override
    public void start() {
      if (robot.state() == ProgramState.ACTIVE) {
        return; // the signal can announce a program number
      }
      try {
        if (!external.drives()) {
          throw new IllegalStateException("start: the drives are off");
        }
        startLocked(Interpreter.ROBOT, true, false);
      } catch (IllegalStateException e) {
        panel.show(
            Message.Kind.NOTIFICATION, OperatorPanel.NOT_STARTED, "$EXT_START: " + e.getMessage());
      }
    }

    @Override
    public void stop() {
      stopRobot();
    }
  }

  /** Shows the motions of the robot in the variables. */
  private final class MotionListener implements AdvanceRun.Listener {
    @Override
    public void failed(int number, String text) {
      boolean jogged = manual.jogging();
      manual.end();
      coincidence.lost();
      // a robot that is jogged to the end of its reach simply stands
      if (!jogged) {
        stopFor(number, text);
      }
    }

    @Override
    public void noticed(int number, String text) {
      panel.show(Message.Kind.NOTIFICATION, number, text);
    }

    @Override
    public void started(List<Joints> points, Frame base, Frame tool) {
      points.forEach(point -> started.add(variables.target(point, base, tool)));
    }

    @Override
    public void current(Joints from, Joints to, Frame base, Frame tool) {
      variables.current(from, to, base, tool);
    }

    @Override
    public void leftPath(Joints axes) {
      variables.leftPath(axes);
    }
  }
}
