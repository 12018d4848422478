package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.c3.Programs;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
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
      "Prints $PRO_NAME1[] and $PRO_STATE1 (with --submit: $PRO_NAME0[] and $PRO_STATE0), read"
          + " when the controller has accepted the command. JSON: one object with command,"
          + " interpreter, program and state; a variable that cannot be read is null.",
      "",
      "A command is never repeated; if no answer arrives, it may or may not have been executed.",
      "",
      "Examples:",
      "  jopenshowvar program start --host 172.31.1.147",
      "  jopenshowvar program stop --host 172.31.1.147",
      "  jopenshowvar program cancel --submit --host 172.31.1.147"
    })
final class ProgramOrder extends BridgeCommand {
  private static final String GENERAL_HINT = "likely cause: no program is selected";

  @Option(
      names = "--submit",
      description = "Use the submit interpreter instead of the robot interpreter.")
  private boolean submit;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  private final String verb;
  private final Order order;

  /** Sends the command. */
  @FunctionalInterface
  interface Order {
    void send(Programs programs, Interpreter interpreter) throws IOException;
  }

  ProgramOrder(String verb, Order order) {
    this.verb = verb;
    this.order = order;
  }

  @Override
  public ExitCode run() throws IOException {
    Interpreter interpreter = submit ? Interpreter.SUBMIT : Interpreter.ROBOT;
    String what = verb + " the program of the " + (submit ? "submit" : "robot") + " interpreter";
    try (RobotConnection controller = open(writeOptions, what)) {
      // no question delays a stop
      if (!verb.equals("stop")) {
        ask(writeOptions, controller, what, MessageType.PROGRAM_CONTROL);
      }
      order.send(controller.client().programs(), interpreter);
      ProgramStatus.read(controller.client(), interpreter).print(this, verb);
      return ExitCode.DONE;
    } catch (CrossComRefusedException e) {
      return refused(e, GENERAL_HINT);
    }
  }

  @Override
  String accessHint() {
    return verb.equals("start") ? START_HINT : super.accessHint();
  }
}
