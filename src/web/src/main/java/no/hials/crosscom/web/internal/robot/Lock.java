package no.hials.crosscom.web.internal.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Supplier;
import no.hials.crosscom.cell.AsyncCalls;
import no.hials.crosscom.cell.NotSentException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.WritePermission;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Json;
import org.jspecify.annotations.Nullable;

/**
 * The lock of a robot, which refuses changes until somebody unlocks it on the page; only a stop
 * needs no unlocking. Thread-safe.
 */
public final class Lock {
  private static final Duration LONGEST_UPLOAD = Duration.ofHours(1);

  private final Robot robot;
  private final boolean readOnly;
  private final WritePermission permission;
  private volatile @Nullable String openedBy;
  private volatile long stoppedAt = Long.MIN_VALUE;
  private volatile long lockedAt = Long.MIN_VALUE;

  /** The changes that may still wait for the connection; guarded by itself. */
  private final Set<Waiting> waiting = new HashSet<>();

  private record Waiting(Call call, CompletableFuture<?> change) {}

  Lock(Robot robot, boolean readOnly) {
    this.robot = withoutFolder(robot);
    this.readOnly = readOnly;
    permission = new WritePermission(true, readOnly, new NoQuestions()); // the page has asked
  }

  /**
   * Returns a robot whose {@code read-only = true in FILE} has only the name of the file: pages
   * need not know its folder.
   */
  private static Robot withoutFolder(Robot robot) {
    String reason = robot.readOnlyBy();
    if (reason == null || !reason.contains(" in ")) {
      return robot;
    }
    int start = reason.indexOf(" in ") + " in ".length();
    int name = Math.max(reason.lastIndexOf('/'), reason.lastIndexOf('\\')) + 1;
    return new Robot(
        robot.name(),
        robot.host(),
        robot.port(),
        robot.timeout(),
        reason.substring(0, start) + reason.substring(Math.max(name, start)),
        robot.server(),
        robot.charset());
  }

  /**
   * Checks that a change is allowed: there is no {@link #refusal}, and the person has confirmed it
   * ({@code "confirmed": true} in the message). Needs no connection.
   *
   * @param what the operation, such as {@code write $OV_PRO}
   * @throws IOException if it is not allowed
   */
  public void check(Call call, String what) throws IOException {
    permission.checkAllowed(robot, what);
    String refusal = refusal(call);
    if (!refusal.isEmpty()) {
      throw new CommandException("did not " + what + ": " + refusal);
    }
    if (!call.optionalFlag("confirmed")) {
      throw new CommandException("did not " + what + ": not confirmed");
    }
  }

  /**
   * Returns why a change that was allowed is not any more; empty if it still is. May be called by
   * any thread, also for a change that goes on for a while.
   */
  public String refusal(Call call) {
    if (openedBy == null) {
      return "the robot is locked";
    }
    if (call.isFromBefore(stoppedAt)) {
      return "a program of the robot was stopped meanwhile; look at the robot, and try again";
    }
    if (call.isFromBefore(lockedAt)) { // it may be unlocked again
      return "the robot was locked meanwhile; look at the robot, and try again";
    }
    if (call.isWithdrawn()) {
      return "it was cancelled on the page";
    }
    return call.viewer().isClosed() ? "the page that sent it is gone" : "";
  }

  /**
   * Makes a change if it is allowed, and waits for its end. It is cancelled if the client has not
   * sent it when the robot is locked, a program is stopped, the page is gone, or the message of the
   * page is too old.
   *
   * @param what the operation, as for {@link #check}
   * @param start lets the client send one request in another thread, without waiting for it, if the
   *     condition is true just before; the future can be cancelled until that is sent
   * @return the result
   * @throws IOException if it was not allowed, or failed
   */
  public <T extends @Nullable Object> T send(
      Call call, String what, Function<BooleanSupplier, CompletableFuture<T>> start)
      throws IOException {
    return send(
        call,
        what,
        call.timeLeft(),
        () -> start.apply(() -> refusal(call).isEmpty() && !call.timeLeft().isNegative()));
  }

  /**
   * Uploads a file if it is allowed, as {@link #send} does. The time of the transfer does not
   * count: a file can be cancelled until it takes effect.
   */
  public <T extends @Nullable Object> T upload(
      Call call, String what, Supplier<CompletableFuture<T>> start) throws IOException {
    return send(call, what, LONGEST_UPLOAD, start);
  }

  private <T extends @Nullable Object> T send(
      Call call, String what, Duration sendWithin, Supplier<CompletableFuture<T>> start)
      throws IOException {
    call.checkAge();
    Waiting own;
    CompletableFuture<T> change;
    // a refusal comes before the check, or finds the change among those that wait
    synchronized (waiting) {
      check(call, what);
      change = start.get();
      own = new Waiting(call, change);
      waiting.add(own);
    }
    try {
      return AsyncCalls.await(change, sendWithin);
    } catch (NotSentException e) {
      throw new CommandException("did not " + what + ": " + e.getMessage());
    } catch (CancellationException e) {
      check(call, what);
      call.checkAge();
      throw new CommandException("did not " + what + ": it was not allowed any more");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CommandException(
          change.cancel(false)
              ? "did not " + what + ": the page's server ends"
              : "the page's server ends; it is not known whether it did " + what);
    } finally {
      synchronized (waiting) {
        waiting.remove(own);
      }
    }
  }

  /**
   * Cancels the changes that are no longer allowed and that the client has not sent yet. Called
   * after the reason for it is known to {@link #refusal}.
   */
  void cancelRefused() {
    synchronized (waiting) {
      waiting.forEach(
          one -> {
            if (!refusal(one.call).isEmpty()) {
              boolean unused = one.change.cancel(false);
            }
          });
    }
  }

  /**
   * Checks that a stop is allowed, which only a read-only robot refuses. It makes a robot safer, so
   * it needs neither an unlocked robot nor a confirmation, like {@code program stop}.
   *
   * @param what the operation, such as {@code stop the program}
   * @throws IOException if it is not allowed
   */
  public void checkStop(String what) throws IOException {
    permission.checkAllowed(robot, what);
  }

  /** Refuses from now on the changes that pages have sent until now and that still wait. */
  public void refuseWaiting() {
    stoppedAt = Call.now();
    cancelRefused();
  }

  /**
   * Unlocks the robot.
   *
   * @param who the person, for the header
   * @throws IOException if the robot is read-only
   */
  void open(String who) throws IOException {
    permission.checkAllowed(robot, "unlock the robot");
    openedBy = who;
  }

  void close() {
    openedBy = null;
    lockedAt = Call.now();
    cancelRefused();
  }

  /** Returns whether changes are allowed. */
  public boolean isOpen() {
    return openedBy != null;
  }

  ObjectNode json() {
    String readOnlyBy = readOnly ? "--read-only" : robot.readOnlyBy();
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
