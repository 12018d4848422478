package no.hials.crosscom.simulator;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.function.BooleanSupplier;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.internal.core.ControllerCore;
import no.hials.crosscom.simulator.internal.core.Pacemaker;
import org.jspecify.annotations.Nullable;

/**
 * A simulated KR C4 with its pendant. It loads data lists and programs, runs them with a robot
 * interpreter and a submit interpreter, moves a simulated robot, and shows its state in the system
 * variables.
 *
 * <p>Time passes in cycles of 12 ms, at the pace of the {@link SimulationClock}. With {@link
 * SimulationClock#stepped} the same calls produce the same trajectory, bit by bit.
 *
 * <p>Operating modes: in T1 the robot is slow ({@code $RED_T1}, {@code $VEL_CP_T1}, {@code
 * $SPEED_LIMIT_TEACH_MODE}). In T1 and T2 {@link ProgramControl#start} means holding the enabling
 * switch and the start key, in AUT pressing the start key. In EXT only {@link #externalStart}
 * starts. A change of the mode stops the robot's program.
 *
 * <p>After the selection of a program, its reset, or the selection of a line, the first motion in
 * T1, T2 and AUT is a BCO run: it is slow, and the program stops at its end until it is started
 * again. {@link #runProgram} does both. {@code $PRO_MODE1} {@code #MSTEP} stops a program after
 * each motion, {@code #ISTEP} after each line.
 *
 * <p>An error that stops a program is a {@link Message}, which has to be confirmed before the next
 * start; {@code $STOPMESS} is TRUE until then. Numbers below 9000 are KSS's own. A target out of
 * reach stops the program at its motion statement; a path that cannot be followed to its end, after
 * it. Programs show messages of their own, and dialogues for {@link #answer}.
 *
 * <p>Thread-safe. It has one daemon thread, unless the clock is stepped; {@link #close} ends it.
 * Another one parses the files of an archive while it is loaded.
 *
 * <p>The class is long, because it is the facade of the simulation; most of it is documentation.
 */
public final class Controller implements AutoCloseable {
  /**
   * The first {@code $DATE} with a stepped clock, so that each run is the same; from $OPERATE.DAT.
   */
  private static final LocalDateTime BEGIN = LocalDateTime.of(2014, 3, 14, 10, 15, 30);

  private final ControllerCore core;
  private final VariableTable variables;
  private final SimulationClock clock;
  private final ProgramControl robot;
  private final ProgramControl submit;
  private final @Nullable Pacemaker pacemaker;

  private volatile JogCoordinates jogCoordinates = JogCoordinates.AXIS;
  private final ModuleLoader loader;
  private volatile @Nullable FileTreePrograms programFiles;
  private volatile FileTreePrograms.Loaded loadedFiles = FileTreePrograms.Loaded.NOTHING;

  /**
   * Creates a controller. Its time starts now.
   *
   * @param variables its variables, such as {@link VariableTable#krc4(RobotModel)} of the model
   * @param clock the pace of its time
   * @param model the robot that it moves, unless machine data of another were loaded into the
   *     variables
   * @param threadName the name of its thread; a stepped clock needs none
   */
  public Controller(
      VariableTable variables, SimulationClock clock, RobotModel model, String threadName) {
    this.variables = variables;
    this.clock = clock;
    LocalDateTime begin =
        clock instanceof SimulationClock.Stepped
            ? BEGIN
            : LocalDateTime.now(ZoneId.systemDefault());
    core = new ControllerCore(variables.scope(), model, begin);
    core.loaded(variables.robotData(variables.robotSigns()));
    loader = new ModuleLoader(core, variables);
    robot = new ProgramControl(core, Interpreter.ROBOT);
    submit = new ProgramControl(core, Interpreter.SUBMIT);
    pacemaker =
        clock instanceof SimulationClock.Stepped ? null : new Pacemaker(core, clock, threadName);
  }

  /** Stops the programs and ends the thread. A second call does nothing. */
  @Override
  public void close() {
    core.close();
    if (pacemaker != null) {
      pacemaker.close();
    }
  }

  /**
   * Returns the variables.
   *
   * @return the table that the programs and the robot change
   */
  public VariableTable variables() {
    return variables;
  }

  // files

  /**
   * Connects a file tree. Programs loaded later appear in it as files, and {@link #loadFromFiles}
   * loads its programs.
   *
   * @param files the files of the controller
   */
  public void connect(FileTree files) {
    FileTreePrograms programs = new FileTreePrograms(files, loader, loadedFiles);
    programFiles = programs;
    loader.listener(programs::show);
  }

  /**
   * Loads new and changed programs of the connected file tree, and finds a module.
   *
   * @param name such as {@code /R1/X.SRC}, {@code KRC:\R1\PROGRAM\X.SRC} or {@code X}, in any case
   * @return the name by which {@link ProgramControl#select} selects the module
   * @throws KrlFileException if its files have errors or have been deleted
   * @throws IllegalStateException if no file tree is connected
   */
  public String loadFromFiles(String name) throws KrlFileException {
    FileTreePrograms programs = programFiles;
    if (programs == null) {
      throw new IllegalStateException("no file tree is connected");
    }
    return programs.prepare(name);
  }

  /**
   * Loads a data list or a program. With a {@code .src} or {@code .sub} file the {@code .dat} file
   * of the same name in its folder is loaded too, if it exists.
   *
   * @param file a {@code .dat}, {@code .src} or {@code .sub} file
   * @return the name of the module
   * @throws IOException if the file cannot be read
   * @throws KrlFileException if it has errors; then nothing has changed
   */
  public String load(Path file) throws IOException, KrlFileException {
    return loader.load(file, LoadingMode.STRICT).name();
  }

  /**
   * Loads a data list or a program, as {@link #load(Path)} does, and reports the problems.
   *
   * @param file a {@code .dat}, {@code .src} or {@code .sub} file
   * @param mode {@code LENIENT} keeps what is understood
   * @return the results of the file and of its data list; a lenient load refuses only a file that
   *     is not KRL or is too large
   * @throws IOException if the file cannot be read
   */
  public LoadReport load(Path file, LoadingMode mode) throws IOException {
    return loader.load(file, mode).report();
  }

  /**
   * Loads a data list or a program. A list whose name begins with {@code $} belongs to the
   * controller: its declarations are global. Any other list belongs to the module of the same name,
   * in either order of loading; the module's variables then have their initial values. A module
   * replaces an older one; a selected program keeps the old module until it is selected again.
   *
   * <p>A list of the controller that sets {@code $TRAFONAME} has the machine data of a robot, which
   * replaces the present one. A robot that has not moved yet then stands at {@code XHOME} of a
   * loaded list, else at {@code $AXIS_HOME[1]}. If the machine data describe another kind of robot,
   * such as a palletizer, a message says why, and the present one stays, with its machine data and,
   * if XHOME is outside its limits, its home position.
   *
   * @param fileName the file's name, for messages
   * @param text its contents
   * @return the name of the module
   * @throws KrlFileException if it has errors; then nothing has changed
   */
  public String load(String fileName, String text) throws KrlFileException {
    return loader.load(fileName, text, LoadingMode.STRICT).name();
  }

  /**
   * Loads a data list or a program, as {@link #load(String, String)} does, and reports the
   * problems.
   *
   * @param fileName the file's name, for messages
   * @param text its contents
   * @param mode {@code LENIENT} keeps what is understood
   * @return the result; a lenient load refuses only a file that is not KRL or is too large
   */
  public LoadReport load(String fileName, String text, LoadingMode mode) {
    return loader.load(fileName, text, mode).report();
  }

  /**
   * Loads the data lists and programs of an archive, and starts its submit program {@code sps.sub}.
   * The data of the robot, and where it stands first, are those of its {@code $machine.dat} and
   * {@code $config.dat}, as with {@link #load(String, String)}. No file prevents others from being
   * loaded, and nothing of a refused file is loaded.
   *
   * <p>Connect {@link Archive#tree} after it: its programs are then loaded already.
   *
   * @param archive the files
   * @param mode {@code LENIENT} keeps what is understood of each file
   * @return a result for each program and data list, with the names that are missing as warnings,
   *     and for each file that cannot be used
   */
  public LoadReport load(Archive archive, LoadingMode mode) {
    ArchiveLoader files = new ArchiveLoader(archive, loader, mode);
    files.load();
    loadedFiles = new FileTreePrograms.Loaded(files.modules(), mode);
    files.check(this::check);
    files.start(submit);
    return files.report();
  }

  ModuleLoader loader() {
    return loader;
  }

  /**
   * Lists the modules.
   *
   * @return their names, sorted
   */
  public SortedSet<String> programs() {
    return core.withLibrary(library -> library.names());
  }

  /**
   * Checks a module as its selection does: all names in it must be known.
   *
   * @param name the module's name
   * @return the errors; empty if it can be selected
   */
  public List<KrlError> check(String name) {
    return core.withLibrary(library -> library.check(name));
  }

  // programs

  /**
   * Returns the robot interpreter.
   *
   * @return the control of its program
   */
  public ProgramControl robot() {
    return robot;
  }

  /**
   * Returns the submit interpreter, which runs in parallel and cannot move the robot.
   *
   * @return the control of its program
   */
  public ProgramControl submit() {
    return submit;
  }

  /**
   * Starts the robot's program: in EXT as {@link #externalStart}, else by pressing the start key
   * once.
   *
   * @throws IllegalStateException if it cannot be started now
   */
  public void start() {
    if (mode() == OperatingMode.EXT) {
      externalStart();
    } else {
      robot.start();
    }
  }

  /**
   * Starts the robot's program as {@link #start} does, and presses Start again when its BCO run has
   * ended, so that the program runs on.
   *
   * @throws IllegalStateException if it cannot be started now
   */
  public void runProgram() {
    core.runRobot(mode() == OperatingMode.EXT);
  }

  /**
   * Sets whether BCO runs are simulated. Without them the first motion of a program is as fast as
   * any other, and one start is enough: for tests of the motions themselves.
   *
   * @param simulated whether they are; true at first
   */
  public void simulateBco(boolean simulated) {
    core.simulateBco(simulated);
  }

  /**
   * Starts the robot's program as a higher-level controller does, in mode EXT only.
   *
   * @throws IllegalStateException if it cannot be started now
   */
  public void externalStart() {
    core.start(Interpreter.ROBOT, true);
  }

  /**
   * Returns the operating mode.
   *
   * @return the mode; T1 at first
   */
  public OperatingMode mode() {
    return core.mode();
  }

  /**
   * Turns the key switch. On entry to T2 {@code $OV_PRO} falls to 10 if {@code $T2_OV_REDUCE} is
   * TRUE, its initial value.
   *
   * @param mode the new mode
   */
  public void setMode(OperatingMode mode) {
    core.setMode(mode);
  }

  /**
   * Presses or releases the emergency stop.
   *
   * @param pressed whether it is pressed
   */
  public void emergencyStop(boolean pressed) {
    core.emergencyStop(pressed);
  }

  /**
   * Returns the messages.
   *
   * @return the last 1000, the oldest first; after them the state messages of the present state
   */
  public List<Message> messages() {
    return core.messages();
  }

  /**
   * Returns the dialogue that {@link #answer} answers.
   *
   * @return the oldest dialogue that a program shows; empty if none is shown
   */
  public Optional<Message> dialogue() {
    return core.dialogue();
  }

  /**
   * Presses a key of the oldest dialogue that a program shows.
   *
   * @param key the number of the key in {@link Message#keys}, from 1
   * @throws IllegalStateException if no dialogue is shown
   * @throws IllegalArgumentException if it has no such key
   */
  public void answer(int key) {
    core.answer(key);
  }

  /**
   * Presses a key of a dialogue, unless another one is shown by now. Two dialogues are different
   * even if they have the same text.
   *
   * @param dialogue the dialogue, as {@link #dialogue} returned it
   * @param key the number of the key in {@link Message#keys}, from 1
   * @throws IllegalStateException if another dialogue or none is shown
   * @throws IllegalArgumentException if it has no such key
   */
  public void answer(Message dialogue, int key) {
    core.answer(dialogue, key);
  }

  /**
   * Confirms all messages.
   *
   * @return the number of confirmed messages
   */
  public int confirmAll() {
    return core.confirmAll();
  }

  // the robot

  /**
   * Moves the robot without a program, as a motion statement does: after the current motions,
   * exactly to the target.
   *
   * @param kind the kind of motion, not a circle
   * @param target the position of the statement: an E6POS, E6AXIS, or for a relative motion a
   *     difference
   * @throws KrlExecutionException if the target is out of reach
   * @throws IllegalStateException if a program is active, the robot is jogged, or the emergency
   *     stop or a message stops it
   */
  public void move(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    core.move(kind, target);
  }

  /**
   * Presses a jog key or moves the 6D mouse: in T1 and T2 the robot moves at {@code $OV_JOG} %
   * until {@link #releaseJog}, at most to the end of its reach.
   *
   * @param kind PTP to an axis position far away, or LIN_REL by a large difference
   * @param target the position or the difference
   * @throws KrlExecutionException if the robot cannot start to move there
   * @throws IllegalStateException if a program is active, the mode is not T1 or T2, or the
   *     emergency stop or a message stops the robot
   */
  public void jog(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    core.jog(kind, target);
  }

  /**
   * Presses a jog key: in T1 and T2 the robot moves at {@code $OV_JOG} % until {@link #releaseJog},
   * at most to the end of its reach.
   *
   * @param coordinates the direction of the keys
   * @param number 1 to 6: A1 to A6, or X, Y, Z, A, B and C; from 7 on E1 and the following, if the
   *     directions are those of the axes
   * @param positive the direction
   * @throws KrlExecutionException if the robot cannot start to move there
   * @throws IllegalArgumentException if there is no such key
   * @throws IllegalStateException if a program is active, the mode is not T1 or T2, or the
   *     emergency stop or a message stops the robot
   */
  public void jog(JogCoordinates coordinates, int number, boolean positive)
      throws KrlExecutionException {
    core.jog(coordinates, number, positive);
  }

  /**
   * Returns the directions of the jog keys of the pendant.
   *
   * @return {@link JogCoordinates#AXIS} at first
   */
  public JogCoordinates jogCoordinates() {
    return jogCoordinates;
  }

  /**
   * Selects the directions of the jog keys on the pendant, which C3 Bridge's keys use too.
   *
   * @param coordinates the directions
   */
  public void setJogCoordinates(JogCoordinates coordinates) {
    jogCoordinates = coordinates;
  }

  /** Releases the jog key: a jogged robot slows down and stops. */
  public void releaseJog() {
    core.releaseJog();
  }

  /**
   * Returns the robot.
   *
   * @return its geometry, its speeds, and the current limits of {@code $SOFTN_END} and {@code
   *     $SOFTP_END}
   */
  public RobotModel model() {
    return core.model();
  }

  /**
   * Returns the position of the robot.
   *
   * @return the commanded axis angles, in degrees, as in {@code $AXIS_ACT}
   */
  public Axis axes() {
    return core.axes();
  }

  /**
   * Returns whether the robot stands still.
   *
   * @return true if no axis moves
   */
  public boolean standing() {
    return core.standing();
  }

  /**
   * Returns the targets of the motions that have started in the last cycle, in their order; of a
   * spline block all points. A short motion can start and end within a cycle. A motion that will
   * end before its target, for example at a software limit, has none.
   *
   * @return the targets; empty if no motion has started
   */
  public List<MotionTarget> startedMotions() {
    return core.startedMotions();
  }

  /**
   * Puts the robot at a position immediately; no program may be active. A program that was stopped
   * in a motion continues after it.
   *
   * @param axes the position, in degrees
   * @throws IllegalArgumentException if it is outside the software limits
   * @throws IllegalStateException if a program is active
   */
  public void place(Axis axes) {
    core.place(axes);
  }

  // time

  /**
   * Returns the simulated time.
   *
   * @return the time since the controller was created; whole cycles of 12 ms
   */
  public Duration time() {
    return Duration.ofMillis(core.time());
  }

  /**
   * Advances the time. Only with {@link SimulationClock#stepped}.
   *
   * @param time rounded up to whole cycles of 12 ms
   * @throws IllegalStateException if the clock is not stepped, or the controller is closed
   */
  public void step(Duration time) {
    stepUntil(() -> false, time);
  }

  /**
   * Advances the time until a condition is true. Only with {@link SimulationClock#stepped}.
   *
   * @param condition called before each cycle of 12 ms; it may read variables over the network
   * @param limit the maximum simulated time
   * @return whether it became true within the limit
   * @throws IllegalStateException if the clock is not stepped, or the controller is closed
   */
  public boolean stepUntil(BooleanSupplier condition, Duration limit) {
    if (!(clock instanceof SimulationClock.Stepped)) {
      throw new IllegalStateException(
          "stepping needs SimulationClock.stepped(), the clock is " + clock);
    }
    return core.run(limit, condition);
  }

  /**
   * Returns the mode and the selected programs with their states.
   *
   * @return such as {@code AUT, ACTUATOR #P_ACTIVE line 26}
   */
  @Override
  public String toString() {
    List<String> parts = new ArrayList<>();
    parts.add(mode().toString());
    parts.add(robot.toString());
    if (submit.state() != ProgramState.FREE) {
      parts.add("submit " + submit);
    }
    return String.join(", ", parts);
  }
}
