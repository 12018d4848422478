package no.hials.crosscom.web.internal.teach;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.WriteAnswer;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlPrograms;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.robot.Changes;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Sockets;
import org.jspecify.annotations.Nullable;

/**
 * Changes a simulated robot like a person at its cabinet, and its server like a bad network. Shows
 * the lessons of the tutorial.
 */
public final class TeachCommands {
  private static final int MAX_LATENCY_MILLIS = 5000;

  /** The programs that move the robot by {@code MYPOS} and by {@code MYAXIS}. */
  private static final List<String> PROGRAMS = List.of("actuator", "ext_move_axis");

  /** The increments of these programs, and the values with which they move nothing. */
  private static final Map<String, String> STILL =
      Map.of(
          "MYPOS", "{X 0.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}",
          "MYAXIS", "{A1 0.0,A2 0.0,A3 0.0,A4 0.0,A5 0.0,A6 0.0}");

  private final RobotSessions robots;
  private final Changes changes;
  private final Sockets sockets;
  private final Map<RobotSession, Bench> benches = new ConcurrentHashMap<>();

  public TeachCommands(RobotSessions robots, AuditLog audit, Sockets sockets) {
    this.robots = robots;
    this.sockets = sockets;
    this.changes = new Changes(audit);
  }

  /** A simulated robot and the changes of the teacher. */
  private static final class Bench {
    final Controller controller;
    final ServerFaults faults;
    volatile boolean emergencyStop;

    Bench(MockServer server) {
      controller = server.controller();
      faults = new ServerFaults(server);
    }

    void show(ObjectNode json) {
      ServerFaults.Settings settings = faults.settings();
      json.put("emergency_stop", emergencyStop);
      json.put("latency_ms", settings.latencyMillis());
      json.put("lost_percent", settings.lostPercent());
      json.put("silent", settings.silent());
    }
  }

  /** Makes a change. */
  @FunctionalInterface
  private interface Change {
    void apply(Bench bench) throws IOException;
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    // at once and in order: behind commands that wait for the robot, a fault would not end, and the
    // start of a program would release an emergency stop that was pressed after it
    commands.addQuick("teach", Role.VIEW, this::show);
    commands.addQuick("teach-mode", Role.OPERATE, this::setMode);
    commands.addQuick("teach-stop", Role.OPERATE, this::setEmergencyStop);
    commands.addQuick("teach-faults", Role.OPERATE, this::setFaults);
    commands.addQuick("teach-fault", Role.OPERATE, this::faultOnce);
    commands.addQuick("teach-program", Role.OPERATE, this::startProgram);
    commands.addOvertaking("teach-still", Role.OPERATE, (call, answer) -> holdStill(call));
    commands.add("lessons", Role.VIEW, (call, answer) -> Lessons.list(answer.putArray("lessons")));
    commands.add(
        "lesson",
        Role.VIEW,
        (call, answer) -> Lessons.show(call.text("name"), answer.putArray("nodes")));
  }

  private Bench bench(Call call) throws CommandException {
    RobotSession robot = robots.of(call);
    MockServer server =
        robot
            .simulation()
            .orElseThrow(
                () ->
                    new CommandException(
                        "this is only for robots that this page simulates (--mock)"));
    return benches.computeIfAbsent(robot, it -> new Bench(server));
  }

  private void show(Call call, ObjectNode answer) throws CommandException {
    answer.put("simulated", robots.of(call).simulation().isPresent());
    if (robots.of(call).simulation().isPresent()) {
      bench(call).show(answer);
    }
  }

  /** Makes an allowed change, sends it to all pages, and adds it to the audit log. */
  private void change(Call call, String name, String value, Change change) throws IOException {
    call.checkAge();
    Bench bench = bench(call);
    RobotSession robot = robots.of(call);
    changes.make(
        call,
        robot,
        "teach",
        name,
        value,
        () -> {
          robot.lock().check(call, "set " + name);
          change.apply(bench);
          synchronized (bench) { // the newest state is sent last
            ObjectNode event = Json.event("teach").put("robot", robot.name());
            event.put("simulated", true);
            bench.show(event);
            sockets.broadcast("teach/" + robot.name(), event);
          }
        });
  }

  private void setMode(Call call, ObjectNode answer) throws IOException {
    String text = call.text("mode");
    OperatingMode mode =
        List.of(OperatingMode.values()).stream()
            .filter(it -> it.name().equals(text))
            .findFirst()
            .orElseThrow(
                () ->
                    new CommandException("mode must be one of " + List.of(OperatingMode.values())));
    change(call, "the operating mode", text, bench -> bench.controller.setMode(mode));
  }

  private void setEmergencyStop(Call call, ObjectNode answer) throws IOException {
    boolean pressed = call.flag("pressed");
    change(
        call,
        "the emergency stop",
        pressed ? "pressed" : "released",
        bench -> {
          bench.controller.emergencyStop(pressed);
          bench.emergencyStop = pressed;
        });
  }

  private void setFaults(Call call, ObjectNode answer) throws IOException {
    Integer latency = optionalNumber(call, "latency_ms", MAX_LATENCY_MILLIS);
    Integer lost = optionalNumber(call, "lost_percent", 100);
    Boolean silent = call.message().has("silent") ? call.flag("silent") : null;
    String text =
        Stream.of("latency_ms", "lost_percent", "silent")
            .filter(call.message()::has)
            .map(field -> field + " " + call.message().get(field).asText())
            .collect(Collectors.joining(", "));
    change(
        call,
        "faults",
        text,
        bench ->
            bench.faults.set(
                old ->
                    new ServerFaults.Settings(
                        latency == null ? old.latencyMillis() : latency,
                        lost == null ? old.lostPercent() : lost,
                        silent == null ? old.silent() : silent)));
  }

  /** Returns a number from 0; null if the message does not have it. */
  private static @Nullable Integer optionalNumber(Call call, String field, int max)
      throws CommandException {
    return call.message().has(field) ? Integer.valueOf((int) call.number(field, 0, max)) : null;
  }

  private void faultOnce(Call call, ObjectNode answer) throws IOException {
    String kind = call.text("kind");
    switch (kind) {
      case "lose" -> change(call, "a fault", kind, bench -> bench.faults.loseNextAnswer());
      case "cut" -> change(call, "a fault", kind, bench -> bench.faults.cutConnections());
      default -> throw new CommandException("kind must be lose or cut");
    }
  }

  /** Sets the increments of a program to 0, which needs no unlocked robot, like a stop. */
  private void holdStill(Call call) throws IOException {
    String name = call.text("name");
    String value = STILL.get(name);
    if (value == null) {
      throw new CommandException("name must be one of " + new TreeSet<>(STILL.keySet()));
    }
    RobotSession robot = robots.of(call);
    Bench unused = bench(call); // only a simulated robot has these programs
    changes.make(
        call,
        robot,
        "write",
        name,
        value,
        () -> {
          robot.lock().checkStop("set " + name + " to 0");
          WriteAnswer.check(name, value, robot.client().writeText(name, value));
        });
  }

  /** Ends all faults, moves the robot to its start, and starts a program there in mode AUT. */
  private void startProgram(Call call, ObjectNode answer) throws IOException {
    String program = call.text("program").toLowerCase(Locale.ROOT);
    if (!PROGRAMS.contains(program)) {
      throw new CommandException("program must be one of " + PROGRAMS);
    }
    change(
        call,
        "the program",
        program,
        bench -> {
          Controller controller = bench.controller;
          bench.faults.set(old -> ServerFaults.Settings.NONE);
          controller.emergencyStop(false);
          bench.emergencyStop = false;
          controller.robot().cancel();
          controller.submit().cancel();
          controller.confirmAll();
          KrlPrograms.start(controller, KrlPrograms.START, program);
        });
  }
}
