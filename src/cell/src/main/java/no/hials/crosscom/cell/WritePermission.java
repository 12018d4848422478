package no.hials.crosscom.cell;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComException;

/**
 * Decides whether a front end may change something on a controller, and asks the user where that
 * takes a person's decision: outside T1, or where the mode is unknown.
 */
public final class WritePermission {
  private static final String MODE = "$MODE_OP";
  private static final String SAFE_MODE = "#T1";

  private final boolean yes;
  private final boolean readOnly;
  private final Questions questions;

  /** Asks the user. */
  public interface Questions {
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
  public WritePermission(boolean yes, boolean readOnly, Questions questions) {
    this.yes = yes;
    this.readOnly = readOnly;
    this.questions = questions;
  }

  /** Returns whether nothing may be changed on a robot. */
  public boolean isReadOnly(Robot robot) {
    return readOnly || robot.readOnly();
  }

  /**
   * Refuses what is never allowed: any change of a controller that is for reading only. Needs no
   * connection.
   *
   * @param what says what would be done, as {@code write $OV_PRO}
   * @throws NotSentException if the controller is for reading only
   */
  public void checkAllowed(Robot target, String what) throws NotSentException {
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
  public void check(RobotConnection controller, String what) throws IOException {
    check(controller, what, List.of());
  }

  /**
   * Does what {@link #check(RobotConnection, String)} does, and asks whatever the mode is if there
   * is another reason to.
   *
   * @param reasons why it takes a person's word, as {@code X.SRC is there already}
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
      // who can be asked is told what would have needed no question
      boolean asked = questions.isInteractive();
      all.add(MODE + " is " + mode + (asked ? ", not " + SAFE_MODE : ""));
    }
    if (!all.isEmpty()) {
      confirm(controller.robot().label(), what, String.join("; ", all));
    }
  }

  /**
   * Asks for a person's word.
   *
   * @param label what to print before, see {@link Robot#label}
   * @throws NotSentException if there is nobody to ask, or the answer is no
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
   * Refuses what is not allowed, or where it takes a person's word and there is no person. Needs no
   * connection.
   *
   * @param what says what would be done, as {@code write $OV_PRO = 50}
   * @throws NotSentException if it is not to be done
   */
  public void checkAskable(Robot target, String what) throws NotSentException {
    checkAllowed(target, what);
    if (!yes && !questions.isInteractive()) {
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
