package no.hials.crosscom.cli.shell;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.WriteAnswer;
import no.hials.crosscom.cell.recording.OutputException;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.WriteOptions;

/** Executes lines of the shell language on one controller. */
final class ShellSession {
  private final Console console;
  private final RobotConnection controller;
  private final WriteOptions writeOptions;
  private final ShellSymbols symbols;
  private final ShellCommands commands;

  ShellSession(
      Console console,
      RobotConnection controller,
      WriteOptions writeOptions,
      ShellSymbols symbols,
      ShellCommands commands) {
    this.console = console;
    this.controller = controller;
    this.writeOptions = writeOptions;
    this.symbols = symbols;
    this.commands = commands;
  }

  ShellLine parse(String line) throws ShellSyntaxException {
    return ShellLine.parse(line, commands.names());
  }

  private ExitCode run(ShellLine line) throws IOException {
    try {
      return line.run(this);
    } catch (IllegalArgumentException e) {
      // the name or the text cannot be sent
      throw new ShellSyntaxException(String.valueOf(e.getMessage()));
    }
  }

  ExitCode run(List<String> command) throws IOException {
    return commands.run(console, command, controller, writeOptions);
  }

  /**
   * Executes a line, and prints the error if it fails.
   *
   * @param place the text before the message, such as {@code FILE:3: }
   * @return the exit code
   */
  ExitCode run(String place, ShellLine line, boolean verbose) {
    try {
      return run(line);
    } catch (IOException e) {
      console.failure(place, e, verbose);
      return e instanceof ShellSyntaxException ? ExitCode.USAGE : ExitCode.of(e);
    } catch (OutputException e) {
      throw e.at(place);
    }
  }

  void read(List<String> names) throws IOException {
    for (String name : names) {
      console.print(name + " = " + controller.client().readText(name));
      symbols.used(name);
    }
  }

  void write(ShellLine.Write write) throws IOException {
    controller.client().checkText(write.name(), write.value());
    writeOptions.permission(console).checkEach(controller, write.toString());
    String answer = controller.client().writeText(write.name(), write.value());
    symbols.used(write.name());
    WriteAnswer.check(write.name(), write.value(), answer);
    String change = write.name() + " = " + write.value();
    console.printChange(change, change);
  }

  static void sleep(Duration time) throws ShellSyntaxException {
    try {
      Thread.sleep(time.toMillis());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new ShellSyntaxException("interrupted");
    }
  }

  void help(String topic) throws ShellSyntaxException {
    String lower = ShellLine.canonical(topic);
    if (topic.isEmpty()) {
      ShellHelp.language(commands.names()).forEach(console::print);
    } else if (ShellLine.BUILT_INS.containsKey(lower)) {
      console.print(Objects.requireNonNull(ShellLine.BUILT_INS.get(lower)).line());
    } else if (commands.names().contains(lower)) {
      commands.printHelp(console, lower);
    } else {
      Optional<CatalogueEntry> symbol = symbols.find(topic);
      if (symbol.isEmpty()) {
        throw new ShellSyntaxException("unknown command or variable: " + topic + "; try vars WORD");
      }
      ShellHelp.of(topic, symbol.get(), symbols.known()).forEach(console::print);
    }
  }
}
