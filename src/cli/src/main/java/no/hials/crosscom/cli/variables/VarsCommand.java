package no.hials.crosscom.cli.variables;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cell.DeclarationRows;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Table;
import no.hials.crosscom.lang.DataList;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.KrlFile;
import no.hials.crosscom.lang.KrlParser;
import no.hials.crosscom.lang.ParseResult;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code vars [WORD...]}. */
@Command(
    name = "vars",
    description =
        "Searches the built-in list of system variables and prints type, unit, access (RO: read,"
            + " RW: read and write) and meaning. Needs no controller.",
    footer = {
      "",
      "The list is for a KR C4 with KSS 8.3. It is not complete, and access can differ on a"
          + " controller.",
      "",
      "With --declared, the command lists the declarations of a data list, such as the"
          + " $config.dat of a robot: variables, types, signals and initial values of elements."
          + " Errors in the file are printed with line and column. Exit code 1 if nothing"
          + " matches.",
      "",
      "JSON: one object per line with name, type, dimensions, unit, access and meaning; with"
          + " --declared name, type, value, global, const, line and comment.",
      "",
      "Examples:",
      "  jopenshowvar vars torque",
      "  jopenshowvar vars axis deg --json",
      "  jopenshowvar vars --declared krl/config.dat"
    })
public final class VarsCommand extends ConsoleCommand {
  @Parameters(
      arity = "0..*",
      paramLabel = "WORD",
      description =
          "Text to find in name, type, unit or meaning; case does not matter. With several"
              + " words, all must match. Default: list everything.")
  private List<String> words = List.of();

  @Option(
      names = "--declared",
      paramLabel = "FILE",
      description = "Search the declarations of this data list instead.")
  private @Nullable Path declared;

  @Option(names = "--json", description = "Print JSON, see below.")
  private boolean json;

  @Override
  public ExitCode run() throws IOException {
    return declared == null ? system() : declared(declared);
  }

  private ExitCode system() {
    List<CatalogueEntry> found =
        Catalogue.system().variables().stream()
            .filter(
                symbol ->
                    matches(symbol.declarator(), symbol.type(), symbol.unit(), symbol.meaning()))
            .toList();
    if (json) {
      found.forEach(symbol -> console().print(json(symbol)));
    } else if (!found.isEmpty()) {
      Table table = Table.withTitles("NAME", "TYPE", "UNIT", "ACCESS", "MEANING");
      found.forEach(
          symbol ->
              table.add(
                  symbol.declarator(),
                  symbol.type(),
                  symbol.unit(),
                  symbol.shortAccess(),
                  symbol.meaning()));
      table.print(console());
    }
    return checkFound(found);
  }

  private ExitCode declared(Path file) throws FileException {
    ParseResult result = parse(file);
    Optional<KrlFile> tree = result.file();
    for (KrlError error : result.errors()) {
      console().error(error.toString());
    }
    List<DeclarationRows.Row> rows =
        tree.isPresent() && tree.get() instanceof DataList list
            ? DeclarationRows.of(list)
            : noDataList(file, result);
    List<DeclarationRows.Row> found =
        rows.stream()
            .filter(row -> matches(row.name(), row.type(), row.value(), row.comment()))
            .toList();
    if (json) {
      found.forEach(row -> console().print(json(row)));
    } else if (!found.isEmpty()) {
      Table table = Table.withTitles("LINE", "NAME", "TYPE", "SCOPE", "COMMENT", "VALUE");
      found.forEach(
          row ->
              table.add(
                  Integer.toString(row.line()),
                  row.name(),
                  row.type(),
                  String.join(" ", row.words()),
                  row.comment(),
                  row.value()));
      table.print(console());
    }
    return result.errors().isEmpty() ? checkFound(found) : ExitCode.USAGE;
  }

  private static ParseResult parse(Path file) throws FileException {
    try {
      return KrlParser.parse(file);
    } catch (IOException e) {
      throw FileException.cannot("read", file, e);
    }
  }

  /** Returns no rows, or throws an exception if the errors do not explain why. */
  private List<DeclarationRows.Row> noDataList(Path file, ParseResult result) throws FileException {
    if (result.errors().isEmpty()) {
      throw new FileException(file + " is a program, and not a data list");
    }
    return List.of();
  }

  private boolean matches(String... texts) {
    String all = String.join("\n", texts).toLowerCase(Locale.ROOT);
    return words.stream().allMatch(word -> all.contains(word.toLowerCase(Locale.ROOT)));
  }

  private ExitCode checkFound(List<?> found) {
    if (found.isEmpty() && !words.isEmpty()) {
      console().error("no variable matches " + String.join(" and ", words));
      return ExitCode.REFUSED;
    }
    return ExitCode.DONE;
  }

  private static String json(CatalogueEntry symbol) {
    return JsonLine.object(
        line -> {
          line.writeStringField("name", symbol.name());
          line.writeStringField("type", symbol.type());
          line.writeArrayFieldStart("dimensions");
          for (int length : symbol.dimensions()) {
            line.writeNumber(length);
          }
          line.writeEndArray();
          line.writeStringField("unit", symbol.unit());
          line.writeStringField("access", symbol.shortAccess());
          line.writeStringField("meaning", symbol.meaning());
        });
  }

  private static String json(DeclarationRows.Row row) {
    return JsonLine.object(
        line -> {
          line.writeStringField("name", row.name());
          line.writeStringField("type", row.type());
          line.writeStringField("value", row.value());
          line.writeBooleanField("global", row.words().contains("GLOBAL"));
          line.writeBooleanField("const", row.words().contains("CONST"));
          line.writeNumberField("line", row.line());
          line.writeStringField("comment", row.comment());
        });
  }
}
