package no.hials.crosscom.cell;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComException;

/**
 * Decides whether a front end may change something on a controller, and asks the user for
 * confirmation outside T1 or if the mode is unknown.
 */
public final class WritePermission {
  private static final String MODE = "$MODE_OP";
  private static final String SAFE_MODE = "#T1";

  private final boolean yes;
  private final boolean readOnly;
  private final Confirmation questions;

  /** Asks the user. */
  public interface Confirmation {
    /** Returns whether a person can be asked. */
    boolean isInteractive();

    /** Asks a question, and returns whether the answer is yes. */
    boolean confirm(String question);
  }

  /**
   * Creates a permission.
   *
   * @param yes whether the user has confirmed everything beforehand
   * @param readOnly whether nothing may be changed
   * @param questions asks the user
   */
  public WritePermission(boolean yes, boolean readOnly, Confirmation questions) {
    this.yes = yes;
    this.readOnly = readOnly;
    this.questions = questions;
  }

  /** Returns whether nothing may be changed on a robot. */
  public boolean isReadOnly(Robot robot) {
    return readOnly || robot.readOnlyBy() != null;
  }

  /**
   * Refuses any change of a read-only controller. Needs no connection.
   *
   * @param what the operation, such as {@code write $OV_PRO}
   * @throws NotSentException if the controller is read-only
   */
  public void checkAllowed(Robot target, String what) throws NotSentException {
    if (isReadOnly(target)) {
      String reason = readOnly ? "--read-only is given" : target.readOnlyBy();
      throw new NotSentException(target.label() + "did not " + what + ": " + reason);
    }
  }

  /**
   * Refuses a change that is not allowed. Asks for confirmation outside T1 or if the mode is
   * unknown, unless {@code --yes} is given.
   *
   * @param what the operation, such as {@code write $OV_PRO}
   * @throws NotSentException if the change is not allowed or not confirmed
   * @throws CrossComException if the connection broke
   */
  public void check(RobotConnection controller, String what) throws IOException {
    check(controller, what, List.of());
  }

  /**
   * Works like {@link #check(RobotConnection, String)}, and asks in any mode if there are other
   * reasons.
   *
   * @param reasons the other reasons to ask, such as {@code X.SRC already exists}
   */
  public void check(RobotConnection controller, String what, List<String> reasons)
      throws IOException {
    checkAllowed(controller.robot(), what);
    if (yes) {
      return;
    }
    List<String> all = new ArrayList<>(reasons);
    String mode = mode(controller);
    if (!mode.equalsIgnoreCase(SAFE_MODE)) {
      // a user who can be asked is told which mode needs no confirmation
      boolean asked = questions.isInteractive();
      all.add(MODE + " is " + mode + (asked ? ", not " + SAFE_MODE : ""));
    }
    if (!all.isEmpty()) {
      confirm(controller.robot().label(), what, String.join("; ", all));
    }
  }

  /**
   * Asks the user for confirmation.
   *
   * @param label the text to print before the question, see {@link Robot#label}
   * @throws NotSentException if no user can be asked, or the answer is no
   */
  public void confirm(String label, String what, String reason) throws NotSentException {
    if (!questions.isInteractive()) {
      throw new NotSentException(label + "did not " + what + ": " + reason + ", which needs --yes");
    }
    if (!questions.confirm(label + reason + ". Really " + what + "?")) {
      throw new NotSentException(label + "did not " + what + ": not confirmed");
    }
  }

  /**
   * Refuses a change that is not allowed, or that needs confirmation when no user can be asked.
   * Needs no connection.
   *
   * @param what the operation, such as {@code write $OV_PRO = 50}
   * @throws NotSentException if the change is not allowed or not confirmed
   */
  public void checkAskable(Robot target, String what) throws NotSentException {
    checkAllowed(target, what);
    if (!yes && !questions.isInteractive()) {
      throw new NotSentException(target.label() + "did not " + what + ": it needs --yes");
    }
  }

  /**
   * Refuses a change that is not allowed, and asks in any mode unless {@code --yes} is given. Used
   * for what is typed on a terminal, where a write is quickly typed.
   *
   * @param what the operation, such as {@code write $OV_PRO = 50}
   * @throws NotSentException if the change is not allowed or not confirmed
   * @throws CrossComException if the connection broke
   */
  public void checkEach(RobotConnection controller, String what) throws IOException {
    checkAskable(controller.robot(), what);
    if (yes) {
      return;
    }
    String label = controller.robot().label();
    String mode = mode(controller);
    String state =
        mode.equalsIgnoreCase(SAFE_MODE) ? "" : MODE + " is " + mode + ", not " + SAFE_MODE + ". ";
    if (!questions.confirm(label + state + "Really " + what + "?")) {
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
