package no.hials.crosscom.cli.shell;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cli.base.ConsoleCommand;
import org.jline.reader.Candidate;
import org.jline.reader.Completer;
import org.jline.reader.LineReader;
import org.jline.reader.ParsedLine;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** Completes lines of the shell language. */
final class ShellCompleter implements Completer {
  /** The style of the list of candidates, by JLine's names for its parts. */
  static final Map<String, String> COLOURED =
      Map.of(
          LineReader.COMPLETION_STYLE_STARTING, "fg:cyan",
          LineReader.COMPLETION_STYLE_DESCRIPTION, "fg:bright-black");

  /** The same without colours. */
  static final Map<String, String> PLAIN =
      Map.of(
          LineReader.COMPLETION_STYLE_STARTING, "bold",
          LineReader.COMPLETION_STYLE_DESCRIPTION, "faint");

  private static final Set<String> WITH_NAMES = Set.of("get", "read", "help", "watch", "record");

  /** The maximum number of indices in the list. */
  private static final int MAX_INDICES = 64;

  private final ShellCommands commands;
  private final ShellSymbols symbols;

  ShellCompleter(ShellCommands commands, ShellSymbols symbols) {
    this.commands = commands;
    this.symbols = symbols;
  }

  @Override
  public void complete(LineReader reader, ParsedLine line, List<Candidate> candidates) {
    candidates.addAll(candidates(line));
  }

  /** Returns the candidates at the cursor. */
  List<Candidate> candidates(ParsedLine line) {
    String word = line.word().substring(0, line.wordCursor());
    List<String> before = line.words().subList(0, line.wordIndex());
    if (before.isEmpty()) {
      List<Candidate> all = names(word);
      if (isCommandBegun(word)) {
        all.addAll(commands());
      }
      return all;
    }
    String first = before.get(0).toLowerCase(Locale.ROOT);
    if (ShellLine.BUILT_INS.containsKey(first) || ShellWords.isSet(first) || first.equals("read")) {
      return behindOwn(first, before, word);
    }
    if (commands.names().contains(first)) {
      return behindCommand(first, before, word);
    }
    return values(before.get(0));
  }

  private List<Candidate> behindOwn(String first, List<String> before, String word) {
    if (ShellWords.isSet(first)) {
      return before.size() == 1 ? names(word) : values(before.get(1));
    }
    List<Candidate> all = WITH_NAMES.contains(first) ? names(word) : new ArrayList<>();
    if (first.equals("help") && isCommandBegun(word)) {
      all.addAll(commands());
    }
    return all;
  }

  private List<Candidate> behindCommand(String first, List<String> before, String word) {
    CommandLine command = commands.commandLine(first);
    for (String step : before.subList(1, before.size())) {
      CommandLine next = command.getSubcommands().get(step);
      command = next == null ? command : next;
    }
    List<Candidate> all = new ArrayList<>();
    if (word.startsWith("-")) {
      for (OptionSpec option : command.getCommandSpec().options()) {
        all.add(candidate(option.longestName(), String.join(" ", option.description()), true));
      }
    } else if (WITH_NAMES.contains(first)) {
      all.addAll(names(word));
    }
    command
        .getSubcommands()
        .forEach((name, sub) -> all.add(candidate(name, description(sub), true)));
    return all;
  }

  private static boolean isCommandBegun(String word) {
    return word.chars().allMatch(Character::isLetter);
  }

  private List<Candidate> commands() {
    List<Candidate> all = new ArrayList<>();
    new TreeMap<>(ShellLine.BUILT_INS)
        .forEach((name, command) -> all.add(candidate(name, command.help(), true)));
    for (String name : commands.names()) {
      all.add(candidate(name, description(commands.commandLine(name)), true));
    }
    return all;
  }

  private static String description(CommandLine command) {
    return ConsoleCommand.firstSentence(command.getCommandSpec().usageMessage().description());
  }

  /** Returns the paths that begin with this text. */
  private List<Candidate> names(String typed) {
    int dot = typed.lastIndexOf('.');
    int bracket = typed.lastIndexOf('[');
    if (bracket > dot && typed.indexOf(']', bracket) < 0) {
      return indices(typed.substring(0, bracket));
    }
    Catalogue known = symbols.everything();
    List<Candidate> all = new ArrayList<>();
    if (dot >= 0) {
      String struct = typed.substring(0, dot);
      List<CatalogueEntry> fields = known.find(struct).map(known::fields).orElse(List.of());
      for (CatalogueEntry field : fields) {
        all.add(name(struct + "." + field.name(), field, known, all.size()));
      }
      return all;
    }
    known.variables().forEach(symbol -> all.add(name(symbol.name(), symbol, known, 0)));
    for (String used : symbols.used()) {
      if (known.find(used).isEmpty() || used.matches(".*[.\\[].*")) {
        all.add(candidate(used, "used before", false));
      }
    }
    return all;
  }

  private static Candidate name(String path, CatalogueEntry symbol, Catalogue known, int sort) {
    if (symbol.isText() && symbol.dimensions().size() == 1) {
      return candidate(path + "[]", symbol.summary(), true, sort);
    }
    if (!symbol.dimensions().isEmpty()) {
      return candidate(path + "[", symbol.declarator() + ", " + symbol.summary(), false, sort);
    }
    return candidate(path, symbol.summary(), known.fields(symbol).isEmpty(), sort);
  }

  private List<Candidate> indices(String array) {
    List<Candidate> all = new ArrayList<>();
    symbols
        .everything()
        .find(array)
        .filter(symbol -> !symbol.dimensions().isEmpty())
        .ifPresent(
            symbol -> {
              all.add(candidate(array + "[]", "all of it", true, 0));
              String end = symbol.dimensions().size() == 1 ? "]" : ",";
              int length = Math.min(symbol.dimensions().get(0), MAX_INDICES);
              for (int i = 1; i <= length; i++) {
                all.add(candidate(array + "[" + i + end, "", false, i));
              }
            });
    return all;
  }

  private List<Candidate> values(String path) {
    Catalogue known = symbols.everything();
    List<Candidate> all = new ArrayList<>();
    known
        .find(path)
        .ifPresent(
            symbol -> {
              known
                  .constants(symbol)
                  .forEach(constant -> all.add(candidate("#" + constant, symbol.type(), true)));
              if (symbol.type().equals("BOOL")) {
                all.add(candidate("TRUE", symbol.summary(), true));
                all.add(candidate("FALSE", symbol.summary(), true));
              }
            });
    return all;
  }

  private static Candidate candidate(String value, String description, boolean complete) {
    return candidate(value, description, complete, 0);
  }

  /**
   * Creates a candidate.
   *
   * @param complete whether a blank follows it
   * @param sort its place in the list, if not alphabetical
   */
  private static Candidate candidate(String value, String description, boolean complete, int sort) {
    return new Candidate(
        value, value, null, description.isEmpty() ? null : description, null, null, complete, sort);
  }
}
