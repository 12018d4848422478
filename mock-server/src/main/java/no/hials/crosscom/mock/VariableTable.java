package no.hials.crosscom.mock;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
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
  private static final String OUTPUTS = "$OUT";

  private final Object lock = new Object();
  private final Map<String, Type> types = new HashMap<>();
  private final Map<String, Variable> variables = new HashMap<>();

  /** The outputs that system signals are wired to; null if that has to be found out again. */
  private @Nullable BitSet systemOutputs;

  private VariableTable() {
    for (Type.Base type : Type.Base.values()) {
      types.put(type.name(), type);
    }
  }

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
    synchronized (lock) {
      copy.types.putAll(types);
      copy.variables.putAll(variables);
    }
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
    checkTypeName(name);
    synchronized (lock) {
      List<Declarator> components = new ArrayList<>();
      for (String group : definition.split(";", -1)) {
        String declaration = group.strip();
        int blank = declaration.indexOf(' ');
        if (blank < 0) {
          throw new IllegalArgumentException(
              "a group of components is a type and names, is '" + declaration + "'");
        }
        Type type = type(declaration.substring(0, blank));
        // commas within brackets part dimensions
        for (String component : declaration.substring(blank).split(",(?![^\\[]*])", -1)) {
          components.add(Declarator.parse(type, component));
        }
      }
      types.put(key(name), Type.Struc.of(name, components));
    }
  }

  /**
   * Declares an ENUM type, in place of one of the same name. Variables declared before keep theirs.
   *
   * @param name the type's name
   * @param constants the constants, without {@code #}
   */
  public void declareEnum(String name, String... constants) {
    checkTypeName(name);
    Type.Enumeration type = Type.Enumeration.of(name, List.of(constants));
    synchronized (lock) {
      types.put(key(name), type);
    }
  }

  private static void checkTypeName(String name) {
    if (!Path.isName(name)) {
      throw new IllegalArgumentException("a type's name is a KRL name, is '" + name + "'");
    }
    for (Type.Base type : Type.Base.values()) {
      if (type.name().equalsIgnoreCase(name)) {
        throw new IllegalArgumentException(name + " is a type of KRL itself");
      }
    }
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
    synchronized (lock) {
      Variable variable;
      if (key(type).equals("SIGNAL")) {
        Declarator declarator = Declarator.parse(Type.Base.BOOL, name);
        if (value == null || !declarator.dimensions().isEmpty()) {
          throw new IllegalArgumentException(name + " needs a wiring and no dimensions");
        }
        variable = new Variable(declarator.name(), access, null, Signal.parse(value));
      } else {
        Declarator declarator = Declarator.parse(type(type), name);
        Node contents = declarator.uninitialised();
        try {
          if (value != null) {
            contents = contents.assign(parse(value));
          }
        } catch (RefusedException e) {
          throw refusedToJava(name, e);
        }
        variable = new Variable(declarator.name(), access, contents, null);
      }
      variables.put(key(variable.name()), variable);
      systemOutputs = null;
    }
  }

  /**
   * Removes a variable.
   *
   * @param name its name, without index
   * @return whether there was one
   */
  public boolean remove(String name) {
    synchronized (lock) {
      systemOutputs = null;
      return variables.remove(key(name)) != null;
    }
  }

  /**
   * Says whether a variable is declared.
   *
   * @param name its name, without index
   * @return whether there is one
   */
  public boolean contains(String name) {
    synchronized (lock) {
      return variables.containsKey(key(name));
    }
  }

  /**
   * Lists the variables.
   *
   * @return the names as declared, without dimensions, sorted; a copy
   */
  public SortedSet<String> names() {
    SortedSet<String> names = new TreeSet<>();
    synchronized (lock) {
      for (Variable variable : variables.values()) {
        names.add(variable.name());
      }
    }
    return names;
  }

  private static String key(String name) {
    return name.strip().toUpperCase(Locale.ROOT);
  }

  private Type type(String name) {
    Type type = types.get(key(name));
    if (type == null) {
      throw new IllegalArgumentException("type " + name + " is not declared");
    }
    return type;
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
      Path path = Path.parse(name);
      synchronized (lock) {
        assign(path, find(path.first().name()), value, false);
      }
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
    Path path = Path.parse(name);
    synchronized (lock) {
      Variable variable = find(path.first().name());
      Node contents = variable.contents();
      return contents == null ? signalValue(path, variable).print() : contents.read(path).text();
    }
  }

  /** Gives the value of a variable. */
  KrlValue readValue(String name) throws RefusedException {
    Path path = Path.parse(name);
    synchronized (lock) {
      Variable variable = find(path.first().name());
      Node contents = variable.contents();
      return contents == null ? signalValue(path, variable) : contents.read(path).value();
    }
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
    synchronized (lock) {
      Variable variable = find(path.first().name());
      if (variable.access() == Access.READ_ONLY) {
        throw new RefusedException(Refusal.READ_ONLY, "may only be read");
      }
      assign(path, variable, value, true);
    }
  }

  private static KrlValue parse(String text) throws RefusedException {
    try {
      return KrlValue.parse(text.strip());
    } catch (KrlSyntaxException e) {
      throw new RefusedException(Refusal.NO_VALUE, e.getMessage());
    }
  }

  private Variable find(String key) throws RefusedException {
    Variable variable = variables.get(key);
    if (variable == null) {
      throw new RefusedException(Refusal.UNKNOWN_VARIABLE, "no variable " + key);
    }
    return variable;
  }

  private void assign(Path path, Variable variable, KrlValue value, boolean byClient)
      throws RefusedException {
    Node contents = variable.contents();
    if (contents == null) {
      assignSignal(path, variable, value, byClient);
      return;
    }
    String key = path.first().name();
    if (byClient) {
      if (contents.read(path) instanceof Node.ArrayNode) {
        // assumed: there is no way to set an array as a whole before KSS 8 (krl.md 1.4, ISS #14),
        // and none is documented for later
        throw new RefusedException(Refusal.WHOLE_ARRAY, "an array is written by element");
      }
      Index index = path.first().index();
      if (key.equals(OUTPUTS) && index.count() > 0 && systemOutputs().get(index.number(0))) {
        // krl.md 2.6, marked U: outputs that system signals use cannot be set from outside
        throw new RefusedException(Refusal.READ_ONLY, "is used by a system signal");
      }
    }
    variables.put(key, variable.with(contents.write(path, value)));
  }

  // signals

  private static Signal checkedSignal(Path path, Variable variable) throws RefusedException {
    Signal signal = variable.signal();
    if (signal == null) {
      throw new IllegalStateException(variable.name() + " has neither contents nor wiring");
    }
    if (!path.first().index().isNone()) {
      throw Node.badIndex("a SIGNAL is no array");
    }
    if (!path.isLast(0)) {
      throw new RefusedException(Refusal.UNKNOWN_COMPONENT, "a SIGNAL has no components");
    }
    return signal;
  }

  private static Path element(String array, int index) {
    return new Path(List.of(new Path.Step(array, new Index(new int[] {index}, false))));
  }

  private KrlValue signalValue(Path path, Variable variable) throws RefusedException {
    Signal signal = checkedSignal(path, variable);
    String array = signal.array();
    if (array == null) {
      return new KrlBool(false);
    }
    if (signal.isSingle()) {
      return elementValue(array, signal.first());
    }
    int bits = 0;
    for (int i = signal.last(); i >= signal.first(); i--) {
      if (!(elementValue(array, i) instanceof KrlBool bit)) {
        throw new RefusedException(Refusal.WRONG_TYPE, array + " is no array of BOOL");
      }
      bits = bits << 1 | (bit.value() ? 1 : 0);
    }
    return new KrlInt(bits);
  }

  private KrlValue elementValue(String array, int index) throws RefusedException {
    Node contents = find(array).contents();
    if (contents == null) {
      throw new RefusedException(Refusal.UNKNOWN_VARIABLE, array + " is no array");
    }
    return contents.read(element(array, index)).value();
  }

  private void assignSignal(Path path, Variable variable, KrlValue value, boolean byClient)
      throws RefusedException {
    Signal signal = checkedSignal(path, variable);
    String array = signal.array();
    if (array == null) {
      throw new RefusedException(Refusal.READ_ONLY, "is not wired");
    }
    Variable target = find(array);
    if (byClient && target.access() == Access.READ_ONLY) {
      throw new RefusedException(Refusal.READ_ONLY, array + " may only be read");
    }
    if (signal.isSingle()) {
      assign(element(array, signal.first()), target, value, byClient);
      return;
    }
    if (!(value instanceof KrlInt number)) {
      throw new RefusedException(Refusal.WRONG_TYPE, "needs INT, was given " + value.print());
    }
    int width = signal.last() - signal.first() + 1;
    if (width < Integer.SIZE && number.value() >>> width != 0) {
      throw new RefusedException(
          Refusal.OUT_OF_RANGE, "has " + width + " bits, was given " + number);
    }
    for (int i = 0; i < width; i++) {
      KrlBool bit = new KrlBool((number.value() >>> i & 1) != 0);
      try {
        assign(element(array, signal.first() + i), find(array), bit, byClient);
      } catch (RefusedException e) {
        variables.put(array, target); // all bits or none
        throw e;
      }
    }
  }

  private BitSet systemOutputs() {
    BitSet known = systemOutputs;
    if (known == null) {
      known = new BitSet();
      for (Variable variable : variables.values()) {
        Signal signal = variable.signal();
        if (signal != null && variable.name().startsWith("$") && OUTPUTS.equals(signal.array())) {
          known.set(signal.first(), signal.last() + 1);
        }
      }
      systemOutputs = known;
    }
    return known;
  }
}
