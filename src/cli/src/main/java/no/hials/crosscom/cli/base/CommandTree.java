package no.hials.crosscom.cli.base;

import java.util.List;
import picocli.CommandLine;

/** The program as its commands see it: the root of their tree. */
public interface CommandTree {
  Console console();

  /** Returns the names of all commands. */
  List<String> commands();

  /** Creates the tree of commands: all of it, or only what the arguments need. */
  CommandLine commandLine(Console console, String... args);

  /** Runs a command. */
  ExitCode run(Console console, String... args);
}
