package no.hials.crosscom.cli.bridge;

import no.hials.crosscom.c3.Programs;
import no.hials.crosscom.cli.base.VersionProvider;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** {@code program}, which only has commands. */
@Command(
    name = "program",
    mixinStandardHelpOptions = true,
    versionProvider = VersionProvider.class,
    synopsisSubcommandLabel = "COMMAND",
    description =
        "Selects, starts and stops programs, through C3 Bridge. Starting a program moves the robot.",
    footer = {
      "",
      "Examples:",
      "  jopenshowvar program select /R1/ACTUATOR --host 172.31.1.147",
      "  jopenshowvar program start --host 172.31.1.147",
      "  jopenshowvar program stop --host 172.31.1.147",
      "",
      "See 'jopenshowvar program COMMAND --help' for options and exit codes."
    })
public final class ProgramCommands {
  private ProgramCommands() {}

  /** Creates the command with its subcommands. */
  public static CommandLine commandLine() {
    CommandLine program = new CommandLine(new ProgramCommands());
    add(
        program,
        "select",
        "Selects a program of the robot interpreter without starting it.",
        new ProgramChoice("select", Programs::select));
    add(
        program,
        "start",
        "Starts the selected program, or resumes a stopped one. The robot moves.",
        new ProgramOrder("start", Programs::start));
    add(
        program,
        "stop",
        "Stops the running program. Never asks for confirmation, so --yes has no effect. With --read-only it is refused"
            + " like other commands. This is not an emergency stop: it needs a working network.",
        new ProgramOrder("stop", Programs::stop));
    add(
        program,
        "reset",
        "Resets the selected program, so that it starts from the beginning.",
        new ProgramOrder("reset", Programs::reset));
    add(
        program,
        "cancel",
        "Cancels the selection of the program.",
        new ProgramOrder("cancel", Programs::cancel));
    add(
        program,
        "run",
        "Selects a program of the robot interpreter and starts it. The robot moves.",
        new ProgramChoice("run", Programs::run));
    return program;
  }

  /** Adds one of the commands that share a class. */
  static void add(CommandLine parent, String name, String description, BridgeCommand command) {
    CommandLine line = new CommandLine(command);
    line.getCommandSpec().usageMessage().description(description);
    parent.addSubcommand(name, line);
  }
}
