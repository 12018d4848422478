package no.hials.crosscom.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.ConsoleCommand;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** The help of a command, for pages in other forms than {@code --help}. */
final class HelpText {
  private static final String INDENT = "  ";
  private static final int SYNOPSIS_WIDTH = 10_000;

  private HelpText() {}

  /**
   * A piece of text.
   *
   * @param literal whether to keep its line ends and blanks
   * @param lines its lines; one if it is not literal
   */
  record Block(boolean literal, List<String> lines) {}

  /** Returns the options that the help shows, in its order. */
  static List<OptionSpec> options(CommandSpec command) {
    return command.options().stream()
        .filter(option -> !option.hidden())
        .sorted(Comparator.comparingInt(OptionSpec::order))
        .toList();
  }

  /** Returns the arguments that the help shows. */
  static List<PositionalParamSpec> parameters(CommandSpec command) {
    return command.positionalParameters().stream().filter(argument -> !argument.hidden()).toList();
  }

  /** Returns the text after {@code Usage:} in one line. */
  static String synopsis(CommandSpec command) {
    UsageMessageSpec usage = command.usageMessage();
    int width = usage.width();
    // otherwise a line may end within a label, such as FILE.dat
    usage.width(SYNOPSIS_WIDTH);
    Help help = new Help(command, Help.defaultColorScheme(Help.Ansi.OFF));
    String synopsis = help.synopsis(0).replaceAll("\\s+", " ").strip();
    usage.width(width);
    return synopsis;
  }

  /** Returns an option with its names and its argument. */
  static String label(ArgSpec argument) {
    if (argument instanceof OptionSpec option) {
      String names = String.join(", ", option.names());
      return option.arity().max() == 0 ? names : names + " " + option.paramLabel();
    }
    return argument.paramLabel();
  }

  /** Splits a help text into blocks: indented lines are literal, an empty line ends a block. */
  static List<Block> blocks(String... help) {
    List<Block> blocks = new ArrayList<>();
    List<String> open = new ArrayList<>();
    boolean literal = false;
    for (String line : lines(help)) {
      boolean indented = line.startsWith(INDENT);
      if (!open.isEmpty() && (line.isBlank() || indented != literal)) {
        blocks.add(block(literal, open));
        open.clear();
      }
      literal = indented;
      if (!line.isBlank()) {
        open.add(indented ? line.substring(INDENT.length()) : line.strip());
      }
    }
    if (!open.isEmpty()) {
      blocks.add(block(literal, open));
    }
    return blocks;
  }

  private static Block block(boolean literal, List<String> lines) {
    return new Block(literal, literal ? List.copyOf(lines) : List.of(String.join(" ", lines)));
  }

  private static List<String> lines(String... help) {
    return Arrays.stream(help)
        // picocli formats them as well: %% is a per cent sign
        .map(text -> Help.Ansi.OFF.string(String.format(Locale.ROOT, text)))
        .flatMap(text -> text.isEmpty() ? Stream.of("") : text.lines())
        .toList();
  }

  /** Returns the first sentence of a description. */
  static String firstSentence(String... description) {
    return ConsoleCommand.firstSentence(lines(description).toArray(String[]::new));
  }

  /** Returns a description as one paragraph. */
  static String paragraph(String... description) {
    return String.join(" ", lines(description)).strip();
  }
}
