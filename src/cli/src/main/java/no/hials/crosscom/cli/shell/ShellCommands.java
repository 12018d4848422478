package no.hials.crosscom.cli.shell;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.CommandTree;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ConsoleCommand;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.WriteOptions;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/**
 * The commands of the command line that are also lines of the shell language. They run as usual, on
 * a separate connection to the same controller: if it breaks, for example by Ctrl-C, the connection
 * of the shell stays.
 */
final class ShellCommands {
  /** Commands with another form in the language, or without a use in a shell. */
  private static final Set<String> LEFT_OUT =
      Set.of("read", "write", "mock", "shell", "run", "drive", "help");

  /** The options that choose a controller. */
  private static final Pattern CONTROLLER = Pattern.compile("--(host|port|mock|robot)(=.*)?");

  private final CommandTree program;
  private final SortedSet<String> names;

  ShellCommands(CommandTree program) {
    this.program = program;
    this.names = new TreeSet<>(program.commands());
    names.removeAll(LEFT_OUT);
  }

  /** Returns the names of the commands, sorted. */
  SortedSet<String> names() {
    return names;
  }

  /** Creates a command. */
  CommandLine commandLine(String name) {
    CommandLine main = program.commandLine(program.console(), name);
    return Objects.requireNonNull(main.getSubcommands().get(name));
  }

  void printHelp(Console console, String name) {
    program.run(console, name, "--help");
  }

  /**
   * Checks the arguments of a command, without running it.
   *
   * @throws ShellSyntaxException if they are wrong usage
   */
  void check(List<String> words) throws ShellSyntaxException {
    checkController(words);
    String[] args = ControllerCommand.withNamesAsOptions(words.toArray(String[]::new));
    try {
      program.commandLine(program.console(), args).parseArgs(args);
    } catch (ParameterException e) {
      throw new ShellSyntaxException(ConsoleCommand.message(e));
    }
  }

  /**
   * Runs a command.
   *
   * @param writeOptions the options of the shell, which apply to the command
   * @return its exit code
   * @throws ShellSyntaxException if it names another controller
   */
  ExitCode run(
      Console console, List<String> words, RobotConnection controller, WriteOptions writeOptions)
      throws ShellSyntaxException {
    checkController(words);
    String[] args = words.toArray(String[]::new);
    CommandLine command = CommandTree.find(program.commandLine(console, args), args);
    List<String> all = new ArrayList<>(words);
    all.addAll(
        CommandTree.depth(command),
        options(console, command.getCommandSpec(), controller, writeOptions));
    return program.run(console, all.toArray(String[]::new));
  }

  private static void checkController(List<String> words) throws ShellSyntaxException {
    for (String word : words) {
      String option = ControllerCommand.withNamesAsOptions(word)[0];
      if (CONTROLLER.matcher(option).matches()) {
        throw new ShellSyntaxException(
            word
                + ": commands here go to the controller of the shell; another needs its own shell");
      }
    }
  }

  private static List<String> options(
      Console console, CommandSpec command, RobotConnection controller, WriteOptions writeOptions) {
    boolean readOnly = writeOptions.permission(console).isReadOnly(controller.robot());
    List<String> options = new ArrayList<>();
    if (command.findOption("--host") != null) {
      ClientConfig config = controller.client().getConfig();
      options.add("--host=" + config.host());
      options.add("--port=" + config.port());
      Duration timeout = controller.robot().timeout();
      if (timeout != null) {
        options.add("--timeout=" + timeout.toMillis());
      }
    }
    if (readOnly && command.findOption("--read-only") != null) {
      options.add("--read-only");
    }
    if (writeOptions.isYes() && command.findOption("--yes") != null) {
      options.add("--yes");
    }
    return options;
  }
}
