package no.hials.crosscom.cli;

import java.util.List;
import no.hials.crosscom.cli.base.CommandTree;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.ExitCode;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.UnmatchedArgumentException;

/** {@code help}. */
@Command(
    name = "help",
    description = "Shows the help of the program or of a command.",
    footer = {
      "",
      "Examples:",
      "  jopenshowvar help",
      "  jopenshowvar help read",
      "  jopenshowvar help file get"
    })
final class HelpCommand extends ConsoleCommand {
  @Parameters(arity = "0..*", paramLabel = "COMMAND", description = "The command.")
  private List<String> words = List.of();

  @Override
  public ExitCode run() {
    String[] names = words.toArray(String[]::new);
    CommandLine command = CommandTree.find(program().commandLine(console(), names), names);
    int found = CommandTree.depth(command);
    if (found < names.length) {
      throw new UnmatchedArgumentException(command, words.subList(found, names.length));
    }
    console().write(command.getUsageMessage());
    return ExitCode.DONE;
  }
}
