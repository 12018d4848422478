package no.hials.crosscom.web.internal.jog;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.web.WebConfig;
import no.hials.crosscom.web.internal.robot.Lock;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Json;
import org.jspecify.annotations.Nullable;

/**
 * Jogging of one robot: its owner, and the loop while there is one. Thread-safe; only {@link #open}
 * and {@link #close} wait for the robot.
 */
final class RobotJog {
  private final RobotSession robot;
  private final WebConfig config;
  private final JogSession.Jogs jogs;
  private final Runnable changed;

  // guarded by this
  private final JogOwner owner = new JogOwner(System::nanoTime);
  private @Nullable JogSession session;
  private boolean opening;
  private boolean closed;
  private String lastEnd = "";

  /**
   * Creates the jogging of a robot, which nobody owns yet.
   *
   * @param jogs called with each hold that is over
   * @param changed called after the owner or the loop has changed
   */
  RobotJog(RobotSession robot, WebConfig config, JogSession.Jogs jogs, Runnable changed) {
    this.robot = robot;
    this.config = config;
    this.jogs = jogs;
    this.changed = changed;
  }

  RobotSession robot() {
    return robot;
  }

  /** Starts a loop for a page that has the robot, or that takes it because nobody has it. */
  void open(Call call, JogOwner.Person person, DriveSpace space) throws IOException {
    robot.lock().check(call, "jog the robot");
    JogSession old;
    synchronized (this) {
      owner.take(person);
      if (closed) {
        throw new CommandException("the page's server ends");
      }
      if (opening) {
        throw new CommandException("jogging is already starting");
      }
      opening = true;
      lastEnd = "";
      old = session;
      session = null;
    }
    changed.run();
    try {
      if (old != null) {
        old.close("jogging started again");
      }
      start(call, person, space);
    } catch (IOException e) {
      synchronized (this) {
        lastEnd = String.valueOf(e.getMessage());
      }
      throw e;
    } finally {
      synchronized (this) {
        opening = false;
      }
      changed.run();
    }
  }

  private void start(Call call, JogOwner.Person person, DriveSpace space) throws IOException {
    Lock lock = robot.lock();
    JogSession started =
        JogSession.open(
            person,
            robot,
            space,
            config,
            jogs,
            () -> lock.isOpen() ? lock.refusal(call) : "the robot was locked");
    boolean kept;
    synchronized (this) {
      kept = owner.isOwner(person) && !closed;
      if (kept) {
        session = started;
      }
    }
    if (!kept) {
      started.close("the page has given up the robot");
      throw new CommandException("the robot was given up meanwhile");
    }
    CompletableFuture<Void> unused = started.ended().thenAccept(reason -> ended(started, reason));
  }

  private void ended(JogSession one, String reason) {
    synchronized (this) {
      if (session != one) {
        return;
      }
      session = null;
      lastEnd = reason;
    }
    changed.run();
  }

  /** Returns the loop of a page; the call shows that the page is there. */
  synchronized JogSession of(JogOwner.Person person) throws CommandException {
    if (!see(person)) {
      throw new CommandException("this page does not jog the robot");
    }
    if (session == null) {
      throw new CommandException(lastEnd.isEmpty() ? "jogging has not started" : lastEnd);
    }
    return session;
  }

  /** Called when a page shows that it is there; returns whether it has the robot. */
  synchronized boolean see(JogOwner.Person person) {
    boolean is = owner.see(person);
    if (is && session != null) {
      session.see();
    }
    return is;
  }

  /** Asks for the robot. */
  synchronized void ask(JogOwner.Person person) throws CommandException {
    owner.ask(person);
    stopOthers();
  }

  /** Answers for the robot; its motion ends before another page gets it. */
  synchronized void answer(JogOwner.Person person, long to, boolean yes) throws CommandException {
    owner.answer(person, to, yes);
    stopOthers();
  }

  /** Frees the robot; returns whether anything has changed. */
  synchronized boolean leave(JogOwner.Person person) {
    boolean left = owner.leave(person);
    stopOthers();
    return left;
  }

  private void stopOthers() {
    if (session != null && !owner.isOwner(session.person())) {
      session.stop(session.person().name() + " has given up the robot");
    }
  }

  /** Ends the loop and waits until the stop was sent to the robot. */
  void close() {
    JogSession old;
    synchronized (this) {
      closed = true;
      old = session;
    }
    if (old != null) {
      old.close("the page's server ends");
    }
  }

  /** Returns the event for all pages. */
  synchronized ObjectNode event() {
    ObjectNode event = Json.event("jog").put("robot", robot.name());
    owner.show(event);
    JogSession open = session;
    event.put("open", open == null ? "" : open.space().name().toLowerCase(Locale.ROOT));
    event.put("opening", opening);
    event.put("reason", lastEnd);
    event.put("full_mm", JogSession.fullSpeed(DriveSpace.BASE));
    event.put("full_turn", JogSession.fullTurn());
    event.put("full_axis", JogSession.fullSpeed(DriveSpace.JOINTS));
    return event;
  }
}
