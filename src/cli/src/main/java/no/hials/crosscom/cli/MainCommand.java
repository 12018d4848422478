package no.hials.crosscom.cli;

import java.util.List;
import no.hials.crosscom.cli.base.CommandTree;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.VersionProvider;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** The program, which has only help of its own. */
@Command(
    name = "jopenshowvar",
    mixinStandardHelpOptions = true,
    versionProvider = VersionProvider.class,
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "",
    description = {
      "Reads and writes the variables of a KUKA robot controller, through KUKAVARPROXY or C3"
          + " Bridge on it, or of a simulated one.",
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
      "@NAME is a robot of the configuration file; in PowerShell '@NAME', in quotes. The file:",
      "  ~/.config/jopenshowvar/config.toml, or below XDG_CONFIG_HOME",
      "  %%APPDATA%%\\jopenshowvar\\config.toml on Windows",
      "  what JOPENSHOWVAR_CONFIG names",
      "What it may hold:",
      "  default = \"cell1\"",
      "  [robots.cell1]",
      "  host = \"172.31.1.147\"   # port = 7000",
      "  timeout = \"2s\"",
      "  read-only = true",
      "  [robots.sim]",
      "  mock = true             # server = \"c3\"",
      "",
      "The controller is the first that is given of: --host, --mock or @NAME; JOPENSHOWVAR_HOST,"
          + " with JOPENSHOWVAR_PORT; default of the file. The timeout is the first of: --timeout;"
          + " that of @NAME; JOPENSHOWVAR_TIMEOUT; that of the default robot. It is read-only"
          + " if any of --read-only, JOPENSHOWVAR_READ_ONLY=true and the robot of the file says so.",
      "",
      "'jopenshowvar COMMAND --help' tells more, and the exit codes."
    })
final class MainCommand implements CommandTree {
  private final Console console;

  MainCommand(Console console) {
    this.console = console;
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
