package no.hials.crosscom.cli.shell;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.lang.Access;

/** The answers of {@code help}. */
final class ShellHelp {
  private ShellHelp() {}

  /** Returns the help text of the language. */
  static List<String> language(Set<String> commands) {
    List<String> lines = new ArrayList<>();
    lines.add("$OV_PRO              reads a variable, a field, an element or a whole array");
    lines.add("$OV_PRO = 50         writes it, also without the sign; the value is KRL");
    new TreeMap<>(ShellLine.BUILT_INS).values().forEach(each -> lines.add(each.line()));
    lines.add("; or #               begins a comment, # only at the beginning of a line");
    lines.add("commands as outside: " + String.join(", ", commands));
    return lines;
  }

  /** Returns the facts about a variable. */
  static List<String> of(String path, CatalogueEntry symbol, Catalogue symbols) {
    List<String> lines = new ArrayList<>();
    String name = path.toUpperCase(Locale.ROOT);
    lines.add(name.equalsIgnoreCase(symbol.name()) ? symbol.declarator() : name);
    if (!symbol.meaning().isEmpty()) {
      lines.add("  " + symbol.meaning());
    }
    lines.add("  type    " + symbol.type());
    if (!symbol.unit().isEmpty()) {
      lines.add("  unit    " + symbol.unit());
    }
    if (symbol.access() != null) {
      lines.add("  access  " + (symbol.access() == Access.READ_ONLY ? "read" : "read and write"));
    }
    if (!symbol.origin().isEmpty()) {
      lines.add("  from    " + symbol.origin());
    }
    List<CatalogueEntry> fields = symbols.fields(symbol);
    if (!fields.isEmpty()) {
      lines.add(
          "  fields  "
              + fields.stream()
                  .map(field -> field.type() + " " + field.declarator())
                  .collect(Collectors.joining(", ")));
    }
    List<String> constants = symbols.constants(symbol);
    if (!constants.isEmpty()) {
      lines.add("  values  #" + String.join(", #", constants));
    }
    return lines;
  }
}
