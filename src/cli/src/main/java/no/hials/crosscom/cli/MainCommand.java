package no.hials.crosscom.cli;

import java.util.List;
import java.util.concurrent.Callable;
import no.hials.crosscom.cli.base.CommandTree;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.VersionProvider;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** The program, which has only help of its own. */
@Command(
    name = "jopenshowvar",
    mixinStandardHelpOptions = true,
    versionProvider = VersionProvider.class,
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "",
    description = {
      "Reads and writes the variables of a KUKA robot controller, through KUKAVARPROXY or C3"
          + " Bridge, or the variables of a simulated controller.",
      "A write can move a machine."
    },
    footer = {
      "",
      "Examples:",
      "  jopenshowvar read '$POS_ACT' '$OV_PRO' --host 172.31.1.147",
      "  jopenshowvar write '$OV_PRO' 50 --host 172.31.1.147",
      "  jopenshowvar read '$POS_ACT' --mock",
      "  jopenshowvar read @cell1 @cell2 '$POS_ACT'",
      "",
      "@NAME is a robot of the configuration file (in PowerShell, quote it: '@NAME'), before or"
          + " after the command. The file is:",
      "  $XDG_CONFIG_HOME/jopenshowvar/config.toml, by default ~/.config/...",
      "  %%APPDATA%%\\jopenshowvar\\config.toml on Windows",
      "  the file named by JOPENSHOWVAR_CONFIG, if set",
      "Example:",
      "  default = \"cell1\"",
      "  [robots.cell1]",
      "  host = \"172.31.1.147\"   # or \"172.31.1.147:7000\"",
      "  timeout = \"2s\"",
      "  read-only = true",
      "  [robots.sim]",
      "  mock = true             # server = \"c3\"",
      "",
      "The controller is the first of these that is set: --host, --mock or @NAME;"
          + " JOPENSHOWVAR_HOST and JOPENSHOWVAR_PORT; the default robot of the file. The timeout"
          + " is the first of: --timeout; the timeout of @NAME; JOPENSHOWVAR_TIMEOUT; the timeout"
          + " of the default robot. The controller is read-only if --read-only,"
          + " JOPENSHOWVAR_READ_ONLY=true or read-only = true of the robot is set.",
      "",
      "See 'jopenshowvar help COMMAND' for options and exit codes."
    })
final class MainCommand implements CommandTree, Callable<Integer> {
  private final Console console;

  @SuppressWarnings("NullAway.Init") // picocli sets it
  @Spec
  private CommandSpec spec;

  MainCommand(Console console) {
    this.console = console;
  }

  /** Prints the help, since no command is given. */
  @Override
  public Integer call() {
    spec.commandLine().usage(console.err());
    return ExitCode.USAGE.code();
  }

  @Override
  public Console console() {
    return console;
  }

  @Override
  public List<String> commands() {
    return Commands.all();
  }

  @Override
  public CommandLine commandLine(Console other, String... args) {
    return Main.commandLine(other, args);
  }

  @Override
  public ExitCode run(Console other, String... args) {
    return ExitCode.of(Main.run(args, other));
  }
}
