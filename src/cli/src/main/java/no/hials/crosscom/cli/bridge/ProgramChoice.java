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
import picocli.CommandLine.Parameters;

/** {@code program select} and {@code program run}, for a named program of the robot interpreter. */
@Command(
    footerHeading = "%n",
    footer = {
      "PROGRAM is /R1/NAME, NAME alone, or a full path KRC:\\R1\\PROGRAM\\NAME.SRC. In sh and"
          + " bash, a name with backslashes needs single quotes; PowerShell and cmd.exe need"
          + " none.",
      "",
      "'run' starts the program again when it stops at the end of its BCO run, the slow first"
          + " motion after a selection in T1, T2 and AUT. A program that has stopped for another"
          + " reason is exit code 1.",
      "",
      "Prints $PRO_NAME1[] and $PRO_STATE1, read directly after the command. JSON: one object"
          + " with command, interpreter, program and state; a variable that cannot be read is"
          + " null.",
      "",
      "The controller refuses a program with errors with code 0 (GENERAL), which gives no"
          + " reason. A command is never repeated; if no answer arrives, it may or may not have"
          + " been executed.",
      "",
      "Examples:",
      "  jopenshowvar program select /R1/ACTUATOR --host 172.31.1.147",
      "  jopenshowvar program select 'KRC:\\R1\\PROGRAM\\ACTUATOR.SRC' --host 172.31.1.147",
      "  jopenshowvar program run /R1/WELD --parameters '5,TRUE' --host 172.31.1.147"
    })
final class ProgramChoice extends BridgeCommand {
  private static final String GENERAL_HINT =
      "likely cause: there is no such program, or it has errors";

  @Parameters(index = "0", paramLabel = "PROGRAM", description = "The program, such as /R1/MAIN.")
  private String program = "";

  @Option(
      names = "--parameters",
      paramLabel = "TEXT",
      description = "The arguments of the program: KRL values, separated by commas.")
  private String parameters = "";

  @Option(
      names = "--force",
      description =
          "Select the program even if another one is active. The effect on a real controller is"
              + " not documented.")
  private boolean force;

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  private final String verb;
  private final Choice choice;

  /** Sends the command. */
  @FunctionalInterface
  interface Choice {
    void send(Programs programs, String name, String arguments, boolean force) throws IOException;
  }

  ProgramChoice(String verb, Choice choice) {
    this.verb = verb;
    this.choice = choice;
  }

  @Override
  public ExitCode run() throws IOException {
    String name = checked("PROGRAM", program);
    String arguments = checkedLength("--parameters", parameters);
    String what = verb + " " + name;
    try (RobotConnection controller = open(writeOptions, what)) {
      ask(writeOptions, controller, what, MessageType.PROGRAM_CONTROL);
      choice.send(controller.client().programs(), name, arguments, force);
      if (verb.equals("run")) {
        BcoRun.complete(controller.client());
      }
      ProgramStatus status = ProgramStatus.read(controller.client(), Interpreter.ROBOT);
      status.print(this, verb);
      if (verb.equals("run") && "#P_STOP".equals(status.state())) {
        console().error("the program has stopped");
        console().hint("likely cause: a message to confirm, a HALT, or a BCO run without an end");
        return ExitCode.REFUSED;
      }
      return ExitCode.DONE;
    } catch (CrossComRefusedException e) {
      return refused(e, GENERAL_HINT);
    }
  }

  @Override
  String accessHint() {
    return verb.equals("run") ? START_HINT : super.accessHint();
  }
}
