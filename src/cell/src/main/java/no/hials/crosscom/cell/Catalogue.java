package no.hials.crosscom.cell;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Expression;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.simulator.VariableInfo;
import no.hials.crosscom.simulator.VariableTable;
import org.jspecify.annotations.Nullable;

/**
 * Names that the shell knows: variables, and what their types are made of. Names are found in any
 * case. Not changed after it was made.
 */
public final class Catalogue {
  private static final String ASSUMED = "assumed";

  private final Map<String, CatalogueEntry> variables = new TreeMap<>();
  private final Map<String, List<CatalogueEntry>> structures = new TreeMap<>();
  private final Map<String, List<String>> enumerations = new TreeMap<>();

  /** Says whether a variable of the simulated controller is one that controllers have. */
  public static boolean isSystemVariable(VariableInfo info) {
    return info.name().startsWith("$") || !info.source().equals(ASSUMED);
  }

  /** Gives the system variables of a controller, with their types. Takes some 100 ms. */
  public static Catalogue system() {
    return of(VariableTable.krc4(), Catalogue::isSystemVariable);
  }

  /** Gives the variables of a simulated controller. */
  public static Catalogue of(VariableTable table, Predicate<VariableInfo> shown) {
    Catalogue symbols = new Catalogue();
    // the table tells the types in the form of a data list only
    KrlParser.parse("$TYPES.DAT", table.toDataList("$TYPES"))
        .file()
        .filter(DataList.class::isInstance)
        .ifPresent(list -> symbols.add((DataList) list, "", false));
    table.describeAll().stream()
        .filter(shown)
        .forEach(info -> symbols.variables.put(key(info.name()), CatalogueEntry.of(info)));
    return symbols;
  }

  /**
   * Gives these and what data lists of a controller declare. What is known already stays, since it
   * has unit and access.
   *
   * @param lists by the files that they are from
   */
  public Catalogue plus(Map<String, DataList> lists) {
    Catalogue all = new Catalogue();
    all.variables.putAll(variables);
    all.structures.putAll(structures);
    all.enumerations.putAll(enumerations);
    lists.forEach((origin, list) -> all.add(list, origin, true));
    return all;
  }

  private void add(DataList list, String origin, boolean withVariables) {
    boolean system = list.name().startsWith("$");
    for (Declaration declaration : list.declarations()) {
      if (declaration instanceof Declaration.Struc struc) {
        structures.putIfAbsent(
            key(struc.name()),
            struc.components().stream()
                .map(part -> symbol(part.type(), part.declarator(), "", origin))
                .toList());
      } else if (declaration instanceof Declaration.Enumeration enumeration) {
        enumerations.putIfAbsent(key(enumeration.name()), enumeration.constants());
      } else if (declaration instanceof Declaration.Variables group
          && withVariables
          && (system || (list.isPublic() && group.global()))) {
        for (Declaration.Declarator declarator : group.variables()) {
          variables.putIfAbsent(
              key(declarator.name()),
              symbol(group.type(), declarator, group.comment().strip(), origin));
        }
      }
    }
  }

  private static CatalogueEntry symbol(
      String type, Declaration.Declarator declarator, String meaning, String origin) {
    List<Integer> dimensions = new ArrayList<>();
    for (Expression length : declarator.dimensions()) {
      dimensions.add(length instanceof Expression.IntLiteral number ? number.value() : 0);
    }
    String upper = type.toUpperCase(Locale.ROOT);
    return new CatalogueEntry(
        declarator.name(), upper, List.copyOf(dimensions), null, "", meaning, origin);
  }

  public Collection<CatalogueEntry> variables() {
    return variables.values();
  }

  /**
   * Finds what a path names: a variable, a field of it, or an element, which has no dimensions.
   *
   * @param path such as {@code LOAD_DATA[1].CM.X}
   */
  public Optional<CatalogueEntry> find(String path) {
    CatalogueEntry found = null;
    String begun = "";
    for (String step : path.split("\\.", -1)) {
      int bracket = step.indexOf('[');
      String name = bracket < 0 ? step : step.substring(0, bracket);
      found =
          found == null && begun.isEmpty() ? variables.get(key(name)) : field(found, name, begun);
      if (found == null) {
        return Optional.empty();
      }
      begun = begun.isEmpty() ? found.name() : begun + "." + found.name();
      if (bracket >= 0) {
        found = element(found, step.substring(bracket));
        begun += step.substring(bracket);
      }
    }
    return Optional.ofNullable(found);
  }

  private @Nullable CatalogueEntry field(
      @Nullable CatalogueEntry struct, String name, String begun) {
    if (struct == null) {
      return null;
    }
    return fields(struct).stream()
        .filter(field -> field.name().equalsIgnoreCase(name))
        .map(field -> inside(struct, field, begun))
        .findFirst()
        .orElse(null);
  }

  private static CatalogueEntry inside(CatalogueEntry struct, CatalogueEntry field, String begun) {
    String meaning = "field of " + begun + (struct.meaning().isEmpty() ? "" : ": ");
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

  /** Gives the fields of a structure, none of what is no structure. */
  public List<CatalogueEntry> fields(CatalogueEntry symbol) {
    return structures.getOrDefault(key(symbol.type()), List.of());
  }

  /** Gives the constants of an enumeration without {@code #}, none of what is none. */
  public List<String> constants(CatalogueEntry symbol) {
    return symbol.type().equals("BOOL")
        ? List.of()
        : enumerations.getOrDefault(key(symbol.type()), List.of());
  }

  private static String key(String name) {
    return name.toUpperCase(Locale.ROOT);
  }
}
