package no.hials.crosscom.web.internal.variables;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComValueException;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cell.ValueText;
import no.hials.crosscom.cell.WriteAnswer;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.robot.Changes;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Sockets;

/** Searches the catalogue, and reads and writes single variables. */
public final class VariableCommands {
  private static final int MAX_FOUND = 500;

  private final RobotSessions robots;
  private final Changes changes;
  private final Sockets sockets;
  private final Map<RobotSession, KnownNames> names = new ConcurrentHashMap<>();

  public VariableCommands(RobotSessions robots, AuditLog audit, Sockets sockets) {
    this.robots = robots;
    this.changes = new Changes(audit);
    this.sockets = sockets;
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.add("search", Role.VIEW, this::search);
    commands.add("describe", Role.VIEW, this::describe);
    commands.add("read", Role.VIEW, this::read);
    commands.add("check", Role.OPERATE, this::check);
    commands.add("write", Role.OPERATE, this::write);
  }

  /** Prepares the search in the background, for some 100 ms. */
  public void preload() {
    robots.all().forEach(robot -> names(robot).load());
  }

  /** Returns the variables of a robot that are known now. */
  public Catalogue catalogue(RobotSession robot) {
    return names(robot).now().catalogue();
  }

  private KnownNames names(RobotSession robot) {
    return names.computeIfAbsent(
        robot,
        it ->
            new KnownNames(
                it,
                () ->
                    sockets.broadcast(
                        "names/" + it.name(), Json.event("names").put("robot", it.name()))));
  }

  private void search(Call call, ObjectNode answer) throws IOException {
    // the page shows an array as NAME[]
    String text = call.text("text", 200).toLowerCase(Locale.ROOT).replace("[]", "");
    List<String> words = List.of(text.split("\\s+"));
    int limit = (int) call.number("limit", 1, MAX_FOUND);
    KnownNames.Names known = names(robots.of(call)).now();
    Catalogue catalogue = known.catalogue();
    List<CatalogueEntry> found =
        known.searched().stream()
            .filter(it -> words.stream().allMatch(it.text()::contains))
            .map(KnownNames.SearchedVariable::entry)
            .toList();
    answer.put("total", found.size());
    answer.put("loading", known.loading());
    ArrayNode list = answer.putArray("found");
    found.stream()
        .limit(limit)
        .forEach(
            entry ->
                write(entry, list.addObject())
                    .put("structure", !catalogue.fields(entry).isEmpty()));
  }

  private static ObjectNode write(CatalogueEntry entry, ObjectNode json) {
    json.put("name", entry.name());
    json.put("type", entry.type());
    entry.dimensions().forEach(json.putArray("dimensions")::add);
    json.put("unit", entry.unit());
    json.put("access", entry.shortAccess());
    json.put("meaning", entry.meaning());
    return json.put("origin", entry.origin());
  }

  /** Answers with the entry of a variable, the fields of its type, and the constants. */
  private void describe(Call call, ObjectNode answer) throws IOException {
    Catalogue catalogue = names(robots.of(call)).now().catalogue();
    catalogue
        .find(call.text("name"))
        .ifPresent(
            entry -> {
              write(entry, answer.putObject("entry"));
              answer.put("range", range(entry));
              ArrayNode fields = answer.putArray("fields");
              catalogue.fields(entry).forEach(field -> write(field, fields.addObject()));
              ArrayNode constants = answer.putArray("constants");
              Stream<String> names =
                  entry.type().equals("BOOL")
                      ? Stream.of("TRUE", "FALSE")
                      : catalogue.constants(entry).stream().map(name -> "#" + name);
              names.forEach(constants::add);
            });
  }

  /** Returns the range of a type, for people; empty if its constants show it. */
  private static String range(CatalogueEntry entry) {
    if (entry.isText()) {
      return "text of at most " + entry.dimensions().get(0) + " characters";
    }
    return switch (entry.type()) {
      case "INT" -> Integer.MIN_VALUE + " to " + Integer.MAX_VALUE;
      case "REAL" -> "-3.4E+38 to 3.4E+38, about 7 digits";
      case "CHAR" -> "one character";
      default -> "";
    };
  }

  private void read(Call call, ObjectNode answer) throws IOException {
    answer.put("text", robots.of(call).client().readText(call.text("name")));
  }

  /** Checks whether a text can be a value of a variable. Sends no write. */
  private void check(Call call, ObjectNode answer) throws IOException {
    checkValue(robots.of(call), call.text("name"), call.text("value").strip());
  }

  private void checkValue(RobotSession robot, String name, String value) throws IOException {
    KrlValue parsed;
    try {
      parsed = ValueText.parse(name, value, "");
    } catch (IllegalArgumentException e) {
      throw new CommandException("the value for " + name + " " + e.getMessage());
    }
    String type =
        catalogue(robot)
            .find(name)
            .filter(it -> it.dimensions().isEmpty())
            .map(CatalogueEntry::type)
            .orElse("");
    if (!isOfType(parsed, type)) {
      throw new CommandException("the value for " + name + " must be " + type + ", is " + value);
    }
    robot.client().checkText(name, value);
  }

  /** Returns whether a value may be of a scalar type; true if the type is another one. */
  private static boolean isOfType(KrlValue value, String type) {
    return switch (type) {
      case "INT" -> value instanceof KrlInt;
      case "REAL" -> value instanceof KrlInt || value instanceof KrlReal;
      case "BOOL" -> value instanceof KrlBool;
      default -> true;
    };
  }

  /** Returns the value for the audit log; empty if the controller refuses to read it. */
  private static String valueBefore(RobotSession robot, String name) throws IOException {
    try {
      return robot.client().readText(name);
    } catch (CrossComAccessException e) {
      return "";
    }
  }

  /** Writes a variable, and answers with its value as read afterwards. */
  private void write(Call call, ObjectNode answer) throws IOException {
    RobotSession robot = robots.of(call);
    String name = call.text("name");
    String value = call.text("value").strip();
    changes.replace(
        call,
        robot,
        "write",
        name,
        value,
        oldValue -> {
          try {
            checkValue(robot, name, value);
            robot.lock().check(call, "write " + name);
            oldValue.accept(valueBefore(robot, name));
            WriteAnswer.check(
                name,
                value,
                robot
                    .lock()
                    .send(
                        call,
                        "write " + name,
                        sendIf ->
                            robot.client().async(client -> client.writeText(name, value), sendIf)));
          } catch (CrossComException e) {
            if (e.isOutcomeUnknown() || e instanceof CrossComValueException) {
              throw e; // its message describes the outcome
            }
            throw new CommandException(e.getMessage() + "; nothing was written");
          }
        });
    try {
      answer.put("text", robot.client().readText(name));
    } catch (IOException e) {
      throw new CommandException(
          name + " was written, but could not be read afterwards: " + e.getMessage());
    }
  }
}
