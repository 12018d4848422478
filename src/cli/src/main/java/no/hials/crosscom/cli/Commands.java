package no.hials.crosscom.cli;

import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.bridge.ConfirmCommand;
import no.hials.crosscom.cli.bridge.DiscoverCommand;
import no.hials.crosscom.cli.bridge.FileCommand;
import no.hials.crosscom.cli.bridge.InfoCommand;
import no.hials.crosscom.cli.bridge.ProgramCommands;
import no.hials.crosscom.cli.drive.DriveCommand;
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
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Column;
import picocli.CommandLine.Help.TextTable;
import picocli.CommandLine.Model.UsageMessageSpec;

/**
 * The commands by what they are for, in the order of the help. A command is added in two places
 * here: its name to a group, and to {@link #make}.
 */
public enum Commands {
  VARIABLES("Variables:", "read", "write", "vars", "shell", "run"),
  PROGRAMS("Programs and files:", "info", "discover", "program", "file", "confirm"),
  CONTROL("Control:", "drive"),
  MEASURING("Measuring:", "watch", "record", "plot", "bench"),
  SIMULATION("Simulated controller:", "mock", "experiment");

  private final String title;

  @SuppressWarnings("ImmutableEnumChecker") // it is a List.of
  private final List<String> names;

  Commands(String title, String... names) {
    this.title = title;
    this.names = List.of(names);
  }

  /**
   * Creates one command, so that a run need not create them all: that takes longer than a read.
   *
   * @return a {@link ConsoleCommand}, or a {@link CommandLine} with subcommands of its own
   */
  private static Object make(String name, Console console) {
    return switch (name) {
      case "read" -> new ReadCommand(console);
      case "write" -> new WriteCommand(console);
      case "watch" -> new WatchCommand(console);
      case "record" -> new RecordCommand(console);
      case "plot" -> new PlotCommand(console);
      case "bench" -> new BenchCommand(console);
      case "drive" -> new DriveCommand(console);
      case "info" -> new InfoCommand(console);
      case "discover" -> new DiscoverCommand(console);
      case "program" -> ProgramCommands.commandLine(console);
      case "file" -> FileCommand.commandLine(console);
      case "confirm" -> new ConfirmCommand(console);
      case "vars" -> new VarsCommand(console);
      case "shell" -> new ShellCommand(console);
      case "run" -> new RunCommand(console);
      case "mock" -> new MockCommand(console);
      case "experiment" -> new ExperimentCommand(console);
      default -> throw new IllegalArgumentException("there is no command " + name);
    };
  }

  /** Returns the title of the group in the help. */
  String title() {
    return title;
  }

  /** Returns the names of the group. */
  public List<String> names() {
    return names;
  }

  /** Adds the command that the arguments begin with; all of them if they begin with no command. */
  static void addTo(CommandLine main, Console console, String... args) {
    List<String> all = Arrays.stream(values()).flatMap(group -> group.names.stream()).toList();
    if (args.length > 0 && all.contains(args[0])) {
      main.addSubcommand(args[0], make(args[0], console));
    } else {
      all.forEach(name -> main.addSubcommand(name, make(name, console)));
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
              help.colorScheme().text(firstSentence(description)));
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

  public static String firstSentence(String... description) {
    String text = String.join(" ", description);
    int end = text.indexOf(". ");
    return end < 0 ? text : text.substring(0, end + 1);
  }
}
