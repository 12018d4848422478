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
      "'jopenshowvar program COMMAND --help' tells more, and the exit codes."
    })
public final class ProgramCommands {
  private ProgramCommands() {}

  /** Creates the command with its subcommands. */
  public static CommandLine commandLine() {
    CommandLine program = new CommandLine(new ProgramCommands());
    add(
        program,
        "select",
        "Selects a program of the robot interpreter. It does not start it.",
        new ProgramChoice("select", Programs::select));
    add(
        program,
        "start",
        "Starts the selected program, or goes on with one that was stopped. The robot moves.",
        new ProgramOrder("start", Programs::start));
    add(
        program,
        "stop",
        "Stops the running program. It never asks, in no mode, since it makes the robot stand still;"
            + " --read-only refuses it, as everything that is sent. This is no emergency stop: it"
            + " takes a working network.",
        new ProgramOrder("stop", Programs::stop));
    add(
        program,
        "reset",
        "Resets the selected program, so that a start runs it from the beginning.",
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
