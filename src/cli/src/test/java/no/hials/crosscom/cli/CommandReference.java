package no.hials.crosscom.cli;

import java.util.List;
import java.util.Map;
import no.hials.crosscom.cli.base.CommandTree;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** The parts of {@code docs/reference/cli.md} that are made from the commands themselves. */
final class CommandReference {
  private static final List<String> OF_EACH = List.of("--help", "--version", "--verbose");
  private static final int WIDTH = 115;

  private final StringBuilder page = new StringBuilder();

  private CommandReference() {}

  /** Creates the parts by the names under which the page has them. */
  static Map<String, String> parts() {
    CommandLine main = Documents.commands();
    return Map.of(
        "overview", overview(main), "exit codes", exitCodes(main), "commands", commands(main));
  }

  private static String overview(CommandLine main) {
    CommandReference part = new CommandReference();
    part.blocks(main.getCommandSpec().usageMessage().description());
    for (Commands group : Commands.values()) {
      part.line("").line("**" + group.title() + "**").line("");
      part.line("| command | what it does |").line("|---|---|");
      for (String name : group.names()) {
        CommandSpec command = main.getSubcommands().get(name).getCommandSpec();
        String sentence = HelpText.firstSentence(command.usageMessage().description());
        part.row("[`" + name + "`](#" + name + ")", sentence);
      }
    }
    part.line("").line("Options of every command:");
    CommandSpec read = main.getSubcommands().get("read").getCommandSpec();
    part.arguments(
        "option", HelpText.options(read).stream().filter(CommandReference::isOfEach).toList());
    part.blocks(main.getCommandSpec().usageMessage().footer());
    return part.page.toString();
  }

  private static String exitCodes(CommandLine main) {
    CommandReference part = new CommandReference();
    part.line("| code | meaning |").line("|---|---|");
    CommandSpec read = main.getSubcommands().get("read").getCommandSpec();
    read.usageMessage().exitCodeList().forEach(part::row);
    return part.page.toString();
  }

  private static String commands(CommandLine main) {
    CommandReference part = new CommandReference();
    for (Commands group : Commands.values()) {
      group.names().stream()
          .flatMap(
              name -> CommandTree.withAllBelow(main.getSubcommands().get(name).getCommandSpec()))
          .forEach(part::command);
    }
    return part.page.toString();
  }

  private void command(CommandSpec command) {
    String name = command.qualifiedName().replaceFirst("^\\S+ ", "");
    line("").line((name.contains(" ") ? "### " : "## ") + name);
    blocks(command.usageMessage().description());
    line("").line("```").line(HelpText.synopsis(command)).line("```");
    arguments("argument", HelpText.parameters(command));
    List<OptionSpec> own =
        HelpText.options(command).stream().filter(option -> !isOfEach(option)).toList();
    arguments("option", own);
    blocks(command.usageMessage().footer());
  }

  private static boolean isOfEach(OptionSpec option) {
    return OF_EACH.contains(option.longestName());
  }

  private void arguments(String title, List<? extends ArgSpec> arguments) {
    if (!arguments.isEmpty()) {
      line("").line("| " + title + " | meaning |").line("|---|---|");
      arguments.forEach(
          a -> row("`" + HelpText.label(a) + "`", escaped(HelpText.paragraph(a.description()))));
    }
  }

  private void blocks(String... text) {
    for (HelpText.Block block : HelpText.blocks(text)) {
      line("");
      if (block.literal()) {
        line("```");
        block.lines().forEach(this::line);
        line("```");
      } else {
        wrapped(escaped(block.lines().get(0)));
      }
    }
  }

  private void wrapped(String paragraph) {
    StringBuilder line = new StringBuilder();
    for (String word : paragraph.split(" ", -1)) {
      if (!line.isEmpty() && line.length() + 1 + word.length() > WIDTH) {
        line(line.toString());
        line.setLength(0);
      }
      line.append(line.isEmpty() ? "" : " ").append(word);
    }
    line(line.toString());
  }

  private void row(String first, String second) {
    line("| " + first + " | " + second.replace("|", "\\|") + " |");
  }

  private CommandReference line(String line) {
    page.append(line).append('\n');
    return this;
  }

  private static String escaped(String text) {
    return text.replace("\\", "\\\\").replace("<", "&lt;").replace("*", "\\*");
  }
}
