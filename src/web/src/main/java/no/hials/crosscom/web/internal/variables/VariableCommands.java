package no.hials.crosscom.web.internal.variables;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cell.ValueText;
import no.hials.crosscom.cell.WriteAnswer;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.audit.AuditLog;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.Commands;

/** Searches the catalogue, and reads and writes single variables. */
public final class VariableCommands {
  private static final int MOST_FOUND = 500;

  private final RobotSessions robots;
  private final AuditLog audit;
  private final Map<RobotSession, Catalogue> catalogues = new ConcurrentHashMap<>();

  public VariableCommands(RobotSessions robots, AuditLog audit) {
    this.robots = robots;
    this.audit = audit;
  }

  /** Prepares the search, which takes some 100 ms, in the background. */
  public void preload() {
    Thread thread = new Thread(() -> robots.all().forEach(this::catalogue), "web-catalogue");
    thread.setDaemon(true);
    thread.start();
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.add("search", Role.VIEW, this::search);
    commands.add("describe", Role.VIEW, this::describe);
    commands.add("read", Role.VIEW, this::read);
    commands.add("write", Role.OPERATE, this::write);
  }

  /** Returns the variables of a robot that are known without asking its controller. */
  private Catalogue catalogue(RobotSession robot) {
    return catalogues.computeIfAbsent(
        robot,
        it ->
            it.simulation()
                .map(server -> Catalogue.of(server.variables().toDataList("$VARIABLES")))
                .orElseGet(Catalogue::system));
  }

  private void search(Call call, ObjectNode answer) throws IOException {
    List<String> words = List.of(call.text("text", 200).toLowerCase(Locale.ROOT).split("\\s+"));
    int limit = (int) call.number("limit", 1, MOST_FOUND);
    List<CatalogueEntry> found =
        catalogue(robots.of(call)).variables().stream()
            .filter(entry -> matches(entry, words))
            .toList();
    ArrayNode list = answer.put("total", found.size()).putArray("found");
    found.stream().limit(limit).forEach(entry -> write(entry, list.addObject()));
  }

  private static boolean matches(CatalogueEntry entry, List<String> words) {
    String all =
        String.join("\n", entry.declarator(), entry.type(), entry.unit(), entry.meaning())
            .toLowerCase(Locale.ROOT);
    return words.stream().allMatch(all::contains);
  }

  private static void write(CatalogueEntry entry, ObjectNode json) {
    json.put("name", entry.name());
    json.put("type", entry.type());
    entry.dimensions().forEach(json.putArray("dimensions")::add);
    json.put("unit", entry.unit());
    json.put("access", entry.shortAccess());
    json.put("meaning", entry.meaning());
    json.put("origin", entry.origin());
  }

  /** Answers with the entry of a variable, the fields of its type, and the constants. */
  private void describe(Call call, ObjectNode answer) throws IOException {
    Catalogue catalogue = catalogue(robots.of(call));
    catalogue
        .find(call.text("name"))
        .ifPresent(
            entry -> {
              write(entry, answer.putObject("entry"));
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

  private void read(Call call, ObjectNode answer) throws IOException {
    answer.put("text", robots.of(call).client().readText(call.text("name")));
  }

  /** Writes a variable, and answers with its value as read afterwards. */
  private void write(Call call, ObjectNode answer) throws IOException {
    RobotSession robot = robots.of(call);
    String name = call.text("name");
    String value = call.text("value").strip();
    String before = call.optionalText("before").orElse("");
    String result = "done";
    try {
      ValueText.parse(name, value, "");
      robot.client().checkText(name, value);
      robot.lock().check(call, "write " + name);
      WriteAnswer.check(name, value, robot.client().writeText(name, value));
    } catch (IOException | IllegalArgumentException e) {
      result = String.valueOf(e.getMessage());
      throw e;
    } finally {
      audit.add(
          new AuditLog.Entry(
              call.viewer().name(), robot.name(), "write", name, before, value, result));
    }
    answer.put("text", robot.client().readText(name));
  }
}
