package no.hials.crosscom.cli.base;

import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** The program as its commands see it: the root of their tree. */
public interface CommandTree {
  Console console();

  /** Returns the names of all commands. */
  List<String> commands();

  /** Creates the tree of commands: all of it, or only what the arguments need. */
  CommandLine commandLine(Console console, String... args);

  /** Runs a command. */
  ExitCode run(Console console, String... args);

  /** Returns the command that the arguments begin with: the program, or one below it. */
  static CommandLine find(CommandLine main, String... args) {
    CommandLine found = main;
    for (String arg : args) {
      CommandLine next = found.getSubcommands().get(arg);
      if (next == null) {
        return found;
      }
      found = next;
    }
    return found;
  }

  /** Returns a command and all below it, in the order of the help. */
  static Stream<CommandSpec> withAllBelow(CommandSpec command) {
    return Stream.concat(
        Stream.of(command),
        command.subcommands().values().stream().flatMap(sub -> withAllBelow(sub.getCommandSpec())));
  }

  /** Returns the number of arguments that name a command: 0 for the program. */
  static int depth(CommandLine command) {
    CommandLine parent = command.getParent();
    return parent == null ? 0 : 1 + depth(parent);
  }
}
