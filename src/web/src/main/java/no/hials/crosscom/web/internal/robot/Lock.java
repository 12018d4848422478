package no.hials.crosscom.web.internal.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.WritePermission;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Json;
import org.jspecify.annotations.Nullable;

/**
 * The lock of a robot, which refuses changes until somebody unlocks it on the page. Thread-safe.
 */
public final class Lock {
  private final RobotConnection connection;
  private final boolean readOnly;
  private final WritePermission permission;
  private volatile @Nullable String openedBy;

  Lock(RobotConnection connection, boolean readOnly) {
    this.connection = connection;
    this.readOnly = readOnly;
    permission = new WritePermission(true, readOnly, new NoQuestions()); // the page has asked
  }

  /**
   * Checks that a change is allowed: the robot is unlocked, and the person has confirmed the change
   * ({@code "confirmed": true} in the message). Needs no connection.
   *
   * @param what the operation, such as {@code write $OV_PRO}
   * @throws IOException if it is not allowed
   */
  public void check(Call call, String what) throws IOException {
    permission.checkAllowed(connection.robot(), what);
    if (openedBy == null) {
      throw new CommandException("did not " + what + ": the robot is locked");
    }
    if (!call.flag("confirmed")) {
      throw new CommandException("did not " + what + ": not confirmed");
    }
  }

  /**
   * Unlocks the robot.
   *
   * @param who the person, for the header
   * @throws IOException if the robot is read-only
   */
  void open(String who) throws IOException {
    permission.checkAllowed(connection.robot(), "unlock the robot");
    openedBy = who;
  }

  void close() {
    openedBy = null;
  }

  /** Returns whether changes are allowed. */
  public boolean isOpen() {
    return openedBy != null;
  }

  ObjectNode json() {
    String readOnlyBy = readOnly ? "--read-only" : connection.robot().readOnlyBy();
    return Json.object()
        .put("open", openedBy != null)
        .put("by", openedBy)
        .put("read_only_by", readOnlyBy);
  }

  /** Never asks, since the page has asked already. */
  private static final class NoQuestions implements WritePermission.Confirmation {
    @Override
    public boolean isInteractive() {
      return false;
    }

    @Override
    public boolean confirm(String question) {
      return false;
    }
  }
}
