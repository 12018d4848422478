package no.hials.crosscom.cli.shell;

import java.io.BufferedReader;
import java.io.IOException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.StoppedException;
import no.hials.crosscom.cli.base.WriteOptions;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code shell}. */
@Command(
    name = "shell",
    description =
        "Reads and writes variables line by line, on one connection, until Ctrl-D or exit. A write"
            + " can move a machine.",
    footer = {
      "",
      "$OV_PRO reads, $OV_PRO = 50 or $OV_PRO 50 writes; 'help' lists all commands. Names need"
          + " no quotes. Tab completes commands, names, fields and constants of enumerations,"
          + " with C3 Bridge also variables from the data lists on the controller. In every mode,"
          + " the shell asks for confirmation before each write, unless --yes is given.",
      "",
      "If a line fails, the shell prints the reason and continues. After a lost connection, the"
          + " next line reconnects. A write is never repeated.",
      "",
      "If stdin or stdout is not a terminal, the shell reads commands from stdin without a"
          + " prompt, and stops at the first line that fails, with the exit code of that line."
          + " Writes then need --yes.",
      "",
      "The history is in ~/.local/state/jopenshowvar/history, or under $XDG_STATE_HOME if it is"
          + " set. A line that begins with a blank is not added.",
      "",
      "Examples:",
      "  jopenshowvar shell --host 172.31.1.147",
      "  jopenshowvar shell --mock --server c3",
      "  echo 'get $POS_ACT $OV_PRO' | jopenshowvar shell --mock"
    })
public final class ShellCommand extends ControllerCommand {
  @Mixin private WriteOptions writeOptions = new WriteOptions();

  @Override
  public ExitCode run() throws IOException {
    Robot target = target();
    try (RobotConnection controller = Robots.open(target, Robot.LASTING)) {
      ShellSymbols symbols = new ShellSymbols(controller);
      if (console().isInteractive()) {
        return converse(controller, symbols);
      }
      ShellSession session = session(console(), controller, symbols);
      return runLines(session, new BufferedReader(console().in()));
    }
  }

  private ShellSession session(Console console, RobotConnection controller, ShellSymbols symbols) {
    return new ShellSession(
        console, controller, writeOptions, symbols, new ShellCommands(program()));
  }

  private ExitCode runLines(ShellSession session, BufferedReader lines) throws IOException {
    int number = 0;
    for (String text = lines.readLine(); text != null; text = lines.readLine()) {
      number++;
      String place = "line " + number + ": ";
      ShellLine line;
      try {
        line = session.parse(text);
      } catch (ShellSyntaxException e) {
        console().error(place + e.getMessage());
        return ExitCode.USAGE;
      }
      if (line instanceof ShellLine.Exit) {
        break;
      }
      ExitCode code = session.run(place, line, isVerbose());
      if (code != ExitCode.DONE) {
        return code;
      }
    }
    return ExitCode.DONE;
  }

  private ShellTerminal terminal(ShellSymbols symbols) throws IOException {
    try {
      return new ShellTerminal(
          console(), new ShellCompleter(new ShellCommands(program()), symbols));
    } catch (IOException | IllegalStateException e) {
      if (StopSignal.isShuttingDown()) { // then JLine gives no terminal, or closes it
        throw new StoppedException();
      }
      throw e;
    }
  }

  private ExitCode converse(RobotConnection controller, ShellSymbols symbols) throws IOException {
    symbols.preload();
    try (ShellTerminal terminal = terminal(symbols)) {
      Console asking = terminal.console(console());
      ShellSession session = session(asking, controller, symbols);
      ShellPrompt prompt =
          new ShellPrompt(
              controller, writeOptions.permission(asking).isReadOnly(controller.robot()));
      String text = terminal.readLine(prompt);
      while (text != null && runTyped(text, asking, session, prompt)) {
        text = terminal.readLine(prompt);
      }
      return ExitCode.DONE;
    }
  }

  /** Runs a line, or several pasted lines up to the first that fails; returns false for exit. */
  private boolean runTyped(String text, Console asking, ShellSession session, ShellPrompt prompt) {
    for (String typed : text.lines().toList()) {
      try {
        ShellLine line = session.parse(typed);
        if (line instanceof ShellLine.Exit) {
          return false;
        }
        ExitCode code = session.run("", line, isVerbose());
        prompt.ended(code);
        if (code != ExitCode.DONE) {
          break;
        }
      } catch (ShellSyntaxException e) {
        asking.error(String.valueOf(e.getMessage()));
        asking.hint("try 'help'");
        break;
      }
    }
    return true;
  }
}
