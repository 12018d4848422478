package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.c3.Programs;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.code.Interpreter;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code program start}, {@code stop}, {@code reset} and {@code cancel}. */
@Command(
    footerHeading = "%n",
    footer = {
      "Printed is what $PRO_NAME1[] and $PRO_STATE1 (of the submit interpreter $PRO_NAME0[] and"
          + " $PRO_STATE0) say right after the answer, which says that the command was accepted."
          + " JSON: one object with command, interpreter, program and state; what could not be read"
          + " is null.",
      "",
      "A command is never repeated; if no answer came, the message says that it may have been done"
          + " or not.",
      "",
      "Examples:",
      "  jopenshowvar program start --host 172.31.1.147",
      "  jopenshowvar program stop --host 172.31.1.147",
      "  jopenshowvar program cancel --submit --host 172.31.1.147"
    })
abstract class ProgramOrder extends BridgeCommand {
  private static final String GENERAL_HINT = "likely cause: no program is selected";

  @Option(
      names = "--submit",
      description = "The program of the submit interpreter, not the robot's.")
  private boolean submit;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  private final String verb;

  ProgramOrder(String verb) {
    this.verb = verb;
  }

  /** Sends the command. */
  abstract void send(Programs programs, Interpreter interpreter) throws IOException;

  /** Returns whether it makes the robot stand still, and so is never held up by a question. */
  boolean isStop() {
    return false;
  }

  @Override
  public final ExitCode run() throws IOException {
    Interpreter interpreter = submit ? Interpreter.SUBMIT : Interpreter.ROBOT;
    String what = verb + " the program of the " + (submit ? "submit" : "robot") + " interpreter";
    Robot target = target();
    writeOptions.permission(console()).checkAllowed(target, what);
    try (RobotConnection controller = Robots.open(target, writeOptions.connection())) {
      if (!isStop()) {
        ask(writeOptions, controller, what, MessageType.PROGRAM_CONTROL);
      }
      send(controller.client().programs(), interpreter);
      ProgramStatus state = ProgramStatus.read(controller.client(), interpreter);
      console().print(isJson() ? state.json(verb) : state.line());
      return ExitCode.DONE;
    } catch (CrossComRefusedException e) {
      return refused(e, GENERAL_HINT);
    }
  }

  /** {@code program start}. */
  @Command(
      name = "start",
      description = {
        "Starts the selected program, or goes on with one that was stopped. The robot moves."
      })
  static final class Start extends ProgramOrder {
    Start() {
      super("start");
    }

    @Override
    void send(Programs programs, Interpreter interpreter) throws IOException {
      programs.start(interpreter);
    }
  }

  /** {@code program stop}. */
  @Command(
      name = "stop",
      description = {
        "Stops the running program. It never asks, in no mode, since it makes the robot stand still;"
            + " --read-only refuses it, as everything that is sent. This is no emergency stop: it"
            + " takes a working network."
      })
  static final class Stop extends ProgramOrder {
    Stop() {
      super("stop");
    }

    @Override
    boolean isStop() {
      return true;
    }

    @Override
    void send(Programs programs, Interpreter interpreter) throws IOException {
      programs.stop(interpreter);
    }
  }

  /** {@code program reset}. */
  @Command(
      name = "reset",
      description = {"Resets the selected program, so that a start runs it from the beginning."})
  static final class Reset extends ProgramOrder {
    Reset() {
      super("reset");
    }

    @Override
    void send(Programs programs, Interpreter interpreter) throws IOException {
      programs.reset(interpreter);
    }
  }

  /** {@code program cancel}. */
  @Command(
      name = "cancel",
      description = {"Cancels the selection of the program."})
  static final class Cancel extends ProgramOrder {
    Cancel() {
      super("cancel");
    }

    @Override
    void send(Programs programs, Interpreter interpreter) throws IOException {
      programs.cancel(interpreter);
    }
  }
}
