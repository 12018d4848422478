package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.lang.VariableNote;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.simulator.RefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Writes types and variables as a system data list that {@link DataListLoader} can load: REALs with
 * all their digits, arrays by element, and variables without a value without one.
 */
public final class DataListWriter {
  private static final TypeSwitch<DataListWriter, Type, Void, RuntimeException> TYPES =
      TypeSwitch.create(
          Type.class,
          cases ->
              cases
                  .run(Type.Base.class, (writer, type) -> {}) // every controller has them
                  .run(Type.Undeclared.class, (writer, type) -> {})
                  .run(Type.Enumeration.class, DataListWriter::declareEnum)
                  .run(Type.Struc.class, DataListWriter::declareStruc));

  private static final TypeSwitch<String, Storage, Optional<String>, RuntimeException> INLINE =
      TypeSwitch.create(
          Storage.class,
          cases ->
              cases
                  .on(ScalarStorage.class, DataListWriter::inlineCoded)
                  .on(TextStorage.class, DataListWriter::inlineScalar)
                  .on(StrucStorage.class, DataListWriter::inlineParts)
                  .on(ArrayStorage.class, (path, array) -> Optional.empty())
                  .on(UntypedStorage.class, (path, untyped) -> Optional.empty()));

  /** The line end of KSS (docs/reference/krl-language.md#files). */
  private static final String LINE_END = "\r\n";

  private final StringBuilder out = new StringBuilder();
  private final Map<String, VariableNote> notes;

  private DataListWriter(Map<String, VariableNote> notes) {
    this.notes = notes;
  }

  /**
   * Returns the text of a data list.
   *
   * @param name its name, with {@code $}
   * @param chosen the names of the variables to write, in upper case; null for all variables and
   *     all types
   * @param notes the notes of the variables, by their names in upper case
   * @throws IllegalStateException if a value cannot be written in a data list
   */
  public static String write(
      String name,
      Scope scope,
      @Nullable Collection<String> chosen,
      Map<String, VariableNote> notes) {
    DataListWriter writer = new DataListWriter(notes);
    synchronized (scope) {
      writer.list(name, scope, chosen);
    }
    return writer.out.toString();
  }

  private void list(String name, Scope scope, @Nullable Collection<String> chosen) {
    List<VariableEntry> variables = new ArrayList<>(scope.variables());
    variables.removeIf(v -> chosen != null && !chosen.contains(Scope.key(v.name())));
    variables.sort(Comparator.comparing(VariableEntry::name));
    Map<VariableEntry, Storage> contents = new LinkedHashMap<>();
    List<VariableEntry> signals = new ArrayList<>();
    Map<String, Type> types = new LinkedHashMap<>();
    if (chosen == null) {
      List<Type> all = new ArrayList<>(scope.types());
      all.sort(Comparator.comparing(Type::name));
      all.forEach(type -> collect(type, types));
    }
    for (VariableEntry variable : variables) {
      Storage storage = current(variable);
      if (storage == null) {
        signals.add(variable);
      } else {
        contents.put(variable, storage);
        collect(DeclaredType.of(storage).element(), types);
      }
    }

    line("&ACCESS RVP");
    line("DEFDAT " + name + " PUBLIC");
    fold("TYPES", () -> types.values().forEach(type -> TYPES.run(this, type)));
    fold("VARIABLES", () -> contents.forEach(this::declareVariable));
    fold("SIGNALS", () -> signals.forEach(this::declareSignal));
    line("ENDDAT");
  }

  private static @Nullable Storage current(VariableEntry variable) {
    try {
      return variable.current();
    } catch (RefusedException e) {
      throw new IllegalStateException(
          variable.name() + " is bound to a value of another type: " + e.getMessage(), e);
    }
  }

  private void line(String text) {
    out.append(text).append(LINE_END);
  }

  private void fold(String title, Runnable contents) {
    line(";FOLD " + title);
    contents.run();
    line(";ENDFOLD (" + title + ")");
  }

  private String comment(VariableEntry variable, Access access) {
    String text = notes.getOrDefault(Scope.key(variable.name()), VariableNote.NONE).comment(access);
    return text.isEmpty() ? "" : " ;" + text;
  }

  // types

  /** Collects a type, after the types of its components. */
  private static void collect(Type type, Map<String, Type> types) {
    if (type instanceof Type.Base || type instanceof Type.Undeclared) {
      return;
    }
    type.elements().forEach(element -> collect(element, types));
    Type known = types.putIfAbsent(Scope.key(type.name()), type);
    if (known != null && !known.equals(type)) {
      throw new IllegalStateException(
          "a data list declares a type once, and variables have two types " + type.name());
    }
  }

  private void declareEnum(Type.Enumeration type) {
    TreeSet<String> constants = new TreeSet<>();
    type.constants().values().forEach(constant -> constants.add(constant.name()));
    line("ENUM " + type.name() + " " + String.join(",", constants));
  }

  private void declareStruc(Type.Struc type) {
    StringBuilder text = new StringBuilder("STRUC " + type.name());
    String before = "";
    String separator = " ";
    for (Type.Component component : type.components()) {
      String own = component.type().element().name();
      text.append(separator).append(own.equals(before) ? "" : own + " ");
      text.append(component.name()).append(component.type().printDimensions());
      before = own;
      separator = ",";
    }
    line(text.toString());
  }

  // variables

  private void declareSignal(VariableEntry variable) {
    SignalWiring signal = variable.signal();
    if (signal != null) {
      line("SIGNAL " + variable.name() + " " + signal + comment(variable, variable.access()));
    }
  }

  private void declareVariable(VariableEntry variable, Storage contents) {
    if (contents instanceof UntypedStorage untyped) {
      assign(variable.name(), untyped);
      return;
    }
    DeclaredType shape = DeclaredType.of(contents);
    String name = variable.name();
    ArrayStorage array = contents instanceof ArrayStorage elements ? elements : null;
    String value = array == null ? inline(name, contents) : null;
    boolean isText = contents instanceof TextStorage;
    boolean constant =
        variable.access() == Access.READ_ONLY
            && contents instanceof ScalarStorage
            && value != null
            && !name.startsWith("$");
    String filling = array != null && name.startsWith("$") ? filling(name, array) : null;
    String suffix = isText ? null : array == null ? value : filling;
    line(
        (shape.element() instanceof Type.Base ? "" : "DECL ")
            + (constant ? "CONST " : "")
            + shape.element().name()
            + (" " + name + shape.printDimensions())
            + (suffix == null ? "" : "=" + suffix)
            + comment(variable, constant ? Access.READ_WRITE : variable.access()));
    if (isText && value != null) {
      line(name + "[]=" + value);
    }
    if (array != null) {
      elements(name, array, filling);
    } else {
      arraysIn(name, contents);
    }
  }

  /**
   * Returns the value after the equals sign, without the elements of arrays; null if it has no
   * value.
   */
  private static @Nullable String inline(String path, Storage storage) {
    return storage.initialised() ? INLINE.apply(path, storage).orElse(null) : null;
  }

  private static Optional<String> inlineParts(String path, StrucStorage struc) {
    StringBuilder text = new StringBuilder();
    List<Storage> parts = struc.parts();
    for (int i = 0; i < parts.size(); i++) {
      Storage part = parts.get(i);
      String name = struc.type().components().get(i).name();
      String value = inline(path + "." + name, part);
      if (value != null) {
        text.append(text.length() == 0 ? "{" : ",").append(name);
        text.append(part instanceof TextStorage ? "[] " : " ").append(value);
      }
    }
    return text.length() == 0 ? Optional.empty() : Optional.of(text.append('}').toString());
  }

  /** Writes a CHAR that is a line break as its code. */
  private static Optional<String> inlineCoded(String path, ScalarStorage scalar) {
    return value(scalar) instanceof KrlString string && hasLineBreak(string)
        ? Optional.of(Integer.toString(string.text().charAt(0)))
        : inlineScalar(path, scalar);
  }

  private static boolean hasLineBreak(KrlString string) {
    return string.text().chars().anyMatch(c -> c == '\n' || c == '\r');
  }

  private static Optional<String> inlineScalar(String path, Storage storage) {
    return Optional.of(scalar(path, value(storage)));
  }

  private static KrlValue value(Storage storage) {
    try {
      return storage.value();
    } catch (RefusedException e) {
      throw new IllegalStateException("it is initialised: " + e.getMessage(), e);
    }
  }

  private static String scalar(String path, KrlValue value) {
    // KrlString excludes double quotes
    if (value instanceof KrlString string && hasLineBreak(string)) {
      throw new IllegalStateException(
          "a text in a data list has no line break, " + path + " has one");
    }
    return value.printShort();
  }

  /** Writes an assignment for each value of a variable without a declaration. */
  private void assign(String path, UntypedStorage untyped) {
    Map<String, UntypedStorage> parts = untyped.parts();
    if (parts.isEmpty() && untyped.initialised()) {
      String name = untyped.characters().isPresent() && !path.endsWith("]") ? path + "[]" : path;
      line(name + "=" + scalar(path, value(untyped)));
    }
    parts.forEach((name, part) -> assign(path + (untyped.isArray() ? "" : ".") + name, part));
  }

  /** Writes the elements of the arrays in a structure. */
  private void arraysIn(String path, Storage storage) {
    if (!(storage instanceof StrucStorage struc)) {
      return;
    }
    List<Storage> parts = struc.parts();
    for (int i = 0; i < parts.size(); i++) {
      Storage part = parts.get(i);
      String name = path + "." + struc.type().components().get(i).name();
      if (part instanceof ArrayStorage array) {
        elements(name, array, null);
      } else {
        arraysIn(name, part);
      }
    }
  }

  private void elements(String path, ArrayStorage array, @Nullable String filling) {
    for (int i = 0; i < array.count(); i++) {
      Storage element = array.element(i);
      String name = path + new Index(array.indicesOf(i), element instanceof TextStorage);
      String value = inline(name, element);
      if (value != null && !value.equals(filling)) {
        line(name + "=" + value);
      }
      arraysIn(name, element);
    }
  }

  /**
   * Returns the value that most elements of an array have; null if it cannot stand for all of them.
   * An element that is a structure cannot lose a component, so structures must all be equal.
   */
  private static @Nullable String filling(String path, ArrayStorage array) {
    Map<String, Integer> counts = new HashMap<>();
    for (int i = 0; i < array.count(); i++) {
      String value = inline(path, array.element(i));
      if (value == null) {
        return null;
      }
      counts.merge(value, 1, Integer::sum);
    }
    boolean mayDiffer = !(array.element(0) instanceof StrucStorage);
    int needed = mayDiffer ? array.count() / 2 + 1 : array.count();
    for (Map.Entry<String, Integer> entry : counts.entrySet()) {
      if (entry.getValue() >= needed) {
        return entry.getKey();
      }
    }
    return null;
  }
}
