package no.hials.crosscom.cell;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiPredicate;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.DeclarationVisitor;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.VariableNote;
import org.jspecify.annotations.Nullable;

/**
 * The variables of a controller with their types, units, access and meaning. Names are found in any
 * case. Immutable.
 */
public final class Catalogue {
  /** The data lists of the simulated controller, in the order of their dependencies. */
  private static final List<String> BUILT_IN =
      List.of("$TYPES.DAT", "$OPERATE.DAT", "$MACHINE.DAT", "$CONFIG.DAT");

  private static final String ASSUMED = "assumed";

  private final Map<String, CatalogueEntry> variables = new TreeMap<>();
  private final Map<String, List<CatalogueEntry>> structures = new TreeMap<>();
  private final Map<String, List<String>> enumerations = new TreeMap<>();
  private final Map<Wires, SortedSet<String>> signals = new TreeMap<>();

  private Catalogue() {}

  /** Returns the system variables of a controller, with their types. Takes some 100 ms. */
  public static Catalogue system() {
    Catalogue catalogue = new Catalogue();
    for (String file : BUILT_IN) {
      catalogue.add(file, resource(file), Catalogue::isSystemVariable);
    }
    catalogue.signals.clear(); // those of one robot
    return catalogue;
  }

  /** Returns the variables of a simulated controller, with their types. */
  public static Catalogue of(String dataList) {
    Catalogue catalogue = new Catalogue();
    catalogue.add("$VARIABLES.DAT", dataList, (name, note) -> true);
    return catalogue;
  }

  /** Returns whether real controllers have a variable, not only the simulated one. */
  private static boolean isSystemVariable(String name, VariableNote note) {
    return name.startsWith("$") || !note.source().equals(ASSUMED);
  }

  private static String resource(String file) {
    try (InputStream in = Catalogue.class.getResourceAsStream(file)) {
      return new String(
          Objects.requireNonNull(in, file).readAllBytes(), StandardCharsets.ISO_8859_1);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void add(String file, String text, BiPredicate<String, VariableNote> shown) {
    KrlParser.parse(file, text)
        .file()
        .filter(DataList.class::isInstance)
        .ifPresent(list -> add((DataList) list, "", Access.READ_WRITE, shown));
  }

  /**
   * Returns this catalogue with the declarations of data lists. Known variables stay, since they
   * have unit and access.
   *
   * @param lists the data lists by their files
   */
  public Catalogue plus(Map<String, DataList> lists) {
    Catalogue all = new Catalogue();
    all.variables.putAll(variables);
    all.structures.putAll(structures);
    all.enumerations.putAll(enumerations);
    signals.forEach((name, names) -> all.signals.put(name, new TreeSet<>(names)));
    lists.forEach((origin, list) -> all.add(list, origin, null, (name, note) -> true));
    return all;
  }

  /**
   * Adds the declarations of a data list.
   *
   * @param access the access to variables whose comment does not name it; null if unknown
   * @param shown selects variables by their name and comment
   */
  private void add(
      DataList list,
      String origin,
      @Nullable Access access,
      BiPredicate<String, VariableNote> shown) {
    Collector collector = new Collector(list, origin, access, shown);
    list.declarations().forEach(declaration -> declaration.accept(collector));
  }

  /** Adds the declarations of a data list, and returns whether the catalogue can show the kind. */
  private final class Collector implements DeclarationVisitor<Boolean> {
    private final DataList list;
    private final String origin;
    private final @Nullable Access access;
    private final BiPredicate<String, VariableNote> shown;
    private final boolean system;

    Collector(
        DataList list,
        String origin,
        @Nullable Access access,
        BiPredicate<String, VariableNote> shown) {
      this.list = list;
      this.origin = origin;
      this.access = access;
      this.shown = shown;
      this.system = list.name().startsWith("$");
    }

    @Override
    public Boolean visit(Declaration.StrucDeclaration struc) {
      structures.putIfAbsent(
          key(struc.name()),
          struc.components().stream()
              .map(part -> entry(part.type(), part.declarator(), VariableNote.NONE, origin, null))
              .toList());
      return true;
    }

    @Override
    public Boolean visit(Declaration.EnumDeclaration enumeration) {
      List<String> constants = enumeration.constants();
      enumerations.putIfAbsent(
          key(enumeration.name()),
          origin.isEmpty() ? constants.stream().sorted().toList() : constants);
      return true;
    }

    @Override
    public Boolean visit(Declaration.Signal signal) {
      addSignal(signal);
      if (system) {
        VariableNote note = VariableNote.of(signal.comment());
        add(entry("SIGNAL", signal.name(), List.of(), note, origin, access), note, shown);
      }
      return true;
    }

    @Override
    public Boolean visit(Declaration.Variables group) {
      if (system || (list.isPublic() && group.global())) {
        VariableNote note = VariableNote.of(group.comment());
        group
            .variables()
            .forEach(one -> add(entry(group.type(), one, note, origin, access), note, shown));
      }
      return true;
    }

    /** Sets the value of a variable that is declared elsewhere. */
    @Override
    public Boolean visit(Declaration.InitialValue initial) {
      return false;
    }

    /** A channel is not a variable. */
    @Override
    public Boolean visit(Declaration.Channel channel) {
      return false;
    }

    /** The data list of the other module declares it. */
    @Override
    public Boolean visit(Declaration.External external) {
      return false;
    }
  }

  private void addSignal(Declaration.Signal signal) {
    Wire first = Wire.of(signal.first());
    Wire last = signal.last() == null ? first : Wire.of(signal.last());
    if (first != null
        && last != null
        && first.array.equals(last.array)
        && first.number <= last.number) {
      signals
          .computeIfAbsent(new Wires(first.array, first.number, last.number), it -> new TreeSet<>())
          .add(signal.name());
    }
  }

  /** An input or output. */
  private record Wire(String array, int number) {
    /** Returns the wire that a variable names; null if it is not an element with a number. */
    static @Nullable Wire of(Expression.@Nullable Variable variable) {
      if (variable == null || variable.steps().size() != 1) {
        return null;
      }
      Expression.Step step = variable.steps().get(0);
      return step.indices().size() == 1
              && !step.open()
              && step.indices().get(0) instanceof Expression.IntLiteral index
          ? new Wire(key(step.name()), index.value())
          : null;
    }
  }

  /** Elements of an array, sorted by array and number. */
  private record Wires(String array, int first, int last) implements Comparable<Wires> {
    private static final Comparator<Wires> ORDER =
        Comparator.comparing(Wires::array).thenComparing(Wires::first).thenComparing(Wires::last);

    @Override
    public int compareTo(Wires other) {
      return ORDER.compare(this, other);
    }
  }

  private void add(
      CatalogueEntry entry, VariableNote note, BiPredicate<String, VariableNote> shown) {
    if (shown.test(entry.name(), note)) {
      variables.putIfAbsent(key(entry.name()), entry);
    }
  }

  private static CatalogueEntry entry(
      String type,
      Declaration.Declarator declarator,
      VariableNote note,
      String origin,
      @Nullable Access access) {
    List<Integer> dimensions = new ArrayList<>();
    for (Expression length : declarator.dimensions()) {
      dimensions.add(length instanceof Expression.IntLiteral number ? number.value() : 0);
    }
    return entry(type, declarator.name(), List.copyOf(dimensions), note, origin, access);
  }

  private static CatalogueEntry entry(
      String type,
      String name,
      List<Integer> dimensions,
      VariableNote note,
      String origin,
      @Nullable Access access) {
    return new CatalogueEntry(
        name,
        type.toUpperCase(Locale.ROOT),
        dimensions,
        note.access() == null ? access : note.access(),
        note.unit(),
        note.meaning(),
        origin);
  }

  public Collection<CatalogueEntry> variables() {
    return variables.values();
  }

  /**
   * Finds the variable, field or element that a path names. An element has no dimensions.
   *
   * @param path the path, such as {@code LOAD_DATA[1].CM.X}
   */
  public Optional<CatalogueEntry> find(String path) {
    CatalogueEntry found = null;
    String prefix = "";
    for (String step : path.split("\\.", -1)) {
      int bracket = step.indexOf('[');
      String name = bracket < 0 ? step : step.substring(0, bracket);
      found =
          found == null && prefix.isEmpty() ? variables.get(key(name)) : field(found, name, prefix);
      if (found == null) {
        return Optional.empty();
      }
      prefix = prefix.isEmpty() ? found.name() : prefix + "." + found.name();
      if (bracket >= 0) {
        found = element(found, step.substring(bracket));
        prefix += step.substring(bracket);
      }
    }
    return Optional.ofNullable(found);
  }

  private @Nullable CatalogueEntry field(
      @Nullable CatalogueEntry struct, String name, String prefix) {
    if (struct == null) {
      return null;
    }
    return fields(struct).stream()
        .filter(field -> field.name().equalsIgnoreCase(name))
        .map(field -> inside(struct, field, prefix))
        .findFirst()
        .orElse(null);
  }

  private static CatalogueEntry inside(CatalogueEntry struct, CatalogueEntry field, String prefix) {
    String meaning = "field of " + prefix + (struct.meaning().isEmpty() ? "" : ": ");
    return new CatalogueEntry(
        field.name(),
        field.type(),
        field.dimensions(),
        struct.access(),
        "",
        meaning + struct.meaning(),
        struct.origin());
  }

  private static CatalogueEntry element(CatalogueEntry array, String brackets) {
    boolean whole = brackets.startsWith("[]");
    return new CatalogueEntry(
        array.name(),
        array.type(),
        whole ? array.dimensions() : List.of(),
        array.access(),
        array.unit(),
        array.meaning(),
        array.origin());
  }

  /** Returns the fields of a structure; empty for other types. */
  public List<CatalogueEntry> fields(CatalogueEntry symbol) {
    return structures.getOrDefault(key(symbol.type()), List.of());
  }

  /** Returns the constants of an enumeration without {@code #}; empty for other types. */
  public List<String> constants(CatalogueEntry symbol) {
    return symbol.type().equals("BOOL")
        ? List.of()
        : enumerations.getOrDefault(key(symbol.type()), List.of());
  }

  /**
   * Returns the names of inputs and outputs, in the order of arrays and numbers. Signals that do
   * not stand for elements of one array with literal numbers are left out, and so are those whose
   * last number is below the first. Those of {@link #system} are empty, since each controller has
   * its own.
   */
  public List<SignalWires> signals() {
    return signals.entrySet().stream()
        .map(
            entry -> {
              Wires wires = entry.getKey();
              return new SignalWires(
                  wires.array, wires.first, wires.last, List.copyOf(entry.getValue()));
            })
        .toList();
  }

  private static String key(String name) {
    return name.toUpperCase(Locale.ROOT);
  }
}
