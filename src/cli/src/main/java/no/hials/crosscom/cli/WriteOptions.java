package no.hials.crosscom.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComException;
import picocli.CommandLine.Option;

/** The options of commands that change something on the controller, and the leave to do it. */
final class WriteOptions {
  private static final String MODE = "$MODE_OP";
  private static final String SAFE_MODE = "#T1";

  @Option(
      names = {"-y", "--yes"},
      order = 5,
      description = "Do not ask before something is changed outside T1, overwritten or deleted.")
  private boolean yes;

  @Option(
      names = "--read-only",
      order = 5,
      description = "Refuse whatever would change something, before it is sent.")
  private boolean readOnly;

  boolean isYes() {
    return yes;
  }

  /** Gives the settings of a connection on which one thing is changed. */
  Consumer<ClientConfig.Builder> connection() {
    // a server closes an idle connection, and the user may think about the answer for long
    return yes ? Robot.ONE_SHOT : cfg -> cfg.reconnect(false);
  }

  boolean isReadOnly(Robot target) {
    return readOnly || target.readOnly();
  }

  /**
   * Refuses what is never allowed: any change of a controller that is for reading only. Needs no
   * connection.
   *
   * @param what says what would be done, as {@code write $OV_PRO}
   * @throws NotSentException if the controller is for reading only
   */
  void checkAllowed(Robot target, String what) throws NotSentException {
    if (isReadOnly(target)) {
      String reason =
          readOnly
              ? "--read-only is given"
              : "by JOPENSHOWVAR_READ_ONLY or the configuration file it is for reading only";
      throw new NotSentException(target.label() + "did not " + what + ": " + reason);
    }
  }

  /**
   * Refuses what is not allowed, and asks where it takes a person's word: outside T1, or where the
   * mode is not to be had, unless {@code --yes} is given.
   *
   * @param what says what would be done, as {@code write $OV_PRO}
   * @throws NotSentException if it is not to be done
   * @throws CrossComException if the connection broke
   */
  void check(ConsoleCommand command, RobotConnection controller, String what) throws IOException {
    check(command, controller, what, List.of());
  }

  /**
   * Does what {@link #check(ConsoleCommand, RobotConnection, String)} does, and asks whatever the
   * mode is if there is another reason to.
   *
   * @param reasons why it takes a person's word, as {@code X.SRC is there already}
   */
  void check(ConsoleCommand command, RobotConnection controller, String what, List<String> reasons)
      throws IOException {
    checkAllowed(controller.target(), what);
    if (yes) {
      return;
    }
    List<String> all = new ArrayList<>(reasons);
    String mode = mode(controller);
    if (!mode.equalsIgnoreCase(SAFE_MODE)) {
      // who can be asked is told what would have needed no question
      boolean asked = command.console().isInteractive();
      all.add(MODE + " is " + mode + (asked ? ", not " + SAFE_MODE : ""));
    }
    if (!all.isEmpty()) {
      confirm(command, controller.target().label(), what, String.join("; ", all));
    }
  }

  /**
   * Asks for a person's word.
   *
   * @param label what to print before, see {@link Robot#label}
   * @throws NotSentException if there is nobody to ask, or the answer is no
   */
  static void confirm(ConsoleCommand command, String label, String what, String reason)
      throws NotSentException {
    if (!command.console().isInteractive()) {
      throw new NotSentException(label + "did not " + what + ": " + reason + ", which needs --yes");
    }
    if (!command.console().confirm(label + reason + ". Really " + what + "?")) {
      throw new NotSentException(label + "did not " + what + ": not confirmed");
    }
  }

  /**
   * Refuses what is not allowed, or where it takes a person's word and there is no person. Needs no
   * connection.
   *
   * @param what says what would be done, as {@code write $OV_PRO = 50}
   * @throws NotSentException if it is not to be done
   */
  void checkAskable(Console console, Robot target, String what) throws NotSentException {
    checkAllowed(target, what);
    if (!yes && !console.isInteractive()) {
      throw new NotSentException(target.label() + "did not " + what + ": it needs --yes");
    }
  }

  /**
   * Refuses what is not allowed, and asks in any mode unless {@code --yes} is given: for lines of
   * the shell language, where a write is quickly typed.
   *
   * @param what says what would be done, as {@code write $OV_PRO = 50}
   * @throws NotSentException if it is not to be done
   * @throws CrossComException if the connection broke
   */
  void checkEach(Console console, RobotConnection controller, String what) throws IOException {
    checkAskable(console, controller.target(), what);
    if (yes) {
      return;
    }
    String label = controller.target().label();
    String mode = mode(controller);
    String state =
        mode.equalsIgnoreCase(SAFE_MODE) ? "" : MODE + " is " + mode + ", not " + SAFE_MODE + ". ";
    if (!console.confirm(label + state + "Really " + what + "?")) {
      throw new NotSentException(label + "did not " + what + ": not confirmed");
    }
  }

  private static String mode(RobotConnection controller) throws IOException {
    try {
      return controller.client().readText(MODE).strip();
    } catch (CrossComAccessException e) {
      return "unknown";
    }
  }
}
