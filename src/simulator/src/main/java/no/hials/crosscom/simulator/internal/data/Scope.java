package no.hials.crosscom.simulator.internal.data;

import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.Refusal;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Holds types and variables, and looks up the rest in the scope around it: the scope of a routine
 * is in that of its module, which is in the globals of the controller.
 *
 * <p>Thread-safe; every access is atomic. The class is long because each operation on a variable
 * works under its one lock.
 */
public final class Scope {
  /**
   * The bytes that all variables of a controller can take, about, so that data lists and programs
   * of a client cannot fill the memory; assumed.
   */
  static final long MAX_BYTES = 128L << 20;

  /** The bytes of a name with its entry in a map, about. */
  static final long NAME_BYTES = 256;

  private static final String OUTPUTS = "$OUT";

  /** The writers of a variable, which differ in what they may write. */
  public enum Writer {
    /** A client over the network: needs the access right and writes arrays by element only. */
    CLIENT,
    /** A KRL program: needs the access right. */
    PROGRAM,
    /** The controller itself, a data list or Java code: may write everything. */
    SYSTEM
  }

  /** Checks the values that clients and programs write, beyond their type. */
  @FunctionalInterface
  public interface Guard {
    /**
     * Checks a value before it is written.
     *
     * @param path the target, starting with the name of the variable
     * @throws RefusedException if the value is not allowed
     */
    void check(VariablePath path, KrlValue value) throws RefusedException;
  }

  private final @Nullable Scope parent;
  private final long maxBytes;
  private final Map<String, Type> types = new HashMap<>();
  private final Map<String, VariableEntry> variables = new HashMap<>();
  private final Map<String, Guard> guards = new HashMap<>();

  /** The data lists of GLOBAL variables by the keys of these; not of a copied table. */
  private final Map<String, String> owners = new HashMap<>();

  /** The outputs that system signals are wired to; null if unknown. */
  private @Nullable BitSet systemOutputs;

  /** The values that the present attempt has replaced; null outside of an attempt. */
  private @Nullable Undo undo;

  /** The bytes of the variables and types of this scope. */
  private long bytes;

  /** The bytes of the scopes in this one that are kept: modules, and routines. */
  private long moduleBytes;

  private long routineBytes;

  /**
   * The old types and variables by their keys, empty for new ones. Copies of all would take most of
   * the time in which an archive of many files is loaded.
   */
  private record Undo(
      Map<String, Optional<Type>> types, Map<String, Optional<VariableEntry>> variables) {}

  /** Creates an outermost scope, which contains only the base types. */
  public Scope() {
    this(MAX_BYTES);
  }

  Scope(long maxBytes) {
    parent = null;
    this.maxBytes = maxBytes;
    for (Type.Base type : Type.Base.values()) {
      types.put(type.name(), type);
    }
  }

  public Scope(Scope parent) {
    this.parent = parent;
    maxBytes = parent.maxBytes;
  }

  /**
   * Copies all types, variables and guards of another scope. A bound variable gets its declared
   * value, and is not bound here.
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
      bytes =
          variables.values().stream().mapToLong(VariableEntry::bytes).sum()
              + types.values().stream().mapToLong(Type::definitionBytes).sum();
    }
  }

  // memory

  /** Returns the bytes of the variables and types of this scope. */
  public synchronized long bytes() {
    return bytes;
  }

  /** Sets the bytes of the modules in this scope. */
  public synchronized void moduleBytes(long sum) {
    moduleBytes = sum;
  }

  /** Sets the bytes of the routines in this scope. */
  public synchronized void routineBytes(long sum) {
    routineBytes = sum;
  }

  private synchronized long used() {
    return bytes + moduleBytes + routineBytes + (parent == null ? 0 : parent.used());
  }

  static String tooLarge(String what, long bytes) {
    return tooLarge(what, bytes, MAX_BYTES);
  }

  private static String tooLarge(String what, long bytes, long maximum) {
    return "all variables together have at most "
        + maximum
        + " bytes of memory, "
        + what
        + " needs "
        + bytes;
  }

  /**
   * Checks that there is room for a variable, which can replace one of the same name. To be called
   * before its contents are created.
   *
   * @param type null for a SIGNAL
   */
  synchronized void checkRoom(String name, @Nullable DeclaredType type, Position position)
      throws KrlErrorException {
    VariableEntry old = variables.get(key(name));
    long needed = NAME_BYTES + (type == null ? 0 : type.bytes());
    if (isTooMuch(needed - (old == null ? 0 : old.bytes()))) {
      throw new KrlErrorException(position, tooLarge(name, needed, maxBytes));
    }
  }

  private boolean isTooMuch(long more) {
    return more > 0 && used() + more > maxBytes;
  }

  // declarations

  /** Returns a name as a key of the maps: without blanks around it, in upper case. */
  public static String key(String name) {
    return name.strip().toUpperCase(Locale.ROOT);
  }

  private static void checkTypeName(String name) {
    if (!VariablePath.isName(name)) {
      throw new IllegalArgumentException("a type's name is a KRL name, is '" + name + "'");
    }
    for (Type.Base type : Type.Base.values()) {
      if (type.name().equalsIgnoreCase(name)) {
        throw new IllegalArgumentException(name + " is a base type of KRL");
      }
    }
  }

  /**
   * Declares a type. Replaces a type of the same name; variables keep their type.
   *
   * @throws IllegalArgumentException if the name is not a name of KRL, or is a base type, or there
   *     is no room for the type
   */
  synchronized void declareType(Type type) {
    checkTypeName(type.name());
    Type old = types.get(key(type.name()));
    long more = type.definitionBytes() - (old == null ? 0 : old.definitionBytes());
    if (isTooMuch(more)) {
      throw new IllegalArgumentException(
          tooLarge("type " + type.name(), type.definitionBytes(), maxBytes));
    }
    types.put(key(type.name()), type);
    if (undo != null) {
      undo.types().putIfAbsent(key(type.name()), Optional.ofNullable(old));
    }
    bytes += more;
  }

  /** Returns whether a type is declared here or around. */
  public synchronized boolean knowsType(String name) {
    return types.containsKey(key(name)) || (parent != null && parent.knowsType(name));
  }

  /**
   * Returns a variable without a value.
   *
   * @param type the name of its type, which must be declared
   */
  public Storage uninitialised(String type) {
    return type(type).uninitialised();
  }

  /**
   * Returns a type that is declared here or around.
   *
   * @throws IllegalArgumentException if it is not declared
   */
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

  /** Returns a type that is declared here; null if it is not. */
  synchronized @Nullable Type ownType(String name) {
    return types.get(key(name));
  }

  /**
   * Changes a type in the variables and structures of this scope; the parts of both types keep
   * their values.
   */
  synchronized void retype(Type old, Type type) {
    retype(old, type, new HashSet<>());
  }

  private void retype(Type old, Type type, Set<String> done) {
    done.add(key(type.name()));
    for (VariableEntry variable : variables()) {
      Storage contents = variable.contents();
      if (contents != null && variable.source() == null && contents.type().equals(old)) {
        DeclaredType declared = new DeclaredType(type, DeclaredType.of(contents).dimensions());
        if (!isTooMuch(declared.bytes() - contents.bytes())) {
          put(variable.with(declared.uninitialised().takeOver(contents)));
        }
      }
    }
    for (Type other : types()) {
      if (other instanceof Type.Struc struc
          && struc.elements().contains(old)
          && !done.contains(key(struc.name()))) {
        Type.Struc changed = struc.with(old, type);
        declareType(changed);
        retype(struc, changed, done);
      }
    }
  }

  /** Declares a variable. Replaces a variable of the same name in this scope. */
  synchronized void put(VariableEntry variable) {
    VariableEntry old = replace(key(variable.name()), variable);
    bytes += variable.bytes() - (old == null ? 0 : old.bytes());
    systemOutputs = null;
  }

  /** Replaces or removes a variable; returns the old one. */
  private @Nullable VariableEntry replace(String key, @Nullable VariableEntry variable) {
    VariableEntry old = variable == null ? variables.remove(key) : variables.put(key, variable);
    if (undo != null) {
      undo.variables().putIfAbsent(key, Optional.ofNullable(old));
    }
    return old;
  }

  /** Notes the data list that declares a variable of this scope. */
  synchronized void setOwner(String name, String list) {
    owners.put(key(name), list);
  }

  /** Returns the data list that declares a variable of this scope; null if none was loaded. */
  synchronized @Nullable String owner(String name) {
    return contains(name) ? owners.get(key(name)) : null;
  }

  /** Returns the warning of a system variable that is not known. */
  public static String notKnown(String name) {
    return "the system variable " + name + " is not known; it keeps what is written to it";
  }

  /**
   * Declares a variable whose type is not known, such as a system variable that no data list
   * declares. It has no value, and keeps what is written to it.
   *
   * @throws KrlErrorException if there is no room
   */
  public synchronized void declareUntyped(String name, Position position) throws KrlErrorException {
    checkRoom(name, new DeclaredType(Type.Undeclared.UNKNOWN, List.of()), position);
    put(VariableEntry.variable(name, Access.READ_WRITE, UntypedStorage.EMPTY));
  }

  /** Removes a variable of this scope; returns false if it is not declared here. */
  public synchronized boolean remove(String name) {
    systemOutputs = null;
    VariableEntry old = replace(key(name), null);
    bytes -= old == null ? 0 : old.bytes();
    return old != null;
  }

  /** Returns whether this scope itself declares a variable. The name has no index. */
  public synchronized boolean contains(String name) {
    return variables.containsKey(key(name));
  }

  /** Returns whether a variable is declared here or around. The name has no index. */
  public synchronized boolean knows(String name) {
    return lookup(key(name)) != null;
  }

  /** Returns a copy of the variables of this scope, in any order. */
  synchronized List<VariableEntry> variables() {
    return List.copyOf(variables.values());
  }

  /** Returns a copy of the types of this scope, in any order. */
  synchronized List<Type> types() {
    return List.copyOf(types.values());
  }

  /** Returns a variable that is declared here or around, by its key; null if it is not declared. */
  synchronized @Nullable VariableEntry lookup(String key) {
    VariableEntry variable = variables.get(key);
    return variable != null || parent == null ? variable : parent.lookup(key);
  }

  /** Returns a sorted copy of the names of this scope, as declared, without dimensions. */
  public synchronized SortedSet<String> names() {
    SortedSet<String> names = new TreeSet<>();
    for (VariableEntry variable : variables.values()) {
      names.add(variable.name());
    }
    return names;
  }

  /**
   * Binds a variable to a source, which is called at each read.
   *
   * @param name a variable of this scope, without index
   * @param value returns the whole value; called under the lock of this scope, so it must not block
   */
  public synchronized void bind(String name, Supplier<KrlValue> value) {
    VariableEntry variable = variables.get(key(name));
    if (variable == null || variable.contents() == null) {
      throw new IllegalArgumentException(name + " is not a variable that can be bound");
    }
    replace(key(name), variable.bound(value));
  }

  /**
   * Guards a variable of this scope.
   *
   * @param name the variable, without index
   * @param guard called before each write of a client or a program, under the lock of this scope
   */
  public synchronized void guard(String name, Guard guard) {
    guards.put(key(name), guard);
  }

  /**
   * Makes several changes in one atomic step, or none of them.
   *
   * @param change makes the changes; returns false to undo them. It must be quick
   * @return the result of {@code change}
   */
  public synchronized boolean attempt(BooleanSupplier change) {
    if (undo != null) {
      throw new IllegalStateException("an attempt in an attempt");
    }
    Undo replaced = new Undo(new HashMap<>(), new HashMap<>());
    long oldBytes = bytes;
    boolean done = false;
    undo = replaced;
    try {
      done = change.getAsBoolean();
    } finally {
      undo = null;
      if (!done) {
        restore(types, replaced.types());
        restore(variables, replaced.variables());
        bytes = oldBytes;
        systemOutputs = null;
      }
    }
    return done;
  }

  private static <V> void restore(Map<String, V> map, Map<String, Optional<V>> replaced) {
    replaced.forEach(
        (key, old) -> old.ifPresentOrElse(it -> map.put(key, it), () -> map.remove(key)));
  }

  // access

  /**
   * Returns the value of a variable or of a part of it.
   *
   * @throws RefusedException if it is not declared or has no value
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
   * Returns the value of a variable or of a part of it, as a controller prints it.
   *
   * @throws RefusedException if it is not declared or has no value
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
   * Returns the contents of a variable or of a part of it, with or without a value.
   *
   * @param path a variable other than a SIGNAL, or a part of it
   * @throws RefusedException if it is not declared
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
   * Returns the contents of a whole variable, which can be an array, with or without a value.
   *
   * @param name a variable of this scope other than a SIGNAL, without index
   * @throws RefusedException if it is not declared
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
   * Writes a value. An aggregate changes the fields it contains; a whole array takes all its
   * elements or one value for every element.
   *
   * @throws RefusedException if the target is not declared, must not be written, or has another
   *     type; then nothing has changed
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
    if (contents instanceof UntypedStorage) {
      putUntyped(variable.with(contents.write(path, value)));
      return;
    }
    if (writer == Writer.CLIENT && contents.read(path) instanceof ArrayStorage) {
      // before KSS 8 no array can be set as a whole (docs/reference/krl-values.md#arrays);
      // assumed for later versions
      throw new RefusedException(Refusal.WHOLE_ARRAY, "an array is written by element");
    }
    if (writer != Writer.SYSTEM) {
      Index index = path.first().index();
      if (key.equals(OUTPUTS) && index.count() > 0 && systemOutputs().get(index.number(0))) {
        // outputs that system signals use cannot be set (unconfirmed,
        // docs/reference/krl-values.md#signals-and-inputs); for programs assumed
        throw new RefusedException(Refusal.READ_ONLY, "is used by a system signal");
      }
    }
    replace(
        key,
        variable.with(
            writer == Writer.PROGRAM ? contents.store(path, value) : contents.write(path, value)));
  }

  /** Stores a variable of unknown type, whose size depends on its value. */
  private void putUntyped(VariableEntry variable) throws RefusedException {
    VariableEntry old = find(key(variable.name()));
    if (isTooMuch(variable.bytes() - old.bytes())) {
      throw new RefusedException(
          Refusal.OUT_OF_RANGE, tooLarge(variable.name(), variable.bytes(), maxBytes));
    }
    put(variable);
  }

  // signals

  /** Returns whether a variable of this scope is a SIGNAL. The name has no index. */
  public synchronized boolean isSignal(String name) {
    VariableEntry variable = variables.get(key(name));
    return variable != null && variable.signal() != null;
  }

  /**
   * Returns the array that a SIGNAL is wired to: {@code $IN}, {@code $OUT} or another one, in upper
   * case.
   *
   * @param name a variable, here or around, without index
   * @return empty if the variable is not a SIGNAL or not wired
   */
  public synchronized Optional<String> wiredArray(String name) {
    return Optional.ofNullable(wiring(name)).map(SignalWiring::array);
  }

  /**
   * Returns the number of the input or output that a SIGNAL is wired to.
   *
   * @param name a variable, here or around, without index
   * @return empty if the variable is not a SIGNAL, is not wired or is wired to several
   */
  public synchronized OptionalInt wiredElement(String name) {
    SignalWiring signal = wiring(name);
    return signal == null || signal.array() == null || signal.isGroup()
        ? OptionalInt.empty()
        : OptionalInt.of(signal.first());
  }

  private @Nullable SignalWiring wiring(String name) {
    VariableEntry variable = lookup(key(name));
    return variable == null ? null : variable.signal();
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
        replace(array, target); // all bits or none
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
