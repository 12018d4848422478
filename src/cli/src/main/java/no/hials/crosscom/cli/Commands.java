package no.hials.crosscom.cli;

import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.bridge.ConfirmCommand;
import no.hials.crosscom.cli.bridge.DiscoverCommand;
import no.hials.crosscom.cli.bridge.FileCommand;
import no.hials.crosscom.cli.bridge.InfoCommand;
import no.hials.crosscom.cli.bridge.ProgramCommands;
import no.hials.crosscom.cli.drive.DriveCommand;
import no.hials.crosscom.cli.gateway.GatewayCommand;
import no.hials.crosscom.cli.krl.KrlCommand;
import no.hials.crosscom.cli.lab.BenchCommand;
import no.hials.crosscom.cli.lab.ExperimentCommand;
import no.hials.crosscom.cli.lab.PlotCommand;
import no.hials.crosscom.cli.mock.MockCommand;
import no.hials.crosscom.cli.shell.RunCommand;
import no.hials.crosscom.cli.shell.ShellCommand;
import no.hials.crosscom.cli.variables.ReadCommand;
import no.hials.crosscom.cli.variables.RecordCommand;
import no.hials.crosscom.cli.variables.VarsCommand;
import no.hials.crosscom.cli.variables.WatchCommand;
import no.hials.crosscom.cli.variables.WriteCommand;
import no.hials.crosscom.cli.web.WebCommand;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Column;
import picocli.CommandLine.Help.TextTable;
import picocli.CommandLine.Model.UsageMessageSpec;

/**
 * The groups of commands, in the order of the help. A new command is added in two places: to its
 * group and to {@link #make}.
 */
enum Commands {
  VARIABLES("Variables:", "read", "write", "vars", "shell", "run"),
  PROGRAMS("Programs and files:", "info", "discover", "program", "file", "confirm"),
  CONTROL("Control:", "web", "drive"),
  PLANT("Plant:", "gateway"),
  MEASURING("Measuring:", "watch", "record", "plot", "bench"),
  SIMULATION("Simulated controller:", "mock", "krl", "experiment"),
  HELP("Help:", "help");

  private final String title;

  @SuppressWarnings("ImmutableEnumChecker") // it is a List.of
  private final List<String> names;

  Commands(String title, String... names) {
    this.title = title;
    this.names = List.of(names);
  }

  /**
   * Creates one command; creating all of them takes longer than a read.
   *
   * @return a {@link ConsoleCommand}, or a {@link CommandLine} with its own subcommands
   */
  private static Object make(String name) {
    return switch (name) {
      case "read" -> new ReadCommand();
      case "write" -> new WriteCommand();
      case "watch" -> new WatchCommand();
      case "record" -> new RecordCommand();
      case "plot" -> new PlotCommand();
      case "bench" -> new BenchCommand();
      case "web" -> new WebCommand();
      case "drive" -> new DriveCommand();
      case "gateway" -> GatewayCommand.commandLine();
      case "info" -> new InfoCommand();
      case "discover" -> new DiscoverCommand();
      case "program" -> ProgramCommands.commandLine();
      case "file" -> FileCommand.commandLine();
      case "confirm" -> new ConfirmCommand();
      case "vars" -> new VarsCommand();
      case "shell" -> new ShellCommand();
      case "run" -> new RunCommand();
      case "mock" -> new MockCommand();
      case "krl" -> KrlCommand.commandLine();
      case "experiment" -> new ExperimentCommand();
      case "help" -> new HelpCommand();
      default -> throw new IllegalArgumentException("there is no command " + name);
    };
  }

  /** Returns the title of the group in the help. */
  String title() {
    return title;
  }

  /** Returns the names of the group. */
  List<String> names() {
    return names;
  }

  /** Returns the names of all groups. */
  static List<String> all() {
    return Arrays.stream(values()).flatMap(group -> group.names.stream()).toList();
  }

  /** Adds the command that the arguments begin with; all of them if they begin with no command. */
  static void addTo(CommandLine main, String... args) {
    if (args.length > 0 && all().contains(args[0])) {
      main.addSubcommand(args[0], make(args[0]));
    } else {
      all().forEach(name -> main.addSubcommand(name, make(name)));
      main.getHelpSectionMap().put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST, Commands::list);
    }
  }

  /** Renders the commands in their groups, for the help of the program. */
  static String list(Help help) {
    int width = help.subcommands().keySet().stream().mapToInt(String::length).max().orElse(0) + 4;
    StringBuilder list = new StringBuilder();
    for (Commands group : values()) {
      TextTable table =
          TextTable.forColumns(
              help.colorScheme(),
              new Column(width, 2, Column.Overflow.SPAN),
              new Column(
                  help.commandSpec().usageMessage().width() - width, 2, Column.Overflow.WRAP));
      for (String name : group.names) {
        Help command = help.subcommands().get(name);
        if (command != null) {
          String[] description = command.commandSpec().usageMessage().description();
          table.addRowValues(
              help.colorScheme().commandText(name),
              help.colorScheme().text(ConsoleCommand.firstSentence(description)));
        }
      }
      if (table.rowCount() > 0) {
        list.append(System.lineSeparator())
            .append(help.colorScheme().text("@|bold " + group.title + "|@"))
            .append(System.lineSeparator())
            .append(table);
      }
    }
    return list.toString();
  }
}
