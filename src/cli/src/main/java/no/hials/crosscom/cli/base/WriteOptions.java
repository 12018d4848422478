package no.hials.crosscom.cli.base;

import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.WritePermission;
import picocli.CommandLine.Option;

/** The options of commands that change something on the controller, and the permission. */
public final class WriteOptions {
  @Option(
      names = {"-y", "--yes"},
      order = 5,
      description =
          "Do not ask for confirmation before changes, and before files are overwritten or"
              + " deleted.")
  private boolean yes;

  @Option(
      names = "--read-only",
      order = 5,
      description = "Refuse to send anything that changes the controller.")
  private boolean readOnly;

  public boolean isYes() {
    return yes;
  }

  /** Returns the settings of a connection for one change. */
  public Consumer<ClientConfig.Builder> connection() {
    // the server may close the idle connection before the user answers
    return yes ? Robot.ONE_SHOT : cfg -> cfg.reconnect(false);
  }

  /** Returns the permission that these options give; the console asks the user. */
  public WritePermission permission(Console console) {
    return new WritePermission(yes, readOnly, console);
  }
}
