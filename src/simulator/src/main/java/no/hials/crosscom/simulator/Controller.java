package no.hials.crosscom.simulator;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedSet;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlFile;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.SourceFile;
import no.hials.crosscom.lang.Statement.MotionKind;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.simulator.internal.core.ControllerCore;
import no.hials.crosscom.simulator.internal.core.Pacemaker;
import org.jspecify.annotations.Nullable;

/**
 * A simulated KR C4: what a person could do with it at its pendant. It loads data lists and
 * programs, runs them with a robot interpreter and a submit interpreter, moves a simulated robot,
 * and shows all that in its system variables.
 *
 * <p>Its time passes in cycles of 12 ms as its {@link SimulationClock} says. With {@link
 * SimulationClock#stepped} the same calls give the same trajectory, bit by bit.
 *
 * <p>Operating modes: in T1 the robot is slow ({@code $RED_T1}, {@code $VEL_CP_T1}, {@code
 * $SPEED_LIMIT_TEACH_MODE}); in T1 and T2 {@link ProgramControl#start} stands for holding the
 * enabling switch and the start key, in AUT for pressing the start key; in EXT only {@link
 * #externalStart} starts. A change of the mode stops the robot's program. There is no BCO run: the
 * first motion of a program is like any other (a real controller goes to the first point slowly,
 * and waits).
 *
 * <p>What stops a program in error is a {@link Message} that has to be confirmed before the next
 * start; {@code $STOPMESS} is TRUE until then. The reference has no numbers of KSS's messages;
 * those from 9001 on are this simulation's own. A target that cannot be reached stops the program
 * at its motion statement; a path that turns out to lead nowhere, behind it.
 *
 * <p>Threads: one daemon, unless the clock is stepped, which {@link #close} ends. All methods are
 * safe for use by several threads.
 */
public final class Controller implements AutoCloseable {
  /** With a stepped clock all is the same each time: {@code $DATE}, too, as $OPERATE.DAT has it. */
  private static final LocalDateTime BEGIN = LocalDateTime.of(2014, 3, 14, 10, 15, 30);

  private final ControllerCore core;
  private final VariableTable variables;
  private final SimulationClock clock;
  private final ProgramControl robot;
  private final ProgramControl submit;
  private final @Nullable Pacemaker pacemaker;

  private volatile @Nullable FileTreePrograms programFiles;

  /** Called after a file was loaded. */
  private volatile LoadListener listener = (module, ending, text) -> {};

  /** Data lists of modules, by name in upper case; guarded by the core. */
  private final Map<String, DataList> dataLists = new HashMap<>();

  /**
   * Creates a controller. Its time passes from now on.
   *
   * @param variables its variables
   * @param clock how its time passes
   * @param model the robot that it moves
   * @param threadName the name of its thread, which a stepped clock does not need
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
    robot = new ProgramControl(core, Interpreter.ROBOT);
    submit = new ProgramControl(core, Interpreter.SUBMIT);
    pacemaker =
        clock instanceof SimulationClock.Stepped ? null : new Pacemaker(core, clock, threadName);
  }

  /** Stops the programs and ends the thread. Does nothing the second time. */
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
   * Connects a file tree: what is loaded from now on appears in it as files, and {@link
   * #loadFromFiles} loads its programs.
   *
   * @param files the files of the controller
   */
  public void connect(FileTree files) {
    programFiles = new FileTreePrograms(files, this);
    listener = programFiles::show;
  }

  /**
   * Loads new and changed programs of the connected file tree and finds a module.
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

  /** Hears of the files of modules; nothing of the controller is locked meanwhile. */
  @FunctionalInterface
  interface LoadListener {
    /**
     * Hears that a file was loaded.
     *
     * @param module the module's name
     * @param ending src, sub or dat
     * @param text the contents
     */
    void loaded(String module, String ending, String text);
  }

  /**
   * Loads a data list or a program. For a {@code .src} or {@code .sub} file the {@code .dat} file
   * of the same name beside it is loaded, too, if there is one.
   *
   * @param file a {@code .dat}, {@code .src} or {@code .sub} file
   * @return the name of the module
   * @throws IOException if the file cannot be read
   * @throws KrlFileException if something is wrong in it; then nothing has changed
   */
  public String load(Path file) throws IOException, KrlFileException {
    String name = String.valueOf(file.getFileName());
    String text = text(file);
    Path beside = dataListOf(file);
    if (beside == null) {
      return load(name, text);
    }
    String listText = text(beside);
    ParseResult data = KrlParser.parse(String.valueOf(beside.getFileName()), listText);
    KrlFile module = take(name, KrlParser.parse(name, text), data);
    listener.loaded(module.name(), "dat", listText);
    tell(module, name, text);
    return module.name();
  }

  private static String text(Path file) throws IOException {
    if (!Files.exists(file)) {
      throw new NoSuchFileException(file.toString(), null, "there is no such file");
    }
    return Files.readString(file, StandardCharsets.ISO_8859_1);
  }

  /** Finds the data list of a source file, whatever the case of its name. */
  private static @Nullable Path dataListOf(Path file) throws IOException {
    String name = String.valueOf(file.getFileName());
    int dot = name.lastIndexOf('.');
    Path folder = file.toAbsolutePath().getParent();
    if (dot < 0 || folder == null || name.substring(dot).equalsIgnoreCase(".dat")) {
      return null;
    }
    String wanted = name.substring(0, dot) + ".dat";
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(other -> String.valueOf(other.getFileName()).equalsIgnoreCase(wanted))
          .min(Comparator.naturalOrder())
          .orElse(null);
    }
  }

  /**
   * Loads a data list or a program. A list whose name begins with {@code $} is one of the
   * controller: what it declares is global. Another belongs to the module of its name, whichever of
   * both is loaded first; the module's variables then have their initial values. A module takes the
   * place of an older one; a program that is selected keeps the old one until it is selected again.
   *
   * @param fileName the file's name, for messages
   * @param text its contents
   * @return the name of the module
   * @throws KrlFileException if something is wrong in it; then nothing has changed
   */
  public String load(String fileName, String text) throws KrlFileException {
    KrlFile file = take(fileName, KrlParser.parse(fileName, text), null);
    tell(file, fileName, text);
    return file.name();
  }

  /** Does what {@link #load(String, String)} does with a file that is known already. */
  String take(String fileName, String text) throws KrlFileException {
    return take(fileName, KrlParser.parse(fileName, text), null).name();
  }

  private void tell(KrlFile file, String fileName, String text) {
    boolean submit = fileName.toLowerCase(Locale.ROOT).endsWith(".sub");
    String ending = submit ? "sub" : "src";
    listener.loaded(file.name(), file instanceof DataList ? "dat" : ending, text);
  }

  private KrlFile take(String fileName, ParseResult parsed, @Nullable ParseResult beside)
      throws KrlFileException {
    List<KrlError> errors = new ArrayList<>(parsed.errors());
    if (beside != null) {
      errors.addAll(beside.errors());
    }
    KrlFile file = parsed.file().orElse(null);
    if (!errors.isEmpty() || file == null) {
      throw new KrlFileException(errors);
    }
    if (file instanceof SourceFile source) {
      takeSource(source, beside);
    } else {
      takeData(fileName, (DataList) file, parsed);
    }
    return file;
  }

  private void takeSource(SourceFile source, @Nullable ParseResult beside) throws KrlFileException {
    List<KrlError> errors =
        core.withLibrary(
            library -> {
              DataList data = dataLists.get(key(source.name()));
              if (beside != null && beside.file().orElse(null) instanceof DataList list) {
                data = list;
              }
              List<KrlError> found = library.put(source, data);
              if (found.isEmpty() && data != null) {
                dataLists.put(key(source.name()), data);
              }
              return found;
            });
    if (!errors.isEmpty()) {
      throw new KrlFileException(errors);
    }
  }

  private void takeData(String fileName, DataList list, ParseResult parsed)
      throws KrlFileException {
    // of a module's list it shows what is global, and says what is wrong
    variables.load(fileName, parsed);
    if (!list.name().startsWith("$")) {
      core.withLibrary(
          library -> {
            dataLists.put(key(list.name()), list);
            return library.put(list);
          });
    }
  }

  private static String key(String name) {
    return name.toUpperCase(Locale.ROOT);
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
   * Checks a module as selecting it does: that everything it names is known.
   *
   * @param name the module's name
   * @return what is wrong; empty if nothing is
   */
  public List<KrlError> check(String name) {
    return core.withLibrary(library -> library.check(name));
  }

  // programs

  /**
   * Gives the robot interpreter.
   *
   * @return what selects, starts and stops its program
   */
  public ProgramControl robot() {
    return robot;
  }

  /**
   * Gives the submit interpreter, which runs beside the other one and moves nothing.
   *
   * @return what selects, starts and stops its program
   */
  public ProgramControl submit() {
    return submit;
  }

  /**
   * Starts the robot's program in the way that the mode allows: as {@link #externalStart} in EXT,
   * else by the start key.
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

  /** Starts the robot's program as a higher-level controller does; in mode EXT only. */
  public void externalStart() {
    core.start(Interpreter.ROBOT, true);
  }

  /**
   * Gives the operating mode.
   *
   * @return the mode; T1 at first
   */
  public OperatingMode mode() {
    return core.mode();
  }

  /**
   * Turns the key switch. On entry to T2 {@code $OV_PRO} falls to 10 if {@code $T2_OV_REDUCE} is
   * TRUE, as it is at first.
   *
   * @param mode the mode
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
   * Gives the messages.
   *
   * @return the last 1000, the oldest first
   */
  public List<Message> messages() {
    return core.messages();
  }

  /**
   * Confirms all messages that wait for it.
   *
   * @return how many did
   */
  public int confirmAll() {
    return core.confirmAll();
  }

  // the robot

  /**
   * Moves the robot as one motion statement, without a program.
   *
   * @param kind the kind of motion
   * @param target the statement's position, such as an E6POS
   * @throws KrlExecutionException if the motion is impossible
   * @throws IllegalStateException if the robot cannot be moved now
   */
  public void move(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    core.move(kind, target);
  }

  /**
   * Presses a jog key or moves the 6D mouse: the robot moves towards a position until {@link
   * #releaseJog}.
   *
   * @param kind the kind of motion
   * @param target the position at the end of the axis or direction
   * @throws KrlExecutionException if the motion is impossible
   * @throws IllegalStateException if the robot cannot be jogged now
   */
  public void jog(MotionKind kind, KrlStruct target) throws KrlExecutionException {
    core.jog(kind, target);
  }

  /** Releases the jog key. */
  public void releaseJog() {
    core.releaseJog();
  }

  /**
   * Gives the robot.
   *
   * @return its geometry, its speeds, and the limits that {@code $SOFTN_END} and {@code $SOFTP_END}
   *     have now
   */
  public RobotModel model() {
    return core.model();
  }

  /**
   * Gives where the robot is.
   *
   * @return the commanded axis angles, in degrees, as {@code $AXIS_ACT} has them
   */
  public Axes axes() {
    return core.axes();
  }

  /**
   * Says whether the robot stands.
   *
   * @return whether no axis moves
   */
  public boolean standing() {
    return core.standing();
  }

  /**
   * Puts the robot somewhere, at once; no program may be active. One that was stopped on a motion
   * goes on behind it.
   *
   * @param axes where, in degrees
   * @throws IllegalArgumentException if it is outside of the software limits
   */
  public void place(Axes axes) {
    core.place(axes);
  }

  // time

  /**
   * Gives the simulated time.
   *
   * @return the time since the controller was made; whole cycles of 12 ms
   */
  public Duration time() {
    return Duration.ofMillis(core.time());
  }

  /**
   * Lets time pass. Only with {@link SimulationClock#stepped}.
   *
   * @param time how much; rounded up to whole cycles of 12 ms
   * @throws IllegalStateException if the clock is another one, or the server is closed
   */
  public void step(Duration time) {
    stepUntil(() -> false, time);
  }

  /**
   * Lets time pass until something is true. Only with {@link SimulationClock#stepped}.
   *
   * @param condition asked before each cycle of 12 ms; it may read variables over the network
   * @param limit how much simulated time at most
   * @return whether it became true; false if the time is over
   * @throws IllegalStateException if the clock is another one, or the server is closed
   */
  public boolean stepUntil(BooleanSupplier condition, Duration limit) {
    if (!(clock instanceof SimulationClock.Stepped)) {
      throw new IllegalStateException(
          "stepping needs SimulationClock.stepped(), the clock is " + clock);
    }
    return core.run(limit, condition);
  }

  /**
   * Gives all that was selected and where it stands, for a person to read.
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
