package no.hials.crosscom.web.internal.robot;

import java.io.IOException;
import no.hials.crosscom.web.internal.audit.AuditLog;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;

/** Makes changes, each with a line in the audit log. A change is never repeated. */
public final class Changes {
  private final AuditLog audit;

  public Changes(AuditLog audit) {
    this.audit = audit;
  }

  /** Checks that a change is allowed, and makes it. */
  @FunctionalInterface
  public interface Change {
    void make() throws IOException;
  }

  /**
   * Makes a change.
   *
   * @param what the kind, such as {@code start}
   * @param name what is changed
   * @param value the new value; empty if there is none
   */
  public void make(
      Call call, RobotSession robot, String what, String name, String value, Change change)
      throws IOException {
    String result = "done";
    try {
      change.make();
    } catch (IOException | IllegalArgumentException e) {
      result = String.valueOf(e.getMessage());
      throw e;
    } catch (IllegalStateException e) { // of the simulated controller
      result = String.valueOf(e.getMessage());
      throw new CommandException(result);
    } finally {
      audit.add(
          new AuditLog.Entry(call.viewer().name(), robot.name(), what, name, "", value, result));
    }
  }
}
