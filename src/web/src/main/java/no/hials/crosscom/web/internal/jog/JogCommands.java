package no.hials.crosscom.web.internal.jog;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.DaemonThreadFactory;
import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.WebConfig;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Sockets;
import no.hials.crosscom.web.internal.socket.Viewer;

/**
 * The commands of the jog view. Presses, beats and releases run on the thread of the socket and
 * touch no robot.
 */
public final class JogCommands implements AutoCloseable {
  private static final double MAX_STEP = 10;
  private static final double MAX_NUMBER = 1L << 53;

  /** The time in which a robot stops after a hold; then its position is logged. */
  private static final long BRAKING_MILLIS = 500;

  /** The longest wait for the last lines, if a robot does not answer. */
  private static final long LAST_LINES_MILLIS = 5000;

  private final Map<String, RobotJog> jogs = new LinkedHashMap<>();
  private final RobotSessions robots;
  private final AuditLog audit;
  private final Sockets sockets;

  /** Writes the lines of the audit log, which neither a loop nor a socket waits for. */
  private final ScheduledThreadPoolExecutor writer =
      new ScheduledThreadPoolExecutor(1, DaemonThreadFactory.named("web-jog-audit"));

  public JogCommands(RobotSessions robots, AuditLog audit, Sockets sockets, WebConfig config) {
    this.robots = robots;
    this.audit = audit;
    this.sockets = sockets;
    for (RobotSession robot : robots.all()) {
      jogs.put(
          robot.name(), new RobotJog(robot, config, this::write, () -> broadcast(robot.name())));
    }
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.add("jog-open", Role.JOG, this::open);
    commands.addQuick("jog-press", Role.JOG, this::press);
    commands.addQuick("jog-beat", Role.JOG, this::beat);
    commands.addQuick(
        "jog-release",
        Role.JOG,
        (call, answer) -> of(call).of(person(call)).release(whole(call, "hold")));
    commands.addQuick("jog-here", Role.JOG, this::here);
    commands.addQuick("jog-ask", Role.JOG, this::ask);
    commands.addQuick("jog-answer", Role.JOG, this::answer);
    commands.addQuick("jog-close", Role.JOG, (call, answer) -> leave(of(call), call.viewer()));
  }

  /** Shows the owners to a viewer, and frees its robots when its socket is closed. */
  public void show(Viewer viewer) {
    for (RobotJog jog : jogs.values()) {
      viewer.send(key(jog.robot().name()), jog.event());
      viewer.atClose(() -> leave(jog, viewer));
    }
  }

  private void broadcast(String robot) {
    RobotJog jog = jogs.get(robot);
    if (jog != null) {
      sockets.broadcast(key(robot), jog.event());
    }
  }

  private static String key(String robot) {
    return "jog/" + robot;
  }

  private RobotJog of(Call call) throws CommandException {
    RobotJog jog = jogs.get(robots.of(call).name());
    if (jog == null) {
      throw new CommandException("the page has no such robot");
    }
    return jog;
  }

  private static JogOwner.Person person(Call call) {
    return person(call.viewer());
  }

  private static JogOwner.Person person(Viewer viewer) {
    return new JogOwner.Person(viewer.id(), viewer.name());
  }

  private void open(Call call, ObjectNode answer) throws IOException {
    RobotJog jog = of(call);
    DriveSpace space =
        switch (call.text("space")) {
          case "base" -> DriveSpace.BASE;
          case "tool" -> DriveSpace.TOOL;
          case "joints" -> DriveSpace.JOINTS;
          default -> throw new CommandException("space must be base, tool or joints");
        };
    String result = "done";
    try {
      jog.open(call, person(call), space);
    } catch (IOException e) {
      result = String.valueOf(e.getMessage());
      throw e;
    } finally {
      audit.add(
          new AuditLog.Entry(
              call.viewer().name(),
              jog.robot().name(),
              "jog-open",
              space.name().toLowerCase(Locale.ROOT),
              "",
              "",
              result));
    }
  }

  private void press(Call call, ObjectNode answer) throws CommandException {
    JogSession session = of(call).of(person(call));
    Press press =
        new Press(
            whole(call, "hold"),
            (int) whole(call, "direction", HoldToRun.DIRECTIONS - 1),
            call.flag("positive"),
            call.number("percent", 1, 100) / 100,
            call.number("step", 0, MAX_STEP));
    answer.put("mark", session.press(press));
  }

  private void beat(Call call, ObjectNode answer) throws CommandException {
    JogSession session = of(call).of(person(call));
    answer.put("mark", session.beat(whole(call, "hold"), whole(call, "beat"), whole(call, "mark")));
    answer.put("moving", session.isMoving());
    answer.put("late", session.isLate());
  }

  private static long whole(Call call, String field) throws CommandException {
    return whole(call, field, MAX_NUMBER);
  }

  private static long whole(Call call, String field, double max) throws CommandException {
    double number = call.number(field, 0, max);
    if (number != Math.rint(number)) {
      throw new CommandException(field + " must be a whole number, is " + number);
    }
    return (long) number;
  }

  private void here(Call call, ObjectNode answer) throws CommandException {
    answer.put("owner", of(call).see(person(call)));
  }

  private void ask(Call call, ObjectNode answer) throws CommandException {
    RobotJog jog = of(call);
    jog.ask(person(call));
    broadcast(jog.robot().name());
  }

  private void answer(Call call, ObjectNode answer) throws CommandException {
    RobotJog jog = of(call);
    jog.answer(person(call), whole(call, "to"), call.flag("yes"));
    broadcast(jog.robot().name());
  }

  private void leave(RobotJog jog, Viewer viewer) {
    if (jog.leave(person(viewer))) {
      broadcast(jog.robot().name());
    }
  }

  /** Writes a line to the audit log when the robot has stopped. */
  private void write(JogSession session, String name, String before, String reason) {
    Future<?> unused =
        writer.schedule(
            () ->
                audit.add(
                    new AuditLog.Entry(
                        session.person().name(),
                        session.robot().name(),
                        "jog",
                        name,
                        before,
                        session.positionAfter(),
                        reason)),
            BRAKING_MILLIS,
            TimeUnit.MILLISECONDS);
  }

  @Override
  public void close() {
    jogs.values().forEach(RobotJog::close);
    writer.shutdown();
    try {
      boolean unused = writer.awaitTermination(LAST_LINES_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
