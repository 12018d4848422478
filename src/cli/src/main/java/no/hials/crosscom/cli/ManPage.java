package no.hials.crosscom.cli;

import java.util.List;
import java.util.Map;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** The manual page of a command, in the macros of man(7). */
final class ManPage {
  private final StringBuilder page = new StringBuilder();

  private ManPage() {}

  /** Returns the name of a command's page: {@code jopenshowvar-read}. */
  static String name(CommandSpec command) {
    return command.qualifiedName("-");
  }

  /** Creates the page of a command. */
  static String of(CommandSpec command, String version) {
    ManPage page = new ManPage();
    UsageMessageSpec usage = command.usageMessage();
    page.macro("TH", name(command), "1", "", "jopenshowvar " + version, "JOpenShowVar");
    // no hyphenation and no justified lines, so that names stay as they are
    page.macro("nh");
    page.macro("ad", "l");
    page.section("NAME");
    String sentence = HelpText.firstSentence(usage.description()).replaceAll("\\.$", "");
    page.line(name(command) + " - " + sentence);
    page.section("SYNOPSIS");
    page.line(HelpText.synopsis(command));
    page.section("DESCRIPTION");
    page.blocks(HelpText.blocks(usage.description()));
    page.arguments("ARGUMENTS", HelpText.parameters(command));
    page.arguments("OPTIONS", HelpText.options(command));
    page.subcommands(command);
    page.items("EXIT STATUS", usage.exitCodeList());
    List<HelpText.Block> footer = HelpText.blocks(usage.footer());
    if (!footer.isEmpty()) {
      page.section("NOTES");
      page.blocks(footer);
    }
    CommandSpec parent = command.parent();
    if (parent != null) {
      page.section("SEE ALSO");
      page.line(name(parent) + "(1)");
    }
    return page.page.toString();
  }

  private void arguments(String title, List<? extends ArgSpec> arguments) {
    if (!arguments.isEmpty()) {
      section(title);
      arguments.forEach(a -> item(HelpText.label(a), HelpText.paragraph(a.description())));
    }
  }

  private void subcommands(CommandSpec command) {
    if (!command.subcommands().isEmpty()) {
      section("COMMANDS");
      for (var sub : command.subcommands().values()) {
        CommandSpec spec = sub.getCommandSpec();
        item(name(spec) + "(1)", HelpText.firstSentence(spec.usageMessage().description()));
      }
    }
  }

  private void items(String title, Map<String, String> items) {
    if (!items.isEmpty()) {
      section(title);
      items.forEach(this::item);
    }
  }

  private void item(String label, String text) {
    macro("TP");
    page.append("\\fB").append(escaped(label)).append("\\fR\n");
    line(text);
  }

  private void blocks(List<HelpText.Block> blocks) {
    for (HelpText.Block block : blocks) {
      macro("PP");
      if (block.literal()) {
        macro("nf");
        macro("RS", "2");
      }
      block.lines().forEach(this::line);
      if (block.literal()) {
        macro("RE");
        macro("fi");
      }
    }
  }

  private void section(String title) {
    macro("SH", title);
  }

  private void macro(String name, String... arguments) {
    page.append('.').append(name);
    for (String argument : arguments) {
      boolean plain = argument.chars().allMatch(Character::isLetterOrDigit) && !argument.isEmpty();
      String text = escaped(argument).replace("\"", "\\(dq");
      page.append(' ').append(plain ? text : "\"" + text + "\"");
    }
    page.append('\n');
  }

  private void line(String text) {
    // a line that begins with one of these would be a macro
    String guard = text.startsWith(".") || text.startsWith("'") ? "\\&" : "";
    page.append(guard).append(escaped(text)).append('\n');
  }

  private static String escaped(String text) {
    return text.replace("\\", "\\e")
        .replace("-", "\\-")
        .replace("'", "\\(aq")
        .replace("`", "\\(ga")
        .replace("^", "\\(ha")
        .replace("~", "\\(ti");
  }
}
