package no.hials.crosscom.cell.feed;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import no.hials.crosscom.cell.AsyncCalls;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.NotSentException;
import no.hials.crosscom.cell.WriteAnswer;
import no.hials.crosscom.protocol.value.KrlArray;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlSyntaxException;
import no.hials.crosscom.protocol.value.KrlValue;

/**
 * Writes variables for other systems, if the configuration allows it. Each write has a line in the
 * audit log and is never repeated.
 */
public final class Writes {
  private final AuditLog audit;
  private volatile boolean ended;

  /** Creates an object that adds its lines to an audit log. */
  public Writes(AuditLog audit) {
    this.audit = audit;
  }

  /** Refuses all writes that have not been sent yet. */
  public void end() {
    ended = true;
  }

  /**
   * Writes one value.
   *
   * @param who the other system, for the audit log
   * @param plant the plant, whose settings say what may be written
   * @param name the variable or field
   * @param text the value as KRL writes it
   * @param sendWithin the time from now within which the write must be sent
   * @throws LateWriteException if the connection was not free in time; nothing was sent
   * @throws RefusedWriteException if the write is not allowed; nothing was sent
   * @throws InterruptedIOException if the thread was interrupted after the write was sent, so that
   *     its outcome is unknown
   * @throws IOException if the write failed; the message says if its outcome is unknown
   */
  public void write(
      String who, Plant plant, RobotFeed robot, String name, String text, Duration sendWithin)
      throws IOException {
    String value = text.strip();
    String before = lastText(robot, name); // a reading during the write can have the new value
    String result = "failed";
    try {
      check(plant, robot, name, value);
      WriteAnswer.check(name, value, send(robot, name, value, sendWithin));
      result = "done";
    } catch (IOException | IllegalArgumentException e) {
      result = String.valueOf(e.getMessage());
      throw e;
    } catch (RuntimeException e) {
      result = e.toString();
      throw e;
    } finally {
      add(who, robot.name(), name, before, value, result);
    }
  }

  private String send(RobotFeed robot, String name, String text, Duration sendWithin)
      throws IOException {
    String target = robot.name() + ": " + name;
    String late = target + " was not written: it waited too long for the connection to the robot";
    if (sendWithin.isNegative() || sendWithin.isZero()) {
      throw new LateWriteException(late);
    }
    long latest = System.nanoTime() + sendWithin.toNanos();
    CompletableFuture<String> answer =
        robot
            .client()
            .async(
                client -> client.writeText(name, text),
                () -> !ended && System.nanoTime() - latest < 0);
    try {
      return AsyncCalls.await(answer, sendWithin);
    } catch (NotSentException | CancellationException e) {
      checkNotEnded(target);
      throw new LateWriteException(late);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      if (answer.cancel(false)) {
        throw new RefusedWriteException(target + " was not written: its thread was interrupted");
      }
      throw new InterruptedIOException(
          target + ": the thread was interrupted during the write; the outcome is unknown");
    }
  }

  /**
   * Adds the line of a write that was not tried.
   *
   * @param reason why it was not
   */
  public void refused(String who, RobotFeed robot, String name, String text, String reason) {
    add(who, robot.name(), name, lastText(robot, name), text, reason);
  }

  /** Adds the line of a write to a robot that is not connected. */
  public void refused(String who, String robot, String name, String text, String reason) {
    add(who, robot, name, "", text, reason);
  }

  private static String lastText(RobotFeed robot, String name) {
    return robot.lastValue(name).map(KrlValue::print).orElse("");
  }

  private void add(
      String who, String robot, String name, String before, String value, String result) {
    audit.add(new AuditLog.Entry(who, robot, "write", name, before, value, result));
  }

  /** Refuses a write that the configuration does not allow. */
  private void check(Plant plant, RobotFeed robot, String name, String text) throws IOException {
    String target = robot.name() + ": " + name;
    checkNotEnded(target);
    String readOnly = robot.plan().robot().readOnlyBy();
    if (readOnly != null) {
      throw new RefusedWriteException(target + " was not written: " + readOnly);
    }
    VariableSettings settings = plant.settings(name);
    if (settings == null || !settings.writable()) {
      throw new RefusedWriteException(
          target + " was not written: the configuration does not allow it (write = true)");
    }
    KrlValue value = scalar(target, text);
    boolean isNumber = value instanceof KrlInt || value instanceof KrlReal;
    if (isNumber && settings.range() != null) {
      if (!settings.range().contains(value.asDouble())) {
        throw new RefusedWriteException(
            target + " was not written: must be " + settings.range() + ", is " + text);
      }
    } else if (!settings.lists(value, text)) {
      String allowed =
          settings.values().isEmpty()
              ? "a number of " + settings.range()
              : "one of " + String.join(", ", settings.values());
      throw new RefusedWriteException(
          target + " was not written: must be " + allowed + ", is " + text);
    }
    robot.client().checkText(name, text);
  }

  private void checkNotEnded(String target) throws RefusedWriteException {
    if (ended) {
      throw new RefusedWriteException(target + " was not written: the gateway ends");
    }
  }

  /** Returns the value of a text, which is not a structure or an array. */
  private static KrlValue scalar(String target, String text) throws IOException {
    KrlValue value;
    try {
      value = KrlValue.parse(text);
    } catch (KrlSyntaxException e) {
      throw new RefusedWriteException(
          target + " was not written: the value is not one of KRL: " + e.getMessage());
    }
    if (value instanceof KrlStruct || value instanceof KrlArray) {
      throw new RefusedWriteException(
          target + " was not written: a field or an element can be written, not a whole value");
    }
    return value;
  }
}
