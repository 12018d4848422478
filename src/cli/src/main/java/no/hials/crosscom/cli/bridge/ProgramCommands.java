package no.hials.crosscom.cli.bridge;

import no.hials.crosscom.cli.base.VersionProvider;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** {@code program}, which only has commands. */
@Command(
    name = "program",
    mixinStandardHelpOptions = true,
    versionProvider = VersionProvider.class,
    synopsisSubcommandLabel = "COMMAND",
    description = {
      "Selects, starts and stops programs, through C3 Bridge. Starting a program moves the robot."
    },
    footer = {
      "",
      "Examples:",
      "  jopenshowvar program select /R1/ACTUATOR --host 172.31.1.147",
      "  jopenshowvar program start --host 172.31.1.147",
      "  jopenshowvar program stop --host 172.31.1.147",
      "",
      "'jopenshowvar program COMMAND --help' tells more, and the exit codes."
    })
public final class ProgramCommands {
  private ProgramCommands() {}

  /** Creates the command with its subcommands. */
  public static CommandLine commandLine() {
    return new CommandLine(new ProgramCommands())
        .addSubcommand(new ProgramChoice.Select())
        .addSubcommand(new ProgramOrder.Start())
        .addSubcommand(new ProgramOrder.Stop())
        .addSubcommand(new ProgramOrder.Reset())
        .addSubcommand(new ProgramOrder.Cancel())
        .addSubcommand(new ProgramChoice.Run());
  }
}
