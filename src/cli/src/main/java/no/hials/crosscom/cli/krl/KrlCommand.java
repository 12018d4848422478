package no.hials.crosscom.cli.krl;

import no.hials.crosscom.cli.base.VersionProvider;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** {@code krl}, which only has commands. */
@Command(
    name = "krl",
    mixinStandardHelpOptions = true,
    versionProvider = VersionProvider.class,
    synopsisSubcommandLabel = "COMMAND",
    description = "Checks and runs KRL files on this computer, without a robot.",
    footer = {
      "",
      "Examples:",
      "  jopenshowvar krl check krl/config.dat krl/actuator.src",
      "  jopenshowvar krl check cell.zip --json",
      "  jopenshowvar krl run place.src --archive cell.zip",
      "",
      "See 'jopenshowvar krl COMMAND --help' for options and exit codes."
    })
public final class KrlCommand {
  private KrlCommand() {}

  /** Creates the command with its subcommands. */
  public static CommandLine commandLine() {
    return new CommandLine(new KrlCommand())
        .addSubcommand(new KrlCheck())
        .addSubcommand(new KrlRun());
  }
}
