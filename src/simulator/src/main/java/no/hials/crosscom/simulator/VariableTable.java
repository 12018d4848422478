package no.hials.crosscom.simulator;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import no.hials.crosscom.lang.VariableNote;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.internal.core.RobotData;
import no.hials.crosscom.simulator.internal.data.DataListLoader;
import no.hials.crosscom.simulator.internal.data.DataListWriter;
import no.hials.crosscom.simulator.internal.data.DataLists;
import no.hials.crosscom.simulator.internal.data.Declarations;
import no.hials.crosscom.simulator.internal.data.SavedVariables;
import no.hials.crosscom.simulator.internal.data.Scope;
import no.hials.crosscom.simulator.internal.data.VariablePath;
import org.jspecify.annotations.Nullable;

/**
 * Holds the variables of the simulated controller: their types, access rights and values.
 *
 * <p>Names are written as clients send them, in any case: {@code $OV_PRO}, {@code $POS_ACT.X},
 * {@code LOAD_DATA[1].CM.X}, {@code $TORQUE_AXIS_ACT[3]}, {@code $TORQUE_AXIS_ACT[]} for a whole
 * array, {@code $MODEL_NAME[]} for a CHAR array, {@code TOOL_NAME[1,]} for one text of several. The
 * methods are for Java code, which may write everything. A client needs the access right, and must
 * keep to the ranges of {@code $OV_PRO}, {@code $ADVANCE} and some other variables of {@link
 * #krc4}. An impossible access throws an {@link IllegalArgumentException}.
 *
 * <p>Thread-safe; every access is atomic. The table starts no thread. The class is long, because
 * most of it is documentation.
 */
public final class VariableTable {
  private final Scope scope = new Scope();

  /** The notes of the variables, by their names in upper case; replaced, never changed. */
  private volatile Map<String, VariableNote> notes = Map.of();

  /** The variables of {@link RobotData#SIGNS} that were loaded; replaced, never changed. */
  private volatile Set<String> robotSigns = Set.of();

  /** The data of the robot before those of another one were loaded. */
  private final SavedVariables robotBefore = new SavedVariables();

  private VariableTable() {}

  /**
   * Creates a table of a KR 6 R900 sixx with a KR C4 (KSS 8.3) at its home position in mode T1,
   * with some user variables such as {@code MYPOS}. Its contents are in the data lists {@code
   * $TYPES.DAT}, {@code $OPERATE.DAT}, {@code $MACHINE.DAT} and {@code $CONFIG.DAT} in the jar.
   *
   * @return a new table
   */
  public static VariableTable krc4() {
    return BuiltInTable.KRC4.copy();
  }

  /**
   * Creates the table of {@link #krc4} with the machine data of another robot, at its home position
   * (docs/reference/robots.md#machine-data). Other values, such as loads and the speeds of T1, stay
   * those of the KR 6 R900 sixx.
   *
   * @param robot the robot
   * @return a new table
   */
  public static VariableTable krc4(RobotModel robot) {
    return BuiltInTable.of(robot);
  }

  /**
   * Creates a table without variables, which has only the base types.
   *
   * @return a new table
   */
  public static VariableTable empty() {
    return new VariableTable();
  }

  /**
   * Creates a table with the same contents, which can be changed independently.
   *
   * @return a new table
   */
  public VariableTable copy() {
    VariableTable copy = new VariableTable();
    copy.scope.copyFrom(scope);
    copy.notes = notes;
    copy.robotSigns = robotSigns;
    copy.robotBefore.copyFrom(robotBefore);
    return copy;
  }

  // data lists

  /**
   * Loads a data list as KSS writes it, such as a robot's own {@code $CONFIG.DAT}. Its declarations
   * replace those of the table; a variable whose name starts with {@code $} keeps its access right.
   * The list of a module, whose name does not start with {@code $}, adds only its GLOBAL
   * declarations, and only if it is PUBLIC; the rest is only checked.
   *
   * @param file the file, in Windows-1252 or UTF-8, with any line ends
   * @throws IOException if it cannot be read
   * @throws KrlFileException if it contains errors; the exception lists all of them, and nothing
   *     has changed
   */
  public void load(Path file) throws IOException, KrlFileException {
    load(file.toString(), DataLists.parse(file));
  }

  /**
   * Loads a data list from its text, as {@link #load(Path)} does.
   *
   * @param name the name in messages
   * @param text the text
   * @throws KrlFileException if it contains errors; the exception lists all of them, and nothing
   *     has changed
   */
  public void load(String name, String text) throws KrlFileException {
    load(name, KrlParser.parse(name, text));
  }

  /**
   * Loads a data list, as {@link #load(Path)} does, and reports its problems.
   *
   * @param file the file
   * @param mode {@code LENIENT} keeps what is understood
   * @return the warnings, or why it was refused; a lenient load refuses only a file that is not a
   *     data list
   * @throws IOException if it cannot be read
   */
  public LoadReport load(Path file, LoadingMode mode) throws IOException {
    return load(file.toString(), DataLists.parse(file), mode);
  }

  /**
   * Loads a data list from its text, as {@link #load(Path, LoadingMode)} does.
   *
   * @param name the name in messages
   * @param text the text
   * @param mode {@code LENIENT} keeps what is understood
   * @return the warnings, or why it was refused; a lenient load refuses only a file that is not a
   *     data list
   */
  public LoadReport load(String name, String text, LoadingMode mode) {
    return load(name, KrlParser.parse(name, text), mode);
  }

  /** Loads a parsed data list. */
  private void load(String name, ParseResult result) throws KrlFileException {
    LoadReport report = load(name, result, LoadingMode.STRICT);
    if (report.anyRefused()) {
      throw new KrlFileException(report.problems());
    }
  }

  /** Loads a parsed data list. */
  LoadReport load(String name, ParseResult result, LoadingMode mode) {
    List<KrlError> errors = new ArrayList<>();
    Optional<DataList> parsed = DataLists.dataList(name, result, errors);
    boolean loaded = parsed.isPresent() && scope.attempt(() -> take(parsed.get(), mode, errors));
    List<KrlError> problems = DataLists.sorted(errors);
    return new LoadReport(
        List.of(
            loaded
                ? LoadReport.FileReport.loaded(name, parsed.get().name(), problems)
                : LoadReport.FileReport.refused(name, problems)));
  }

  private boolean take(DataList list, LoadingMode mode, List<KrlError> errors) {
    Set<String> signs = DataLists.variablesSetBy(list, RobotData.SIGNS);
    robotBefore.keep(scope, DataLists.variablesSetBy(list, RobotData.VARIABLES));
    DataListLoader.load(list, new Scope(scope), scope, mode, errors::add);
    if (mode == LoadingMode.STRICT && !errors.isEmpty()) {
      return false;
    }
    Map<String, VariableNote> added = DataLists.notes(list);
    if (!added.isEmpty()) {
      Map<String, VariableNote> all = new HashMap<>(notes);
      all.putAll(added);
      notes = Map.copyOf(all);
    }
    signs.addAll(robotSigns);
    robotSigns = Set.copyOf(signs);
    return true;
  }

  /**
   * Saves all types and variables as a data list. When it is loaded, into this table or another,
   * every variable gets its present value, even if it follows the simulated robot; variables
   * without a value stay without one. Java code can declare names longer than the 24 characters of
   * KRL; such a variable is saved but cannot be loaded.
   *
   * @param file the file, which is overwritten; in Windows-1252 if possible, else UTF-8; CR and LF
   * @throws IOException if it cannot be written
   * @throws IllegalStateException if a text contains a line break, which a data list cannot contain
   */
  public void save(Path file) throws IOException {
    DataLists.write(file, toDataList(file.getFileName().toString()));
  }

  /**
   * Saves some variables and their types, as {@link #save(Path)} does: {@code save(file, name ->
   * !name.startsWith("$"))} omits the system variables.
   *
   * @param file the file, which is overwritten; in Windows-1252 if possible, else UTF-8; CR and LF
   * @param variables returns whether to save a variable, given its name as declared
   * @throws IOException if it cannot be written
   * @throws IllegalStateException if a text contains a line break, which a data list cannot contain
   */
  public void save(Path file, Predicate<String> variables) throws IOException {
    DataLists.write(file, toDataList(file.getFileName().toString(), variables));
  }

  /**
   * Returns the text that {@link #save(Path)} writes.
   *
   * @param name the name after {@code DEFDAT}; {@code $} is added if missing, because only such a
   *     data list can declare system variables
   * @return the text of a data list
   * @throws IllegalStateException if a text contains a line break, which a data list cannot contain
   */
  public String toDataList(String name) {
    return DataListWriter.write(DataLists.systemName(name), scope, null, notes);
  }

  /**
   * Returns the text that {@link #save(Path, Predicate)} writes.
   *
   * @param name the name after {@code DEFDAT}; {@code $} is added if missing
   * @param variables returns whether to save a variable, given its name as declared
   * @return the text of a data list
   * @throws IllegalStateException if a text contains a line break, which a data list cannot contain
   */
  public String toDataList(String name, Predicate<String> variables) {
    Set<String> chosen =
        names().stream().filter(variables).map(Scope::key).collect(Collectors.toSet());
    return DataListWriter.write(DataLists.systemName(name), scope, chosen, notes);
  }

  // descriptions

  /**
   * Describes a variable.
   *
   * @param name its name in any case, without index
   * @return type, access, unit and meaning; empty if it is not declared
   */
  public Optional<VariableInfo> describe(String name) {
    return DataLists.describe(scope, name, notes);
  }

  /**
   * Describes all variables.
   *
   * @return a copy, sorted by name
   */
  public List<VariableInfo> describeAll() {
    List<VariableInfo> all = new ArrayList<>();
    for (String name : names()) {
      describe(name).ifPresent(all::add);
    }
    return all;
  }

  /** Removes the note of a variable that has been replaced or removed. */
  private void forget(String name) {
    String key = Scope.key(name);
    synchronized (scope) {
      if (notes.containsKey(key)) {
        Map<String, VariableNote> rest = new HashMap<>(notes);
        rest.remove(key);
        notes = Map.copyOf(rest);
      }
    }
  }

  // declarations

  /**
   * Declares a STRUC type. Replaces a type of the same name; variables keep their type.
   *
   * @param declaration the type as in KRL, with the components in print order: {@code STRUC WELD
   *     REAL SPEED, INT SEAM, CHAR NAME[24], FRAME OFFSET}
   */
  public void declareStruc(String declaration) {
    Declarations.declareStruc(scope, declaration);
  }

  /**
   * Declares an ENUM type. Replaces a type of the same name; variables keep their type.
   *
   * @param name the name of the type
   * @param constants the constants, without {@code #}
   */
  public void declareEnum(String name, String... constants) {
    Declarations.declareEnum(scope, name, List.of(constants));
  }

  /**
   * Declares a variable that clients may read and write. Replaces a variable of the same name.
   *
   * @param name the name, for an array with its dimensions: {@code MYPOINTS[10]}
   * @param type {@code INT}, {@code REAL}, {@code BOOL}, {@code CHAR}, a declared type, or {@code
   *     SIGNAL}
   * @param value the initial value as KRL text; for an array all elements separated by blanks, or
   *     one value for every element; for a SIGNAL its wiring, {@code $OUT[5] TO $OUT[8]}; null for
   *     an uninitialised variable
   */
  public void declare(String name, String type, @Nullable String value) {
    declare(name, type, Access.READ_WRITE, value);
  }

  /**
   * Declares a variable. Replaces a variable of the same name.
   *
   * @param name the name, for an array with its dimensions: {@code MYPOINTS[10]}
   * @param type {@code INT}, {@code REAL}, {@code BOOL}, {@code CHAR}, a declared type, or {@code
   *     SIGNAL}
   * @param access the access of clients
   * @param value the initial value as KRL text; for an array all elements separated by blanks, or
   *     one value for every element; for a SIGNAL its wiring, {@code $OUT[5] TO $OUT[8]}; null for
   *     an uninitialised variable
   */
  public void declare(String name, String type, Access access, @Nullable String value) {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(type, "type");
    Objects.requireNonNull(access, "access");
    boolean isSignal = Scope.key(type).equals("SIGNAL");
    if (isSignal && value == null) {
      throw new IllegalArgumentException("SIGNAL " + name + " needs a wiring");
    }
    String declaration = type + " " + name + (isSignal ? " " + value : "");
    try {
      KrlValue initial = isSignal || value == null ? null : parse(value);
      forget(Declarations.declare(scope, declaration, access, initial));
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  /**
   * Removes a variable.
   *
   * @param name its name, without index
   * @return false if it was not declared
   */
  public boolean remove(String name) {
    forget(name);
    return scope.remove(name);
  }

  /**
   * Returns whether a variable is declared.
   *
   * @param name its name, without index
   * @return whether it is declared
   */
  public boolean contains(String name) {
    return scope.contains(name);
  }

  /**
   * Returns the names of the variables.
   *
   * @return a sorted copy of the names as declared, without dimensions
   */
  public SortedSet<String> names() {
    return scope.names();
  }

  // access from Java

  /**
   * Returns the value of a variable as the controller prints it: {@code {E6POS: X 525.000, ...}};
   * the text of a whole array ends with a blank.
   *
   * @param name the variable, or a part of it
   * @return the text
   * @throws IllegalArgumentException if it is not declared or has no value
   */
  public String get(String name) {
    try {
      return read(name);
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  /**
   * Returns the value of a variable.
   *
   * @param name the variable, or a part of it
   * @return the value
   * @throws IllegalArgumentException if it is not declared or has no value
   */
  public KrlValue value(String name) {
    try {
      return readValue(name);
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  /**
   * Writes a variable, whatever its access right.
   *
   * @param name the variable, or a part of it, or a whole array
   * @param text the value as KRL text; an aggregate changes the fields it contains; a whole array
   *     takes all elements or one value for every element
   * @throws IllegalArgumentException if it is not declared or the value does not have its type
   */
  public void set(String name, String text) {
    try {
      set(name, parse(text));
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  /**
   * Writes a variable, whatever its access right.
   *
   * @param name the variable, or a part of it, or a whole array
   * @param value the value; an aggregate changes the fields it contains; a whole array takes all
   *     elements or one value for every element
   * @throws IllegalArgumentException if it is not declared or the value does not have its type
   */
  public void set(String name, KrlValue value) {
    try {
      scope.write(VariablePath.parse(name), value, Scope.Writer.SYSTEM);
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  private static IllegalArgumentException refusedToJava(String name, RefusedException e) {
    return new IllegalArgumentException(name + ": " + e.getMessage(), e);
  }

  // access by clients

  /**
   * Reads a variable as a client does.
   *
   * @param name the variable, or a part of it
   * @return the text, as the controller prints it
   * @throws RefusedException if the controller refuses the access
   */
  public String read(String name) throws RefusedException {
    return scope.print(VariablePath.parse(name));
  }

  /**
   * Reads the value of a variable as a client does.
   *
   * @param name the variable, or a part of it
   * @return the value
   * @throws RefusedException if the controller refuses the access
   */
  public KrlValue readValue(String name) throws RefusedException {
    return scope.read(VariablePath.parse(name));
  }

  /** Returns which variables of {@link RobotData#SIGNS} were loaded from a data list. */
  Set<String> robotSigns() {
    return robotSigns;
  }

  /**
   * Returns the data of a robot.
   *
   * @param now the variables of {@link RobotData#SIGNS} that were just loaded
   */
  RobotData robotData(Set<String> now) {
    return new RobotData(now, robotSigns, robotBefore);
  }

  /** Forgets that data of a robot were loaded: a robot model describes it. */
  void forgetRobotData() {
    robotSigns = Set.of();
    robotBefore.forget();
  }

  /** Returns the scope of the global variables. */
  Scope scope() {
    return scope;
  }

  /**
   * Writes a variable as a client does.
   *
   * @param name the variable, or a part of it
   * @param text the value
   * @param maxAggregateLength the maximum length of the text of an aggregate; 0 for no limit
   * @throws RefusedException if the controller refuses the access
   */
  public void write(String name, String text, int maxAggregateLength) throws RefusedException {
    VariablePath path = VariablePath.parse(name);
    KrlValue value = parse(text);
    // at most 255 bytes for a written aggregate; text is one byte a character
    // (docs/reference/krl-values.md#lengths)
    if (value instanceof KrlStruct
        && maxAggregateLength > 0
        && text.length() > maxAggregateLength) {
      throw new RefusedException(
          Refusal.TOO_LONG,
          "an aggregate may have " + maxAggregateLength + " bytes, has " + text.length());
    }
    scope.write(path, value, Scope.Writer.CLIENT);
  }

  private static KrlValue parse(String text) throws RefusedException {
    try {
      return KrlValue.parse(text.strip());
    } catch (KrlSyntaxException e) {
      throw new RefusedException(Refusal.NO_VALUE, Objects.requireNonNull(e.getMessage()));
    }
  }
}
