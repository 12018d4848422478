package no.hials.crosscom.simulator.internal.data;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Holds types and variables, and knows those of the scope around it: the locals of a routine lie in
 * the data list of its module, and that in the globals of the controller.
 *
 * <p>Safe for use by several threads; every access is atomic. What is not declared here is looked
 * for in the scope around.
 */
public final class Scope {
  private static final String OUTPUTS = "$OUT";

  /** Who writes, which decides what is allowed. */
  public enum Writer {
    /** A client over the network: keeps to the access rights, arrays by element only. */
    CLIENT,
    /** A KRL program: keeps to the access rights. */
    PROGRAM,
    /** The controller itself, a data list or Java code: everything. */
    SYSTEM
  }

  /** Refuses values that are of the right type and still not possible, for clients and programs. */
  @FunctionalInterface
  public interface Guard {
    /**
     * Looks at a value before it is written.
     *
     * @param path what is written, from the variable's name on
     * @param value the value
     * @throws RefusedException if it is not possible
     */
    void check(VariablePath path, KrlValue value) throws RefusedException;
  }

  private final @Nullable Scope parent;
  private final Map<String, Type> types = new HashMap<>();
  private final Map<String, VariableEntry> variables = new HashMap<>();
  private final Map<String, Guard> guards = new HashMap<>();

  /** The outputs that system signals are wired to; null if that has to be found out again. */
  private @Nullable BitSet systemOutputs;

  /** Makes an outermost scope, which knows the base types only. */
  public Scope() {
    parent = null;
    for (Type.Base type : Type.Base.values()) {
      types.put(type.name(), type);
    }
  }

  /**
   * Makes a scope without contents.
   *
   * @param parent the scope around it
   */
  public Scope(Scope parent) {
    this.parent = parent;
  }

  /**
   * Takes over all types, variables and guards of another scope, which can be changed
   * independently. What follows something there has here the value that was declared.
   *
   * @param other a scope
   */
  public void copyFrom(Scope other) {
    Map<String, Type> otherTypes;
    Map<String, VariableEntry> otherVariables;
    Map<String, Guard> otherGuards;
    synchronized (other) {
      otherTypes = Map.copyOf(other.types);
      otherVariables = Map.copyOf(other.variables);
      otherGuards = Map.copyOf(other.guards);
    }
    synchronized (this) {
      types.putAll(otherTypes);
      guards.putAll(otherGuards);
      otherVariables.forEach((name, variable) -> variables.put(name, variable.bound(null)));
      systemOutputs = null;
    }
  }

  // declarations

  /**
   * Gives a name as the maps have it.
   *
   * @param name a name in any case
   * @return the name without blanks around it, in upper case
   */
  public static String key(String name) {
    return name.strip().toUpperCase(Locale.ROOT);
  }

  private static void checkTypeName(String name) {
    if (!VariablePath.isName(name)) {
      throw new IllegalArgumentException("a type's name is a KRL name, is '" + name + "'");
    }
    for (Type.Base type : Type.Base.values()) {
      if (type.name().equalsIgnoreCase(name)) {
        throw new IllegalArgumentException(name + " is a type of KRL itself");
      }
    }
  }

  /** Declares a type, in place of one of the same name. */
  synchronized void declareType(Type type) {
    checkTypeName(type.name());
    types.put(key(type.name()), type);
  }

  /**
   * Says whether a type is known, here or around.
   *
   * @param name its name
   * @return whether a variable can be declared with it
   */
  public synchronized boolean knowsType(String name) {
    return types.containsKey(key(name)) || (parent != null && parent.knowsType(name));
  }

  /**
   * Returns a variable without a value.
   *
   * @param type the name of its type, which must be known
   */
  public Storage uninitialised(String type) {
    return type(type).uninitialised();
  }

  /** Gives a type of this scope or of one around it; IllegalArgumentException if none has it. */
  synchronized Type type(String name) {
    Type type = types.get(key(name));
    if (type != null) {
      return type;
    }
    if (parent != null) {
      return parent.type(name);
    }
    throw new IllegalArgumentException("type " + name + " is not declared");
  }

  /** Takes a variable in place of one of the same name in this scope. */
  synchronized void put(VariableEntry variable) {
    variables.put(key(variable.name()), variable);
    systemOutputs = null;
  }

  /**
   * Removes a variable of this scope.
   *
   * @param name its name, without index
   * @return whether there was one
   */
  public synchronized boolean remove(String name) {
    systemOutputs = null;
    return variables.remove(key(name)) != null;
  }

  /**
   * Says whether this scope itself has a variable.
   *
   * @param name its name, without index
   * @return whether there is one
   */
  public synchronized boolean contains(String name) {
    return variables.containsKey(key(name));
  }

  /**
   * Says whether a variable can be accessed from here.
   *
   * @param name its name, without index
   * @return whether this scope or one around it has it
   */
  public synchronized boolean knows(String name) {
    return contains(name) || (parent != null && parent.knows(name));
  }

  /** Gives the variables of this scope itself, in any order; a copy. */
  synchronized List<VariableEntry> variables() {
    return List.copyOf(variables.values());
  }

  /** Gives the types of this scope itself, in any order; a copy. */
  synchronized List<Type> types() {
    return List.copyOf(types.values());
  }

  /** Gives a variable of this scope or of one around it by its key; null if none has it. */
  synchronized @Nullable VariableEntry lookup(String key) {
    VariableEntry variable = variables.get(key);
    return variable != null || parent == null ? variable : parent.lookup(key);
  }

  /**
   * Lists the variables of this scope itself.
   *
   * @return the names as declared, without dimensions, sorted; a copy
   */
  public synchronized SortedSet<String> names() {
    SortedSet<String> names = new TreeSet<>();
    for (VariableEntry variable : variables.values()) {
      names.add(variable.name());
    }
    return names;
  }

  /**
   * Lets a variable follow something: its value is asked for at each read.
   *
   * @param name a variable of this scope, without index
   * @param value gives the whole value. It is asked under the lock of this scope, so it must be
   *     quick and must not wait
   */
  public synchronized void bind(String name, Supplier<KrlValue> value) {
    VariableEntry variable = variables.get(key(name));
    if (variable == null || variable.contents() == null) {
      throw new IllegalArgumentException(name + " is no variable that could be bound");
    }
    variables.put(key(name), variable.bound(value));
  }

  /**
   * Guards a variable of this scope against values that are not possible.
   *
   * @param name the variable, without index
   * @param guard is asked before each write of a client or a program, under the lock of this scope
   */
  public synchronized void guard(String name, Guard guard) {
    guards.put(key(name), guard);
  }

  /**
   * Makes several changes, or none. Other threads see the scope before or after all of them.
   *
   * @param change makes the changes; says whether they are to stay. It must be quick
   * @return whether they stay; if not, types and variables of this scope are as before
   */
  public synchronized boolean attempt(BooleanSupplier change) {
    Map<String, Type> oldTypes = Map.copyOf(types);
    Map<String, VariableEntry> oldVariables = Map.copyOf(variables);
    boolean done = false;
    try {
      done = change.getAsBoolean();
    } finally {
      if (!done) {
        types.clear();
        types.putAll(oldTypes);
        variables.clear();
        variables.putAll(oldVariables);
        systemOutputs = null;
      }
    }
    return done;
  }

  // access

  /**
   * Reads a value.
   *
   * @param path what to read
   * @return the value
   * @throws RefusedException if there is no such variable, or it has no value
   */
  public synchronized KrlValue read(VariablePath path) throws RefusedException {
    VariableEntry variable = variables.get(path.first().name());
    if (variable == null) {
      return around(path).read(path);
    }
    Storage contents = variable.current();
    return contents == null ? variable.wiring(path).value(this) : contents.read(path).value();
  }

  /**
   * Reads a value as a controller prints it.
   *
   * @param path what to read
   * @return the text
   * @throws RefusedException if there is no such variable, or it has no value
   */
  public synchronized String print(VariablePath path) throws RefusedException {
    VariableEntry variable = variables.get(path.first().name());
    if (variable == null) {
      return around(path).print(path);
    }
    Storage contents = variable.current();
    return contents == null
        ? variable.wiring(path).value(this).print()
        : contents.read(path).text();
  }

  /**
   * Gives the contents of a variable or of a part of it, with or without a value. It never changes.
   *
   * @param path a variable that is no SIGNAL, or a part of it
   * @return the contents
   * @throws RefusedException if there is no such variable
   */
  public synchronized Storage storage(VariablePath path) throws RefusedException {
    VariableEntry variable = variables.get(path.first().name());
    if (variable == null) {
      return around(path).storage(path);
    }
    Storage contents = variable.current();
    if (contents == null) {
      throw new RefusedException(Refusal.UNKNOWN_VARIABLE, variable.name() + " is a SIGNAL");
    }
    return contents.read(path);
  }

  /**
   * Gives the contents of a whole variable, also of an array, with or without a value.
   *
   * @param name a variable of this scope that is no SIGNAL, without index
   * @return the contents
   * @throws RefusedException if there is no such variable
   */
  public synchronized Storage contents(String name) throws RefusedException {
    Storage contents = find(key(name)).current();
    if (contents == null) {
      throw new RefusedException(Refusal.UNKNOWN_VARIABLE, name + " is a SIGNAL");
    }
    return contents;
  }

  private Scope around(VariablePath path) throws RefusedException {
    if (parent == null) {
      throw new RefusedException(Refusal.UNKNOWN_VARIABLE, "no variable " + path.first().name());
    }
    return parent;
  }

  private VariableEntry find(String key) throws RefusedException {
    VariableEntry variable = variables.get(key);
    if (variable == null) {
      throw new RefusedException(Refusal.UNKNOWN_VARIABLE, "no variable " + key);
    }
    return variable;
  }

  /**
   * Writes a value; an aggregate changes the fields it has, a whole array takes all elements or one
   * value for every element.
   *
   * @param path what to write
   * @param value the value
   * @param writer who writes
   * @throws RefusedException if there is no such variable, it must not be written, or the value is
   *     not of its type; then nothing has changed
   */
  public synchronized void write(VariablePath path, KrlValue value, Writer writer)
      throws RefusedException {
    VariableEntry variable = variables.get(path.first().name());
    if (variable == null) {
      around(path).write(path, value, writer);
      return;
    }
    if (writer != Writer.SYSTEM) {
      if (variable.access() == Access.READ_ONLY) {
        throw new RefusedException(Refusal.READ_ONLY, "may only be read");
      }
      Guard guard = guards.get(path.first().name());
      if (guard != null) {
        guard.check(path, value);
      }
    }
    assign(path, variable, value, writer);
  }

  private void assign(VariablePath path, VariableEntry variable, KrlValue value, Writer writer)
      throws RefusedException {
    Storage contents = variable.contents();
    if (contents == null) {
      assignWired(variable.wiring(path), value, writer);
      return;
    }
    String key = path.first().name();
    if (writer == Writer.CLIENT) {
      if (contents.read(path) instanceof ArrayStorage) {
        // before KSS 8 no array can be set as a whole (docs/reference/krl-values.md#arrays);
        // assumed for later versions
        throw new RefusedException(Refusal.WHOLE_ARRAY, "an array is written by element");
      }
    }
    if (writer != Writer.SYSTEM) {
      Index index = path.first().index();
      if (key.equals(OUTPUTS) && index.count() > 0 && systemOutputs().get(index.number(0))) {
        // outputs that system signals use cannot be set (unconfirmed,
        // docs/reference/krl-values.md#signals-and-inputs); for programs assumed
        throw new RefusedException(Refusal.READ_ONLY, "is used by a system signal");
      }
    }
    variables.put(
        key,
        variable.with(
            writer == Writer.PROGRAM ? contents.store(path, value) : contents.write(path, value)));
  }

  // signals

  /**
   * Says whether a variable is a SIGNAL.
   *
   * @param name a variable of this scope, without index
   * @return whether it is one
   */
  public synchronized boolean isSignal(String name) {
    VariableEntry variable = variables.get(key(name));
    return variable != null && variable.signal() != null;
  }

  /**
   * Says what a SIGNAL is wired to.
   *
   * @param name a variable's name, without index, here or around
   * @return {@code $IN}, {@code $OUT} or another array in upper case; nothing if the variable is no
   *     SIGNAL or not wired
   */
  public synchronized Optional<String> wiredArray(String name) {
    VariableEntry variable = variables.get(key(name));
    if (variable == null) {
      return parent == null ? Optional.empty() : parent.wiredArray(name);
    }
    SignalWiring signal = variable.signal();
    return signal == null ? Optional.empty() : Optional.ofNullable(signal.array());
  }

  /**
   * Says which input or output a SIGNAL is.
   *
   * @param name a variable's name, without index, here or around
   * @return its number; nothing if the variable is no SIGNAL, is not wired or stands for several
   */
  public synchronized OptionalInt wiredElement(String name) {
    VariableEntry variable = variables.get(key(name));
    if (variable == null) {
      return parent == null ? OptionalInt.empty() : parent.wiredElement(name);
    }
    SignalWiring signal = variable.signal();
    return signal == null || signal.array() == null || !signal.isSingle()
        ? OptionalInt.empty()
        : OptionalInt.of(signal.first());
  }

  private synchronized void assignWired(SignalWiring signal, KrlValue value, Writer writer)
      throws RefusedException {
    String array = signal.array();
    if (array == null) {
      throw new RefusedException(Refusal.READ_ONLY, "is not wired");
    }
    if (parent != null && !variables.containsKey(array)) {
      parent.assignWired(signal, value, writer);
      return;
    }
    VariableEntry target = find(array);
    if (writer != Writer.SYSTEM && target.access() == Access.READ_ONLY) {
      throw new RefusedException(Refusal.READ_ONLY, array + " may only be read");
    }
    int index = signal.first();
    for (KrlValue element : signal.elements(value)) {
      try {
        assign(VariablePath.element(array, index++), find(array), element, writer);
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
      for (VariableEntry variable : variables.values()) {
        SignalWiring signal = variable.signal();
        if (signal != null && variable.name().startsWith("$") && OUTPUTS.equals(signal.array())) {
          known.set(signal.first(), signal.last() + 1);
        }
      }
      systemOutputs = known;
    }
    return known;
  }
}
