package no.hials.crosscom.cli.bridge;

import java.io.IOException;
import java.util.Locale;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.cell.JsonLine;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.WritePermission;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.WriteOptions;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The common parts of the commands that need C3 Bridge or show the server. */
public abstract class BridgeCommand extends ControllerCommand {
  /** Longer than any name on a controller; two of them fit into a message. */
  private static final int MAX_LENGTH = 10_000;

  static final String START_HINT =
      "likely cause: the operating mode or the state of the program does not allow it, or a message"
          + " has to be confirmed ('jopenshowvar confirm')";

  @Option(names = "--json", order = 5, description = "Print JSON, see below.")
  private boolean json;

  public final boolean isJson() {
    return json;
  }

  @Override
  protected final ServerType simulated() {
    return ServerType.C3_BRIDGE;
  }

  /**
   * Asks before a change as {@link WritePermission#check(RobotConnection, String)} does; not if the
   * server does not support the change; the client then refuses to send it.
   */
  final void ask(WriteOptions options, RobotConnection controller, String what, MessageType needed)
      throws IOException {
    if (controller.client().getServer().knows(needed)) {
      options.permission(console()).check(controller, what);
    }
  }

  /** Prints a change as a line, or as JSON an object of fields and their values. */
  final void print(String line, @Nullable String... fields) {
    console()
        .printChange(
            line,
            json
                ? JsonLine.object(
                    object -> {
                      for (int i = 0; i < fields.length; i += 2) {
                        object.writeStringField(fields[i], fields[i + 1]);
                      }
                    })
                : line);
  }

  /** Returns a constant such as {@code VIRTUAL_DIRECTORY} in words. */
  static String words(String constant) {
    return constant.toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  /** Checks that a text can be a name; otherwise it is wrong usage. */
  final String checked(String label, String text) {
    if (text.isBlank()) {
      throw wrongUsage(label + " must not be blank");
    }
    return checkedLength(label, text);
  }

  final String checkedLength(String label, String text) {
    if (text.length() > MAX_LENGTH) {
      throw wrongUsage(
          label + " must have at most " + MAX_LENGTH + " characters, has " + text.length());
    }
    return text;
  }

  /**
   * Prints that the controller refused, and possible reasons.
   *
   * @param general the likely cause if it gives no reason, which is code 0
   */
  final ExitCode refused(CrossComRefusedException e, String general) {
    console().failure(e, isVerbose());
    ErrorCode code = e.getErrorCode().orElse(null);
    if (code == ErrorCode.GENERAL) {
      console().hint(general);
    } else if (code == ErrorCode.ACCESS) {
      console().hint(accessHint());
    }
    return ExitCode.REFUSED;
  }

  /** Returns possible reasons for denied access. */
  String accessHint() {
    return "likely cause: the operating mode or the state of the program does not allow it";
  }
}
