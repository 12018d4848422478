package no.hials.crosscom.mock;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import no.hials.crosscom.mock.internal.data.Path;
import no.hials.crosscom.mock.internal.data.RefusedException;
import no.hials.crosscom.mock.internal.data.Scope;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * Holds the variables of the simulated controller: their types, access rights and values.
 *
 * <p>Names are those that clients send, in any case: {@code $OV_PRO}, {@code $POS_ACT.X}, {@code
 * LOAD_DATA[1].CM.X}, {@code $TORQUE_AXIS_ACT[3]}, {@code $TORQUE_AXIS_ACT[]} for a whole array,
 * {@code $MODEL_NAME[]} for a CHAR array, {@code TOOL_NAME[1,]} for one text of several. The
 * methods here are for Java code, which may write everything; a client's write keeps to the access
 * rights. What is not possible is an {@link IllegalArgumentException} that says why.
 *
 * <p>Safe for use by several threads; every access is atomic. The table starts no thread.
 */
public final class VariableTable {
  private final Scope scope = new Scope();

  private VariableTable() {}

  /**
   * Makes a table of a KR 6 R900 sixx with a KR C4 (KSS 8.3), standing at its home position in mode
   * T1, with some user variables such as {@code MYPOS}.
   *
   * @return a new table
   */
  public static VariableTable krc4() {
    return BuiltInTable.KRC4.copy();
  }

  /**
   * Makes a table without variables that knows the base types only.
   *
   * @return a new table
   */
  public static VariableTable empty() {
    return new VariableTable();
  }

  /**
   * Makes a table with the same contents, which can be changed independently.
   *
   * @return a new table
   */
  public VariableTable copy() {
    VariableTable copy = new VariableTable();
    copy.scope.copyFrom(scope);
    return copy;
  }

  // declarations

  /**
   * Declares a STRUC type, in place of one of the same name. Variables declared before keep theirs.
   *
   * @param name the type's name
   * @param definition the components in print order, such as {@code REAL SPEED; INT SEAM; CHAR
   *     NAME[24]; FRAME OFFSET}
   */
  public void declareStruc(String name, String definition) {
    List<Scope.Component> components = new ArrayList<>();
    for (String group : definition.split(";", -1)) {
      String declaration = group.strip();
      int blank = declaration.indexOf(' ');
      if (blank < 0) {
        throw new IllegalArgumentException(
            "a group of components is a type and names, is '" + declaration + "'");
      }
      // commas within brackets part dimensions
      for (String component : declaration.substring(blank).split(",(?![^\\[]*])", -1)) {
        components.add(new Scope.Component(declaration.substring(0, blank), component));
      }
    }
    scope.declareStruc(name, components);
  }

  /**
   * Declares an ENUM type, in place of one of the same name. Variables declared before keep theirs.
   *
   * @param name the type's name
   * @param constants the constants, without {@code #}
   */
  public void declareEnum(String name, String... constants) {
    scope.declareEnum(name, List.of(constants));
  }

  /**
   * Declares a variable that clients may read and write, in place of one of the same name.
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
   * Declares a variable, in place of one of the same name.
   *
   * @param name the name, for an array with its dimensions: {@code MYPOINTS[10]}
   * @param type {@code INT}, {@code REAL}, {@code BOOL}, {@code CHAR}, a declared type, or {@code
   *     SIGNAL}
   * @param access what clients may do
   * @param value the initial value as KRL text; for an array all elements separated by blanks, or
   *     one value for every element; for a SIGNAL its wiring, {@code $OUT[5] TO $OUT[8]}; null for
   *     an uninitialised variable
   */
  public void declare(String name, String type, Access access, @Nullable String value) {
    if (Scope.key(type).equals("SIGNAL")) {
      if (value == null) {
        throw new IllegalArgumentException("SIGNAL " + name + " needs a wiring");
      }
      scope.declareSignal(name, value, access);
      return;
    }
    try {
      scope.declare(name, type, access, value == null ? null : parse(value));
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  /**
   * Removes a variable.
   *
   * @param name its name, without index
   * @return whether there was one
   */
  public boolean remove(String name) {
    return scope.remove(name);
  }

  /**
   * Says whether a variable is declared.
   *
   * @param name its name, without index
   * @return whether there is one
   */
  public boolean contains(String name) {
    return scope.contains(name);
  }

  /**
   * Lists the variables.
   *
   * @return the names as declared, without dimensions, sorted; a copy
   */
  public SortedSet<String> names() {
    return scope.names();
  }

  // access from Java

  /**
   * Reads a variable as the controller prints it: {@code {E6POS: X 525.000, ...}}; the text of a
   * whole array ends with a blank.
   *
   * @param name what to read
   * @return the text
   * @throws IllegalArgumentException if there is no such variable or it has no value
   */
  public String get(String name) {
    try {
      return read(name);
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  /**
   * Reads a variable as a value.
   *
   * @param name what to read
   * @return the value
   * @throws IllegalArgumentException if there is no such variable or it has no value
   */
  public KrlValue value(String name) {
    try {
      return readValue(name);
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  /**
   * Writes a variable, whatever its access rights.
   *
   * @param name what to write; here a whole array, too
   * @param text the value as KRL text; an aggregate changes the fields it has; a whole array takes
   *     all elements or one value for every element
   * @throws IllegalArgumentException if there is no such variable or the value is not of its type
   */
  public void set(String name, String text) {
    try {
      set(name, parse(text));
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  /**
   * Writes a variable, whatever its access rights.
   *
   * @param name what to write; here a whole array, too
   * @param value the value; an aggregate changes the fields it has; a whole array takes all
   *     elements or one value for every element
   * @throws IllegalArgumentException if there is no such variable or the value is not of its type
   */
  public void set(String name, KrlValue value) {
    try {
      scope.write(Path.parse(name), value, Scope.Writer.SYSTEM);
    } catch (RefusedException e) {
      throw refusedToJava(name, e);
    }
  }

  private static IllegalArgumentException refusedToJava(String name, RefusedException e) {
    return new IllegalArgumentException(name + ": " + e.getMessage(), e);
  }

  // access by clients

  /** Gives the text of a variable as the controller prints it. */
  String read(String name) throws RefusedException {
    return scope.print(Path.parse(name));
  }

  /** Gives the value of a variable. */
  KrlValue readValue(String name) throws RefusedException {
    return scope.read(Path.parse(name));
  }

  /** Gives the scope of the global variables. */
  Scope scope() {
    return scope;
  }

  /**
   * Writes a variable for a client.
   *
   * @param maxAggregateLength how long the text of an aggregate may be, 0 for no limit
   */
  void write(String name, String text, int maxAggregateLength) throws RefusedException {
    Path path = Path.parse(name);
    KrlValue value = parse(text);
    // kukavarproxy.md: at most 255 bytes for a written aggregate; text is one byte a character
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
      throw new RefusedException(Refusal.NO_VALUE, e.getMessage());
    }
  }
}
