package no.hials.crosscom.web.internal.recordings;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.http.Route;
import no.hials.crosscom.web.internal.robot.Hub;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Sockets;

/** Starts, stops, lists and deletes recordings, and returns the units for charts. */
public final class RecordingCommands implements AutoCloseable {
  private static final int MAX_RUNNING = 4;
  private static final int MAX_NAMES = 100;
  private static final int MAX_UNITS = 1000;
  private static final int MIN_PERIOD = 10;
  private static final int MAX_PERIOD = 60_000;
  private static final DateTimeFormatter NOW =
      DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);

  private final RobotSessions robots;
  private final AuditLog audit;
  private final Sockets sockets;
  private final RecordingFiles files;
  private final Units units = new Units();

  /** The recordings that are being written, by their files; guarded by this. */
  private final Map<String, RecordingInProgress> running = new LinkedHashMap<>();

  /** The files of recordings whose robot has not answered yet; guarded by this. */
  private final Set<Path> starting = new HashSet<>();

  public RecordingCommands(Path folder, RobotSessions robots, AuditLog audit, Sockets sockets) {
    this.robots = robots;
    this.audit = audit;
    this.sockets = sockets;
    files = new RecordingFiles(folder);
  }

  /** Returns the route for downloads. */
  public Route files() {
    return files;
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.add("recordings", Role.VIEW, (call, answer) -> list(answer));
    commands.add("record-start", Role.OPERATE, this::start);
    commands.addOvertaking("record-stop", Role.OPERATE, this::stop);
    commands.add("recording-delete", Role.OPERATE, this::delete);
    commands.addQuick("units", Role.VIEW, this::units);
  }

  private void list(ObjectNode answer) throws IOException {
    ArrayNode list = answer.putArray("recordings");
    for (RecordingFiles.RecordingEntry file : files.list()) {
      list.addObject()
          .put("file", file.name())
          .put("bytes", file.bytes())
          .put("modified", file.modified().toEpochMilli());
    }
    ArrayNode now = answer.putArray("running");
    running().forEach(recording -> now.add(recording.json()));
  }

  private synchronized List<RecordingInProgress> running() {
    return List.copyOf(running.values());
  }

  private void start(Call call, ObjectNode answer) throws IOException {
    RobotSession robot = robots.of(call);
    List<String> names = call.texts("names", MAX_NAMES).stream().map(Hub::key).distinct().toList();
    if (names.isEmpty() || names.contains("")) {
      throw new CommandException("names must have at least one name, and none that is blank");
    }
    Duration period = Duration.ofMillis(call.millis("period", MIN_PERIOD, MAX_PERIOD));
    String format = call.text("format");
    if (!format.equals("csv") && !format.equals("jsonl")) {
      throw new CommandException("format must be csv or jsonl");
    }
    boolean jsonLines = format.equals("jsonl");
    Optional<String> name = call.optionalText("name");
    Path file;
    synchronized (this) {
      if (running.size() + starting.size() >= MAX_RUNNING) {
        throw new CommandException(
            "there are " + MAX_RUNNING + " recordings already: stop one first");
      }
      file =
          name.isPresent()
              ? files.newFile(name.get(), jsonLines)
              : files.freeFile(defaultName(robot), jsonLines, starting);
      if (!starting.add(file)) {
        throw new CommandException("there is already a recording " + file.getFileName());
      }
    }
    RecordingInProgress started;
    try {
      Sampling.SamplingPlan plan = new Sampling.SamplingPlan(names, period, null, Long.MAX_VALUE);
      // waits for the robot, while other recordings can be stopped
      started = RecordingInProgress.start(robot, plan, file, jsonLines, this::changed);
      synchronized (this) {
        running.put(started.file(), started);
      }
    } finally {
      synchronized (this) {
        starting.remove(file);
      }
    }
    if (started.isEnded()) {
      changed(started); // it may have changed before it was in the map
    }
    log(call, robot.name(), "record", started.file());
    answer.put("file", started.file());
    tellAll();
  }

  private static String defaultName(RobotSession robot) {
    String name = robot.name().replaceAll("[^A-Za-z0-9_-]", "-").replaceAll("^[_-]+", "");
    String start = name.substring(0, Math.min(name.length(), 40));
    return (start.isEmpty() ? "robot" : start)
        + "-"
        + NOW.format(LocalDateTime.now(ZoneId.systemDefault()));
  }

  private void log(Call call, String robot, String what, String file) {
    audit.add(new AuditLog.Entry(call.viewer().name(), robot, what, file, "", "", "done"));
  }

  private void stop(Call call, ObjectNode answer) throws IOException {
    String file = call.text("file");
    RecordingInProgress recording;
    synchronized (this) {
      recording = running.get(file);
    }
    if (recording == null) {
      throw new CommandException("there is no such recording that runs");
    }
    recording.stop();
    if (recording.isEnded()) {
      forget(recording); // now, since the next command may start another one
    }
    ObjectNode state = recording.json();
    log(call, state.path("robot").asText(), "record stop", file);
    answer.setAll(state);
  }

  private void delete(Call call, ObjectNode answer) throws IOException {
    String name = call.text("file");
    synchronized (this) {
      if (running.containsKey(name)) {
        throw new CommandException("stop " + name + " first");
      }
      Files.delete(files.file(name));
    }
    log(call, "", "delete recording", name);
    tellAll();
  }

  private void units(Call call, ObjectNode answer) throws IOException {
    ObjectNode all = answer.putObject("units");
    for (String name : call.texts("names", MAX_UNITS)) {
      all.put(name, units.of(name));
    }
  }

  /** Sends pages the state of a recording, and forgets the recording after its end. */
  private void changed(RecordingInProgress recording) {
    boolean ended = recording.isEnded();
    if (ended) {
      forget(recording);
    }
    ObjectNode event = Json.event("recording");
    event.setAll(recording.json());
    sockets.broadcast("recording/" + recording.file(), event);
    if (ended) {
      tellAll();
    }
  }

  private synchronized void forget(RecordingInProgress recording) {
    running.remove(recording.file(), recording);
  }

  private void tellAll() {
    sockets.broadcast("recordings", Json.event("recordings"));
  }

  /** Ends all recordings; their files stay. */
  @Override
  public void close() {
    running().forEach(RecordingInProgress::stop);
  }
}
