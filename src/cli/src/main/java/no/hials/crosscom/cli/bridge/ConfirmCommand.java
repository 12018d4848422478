package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.protocol.MessageType;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code confirm}. */
@Command(
    name = "confirm",
    description =
        "Confirms all messages of the controller that can be confirmed, through C3 Bridge. A"
            + " program that waits for a confirmation can continue.",
    footer = {
      "",
      "JSON: {\"command\":\"confirm\"}",
      "",
      "Examples:",
      "  jopenshowvar confirm --host 172.31.1.147"
    })
public final class ConfirmCommand extends BridgeCommand {
  private static final String WHAT = "confirm all messages";

  @Mixin private WriteOptions writeOptions = new WriteOptions();

  @Override
  public ExitCode run() throws IOException {
    try (RobotConnection controller = open(writeOptions, WHAT)) {
      ask(writeOptions, controller, WHAT, MessageType.CONFIRM_ALL);
      controller.client().information().confirmAll();
    } catch (CrossComRefusedException e) {
      return refused(e, "the server gives no reason");
    }
    print("all messages confirmed", "command", "confirm");
    return ExitCode.DONE;
  }
}
