package no.hials.crosscom.web.internal.robot;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;

/** Makes changes, and adds a line to the audit log for each. Never repeats a change. */
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

  /** Makes a change that is allowed, and passes on the old value before it. */
  @FunctionalInterface
  public interface Replacement {
    void make(Consumer<String> oldValue) throws IOException;
  }

  /**
   * Makes a change whose old value is not known.
   *
   * @param what the kind, such as {@code start}
   * @param name what is changed
   * @param value the new value; empty if there is none
   */
  public void make(
      Call call, RobotSession robot, String what, String name, String value, Change change)
      throws IOException {
    replace(call, robot, what, name, value, oldValue -> change.make());
  }

  /**
   * Makes a change of a value.
   *
   * @param what the kind, such as {@code write}
   * @param name what is changed
   * @param value the new value
   */
  public void replace(
      Call call, RobotSession robot, String what, String name, String value, Replacement change)
      throws IOException {
    AtomicReference<String> before = new AtomicReference<>("");
    String result = "failed";
    try {
      change.make(before::set);
      result = "done";
    } catch (IOException | IllegalArgumentException e) {
      result = String.valueOf(e.getMessage());
      throw e;
    } catch (IllegalStateException e) { // from the simulated controller
      result = String.valueOf(e.getMessage());
      throw new CommandException(result);
    } finally {
      audit.add(
          new AuditLog.Entry(
              call.viewer().name(),
              robot.name(),
              what,
              name,
              requireNonNull(before.get()),
              value,
              result));
    }
  }
}
