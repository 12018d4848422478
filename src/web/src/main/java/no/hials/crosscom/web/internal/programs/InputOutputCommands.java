package no.hials.crosscom.web.internal.programs;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.function.Function;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.Catalogue;
import no.hials.crosscom.cell.CatalogueEntry;
import no.hials.crosscom.cell.SignalWires;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.robot.Changes;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;

/**
 * Names inputs and outputs, and sets the inputs of simulated robots. Outputs are written like other
 * variables.
 */
public final class InputOutputCommands {
  private static final List<String> ARRAYS = List.of("$IN", "$OUT", "$ANIN", "$ANOUT");

  private final RobotSessions robots;
  private final Changes changes;
  private final Function<RobotSession, Catalogue> names;

  /**
   * Creates the commands.
   *
   * @param names returns the known variables of a robot
   */
  public InputOutputCommands(
      RobotSessions robots, AuditLog audit, Function<RobotSession, Catalogue> names) {
    this.robots = robots;
    this.changes = new Changes(audit);
    this.names = names;
  }

  /** Adds the commands. */
  public void addTo(Commands commands) {
    commands.add("signals", Role.VIEW, this::show);
    commands.add("set-input", Role.OPERATE, (call, answer) -> setInput(call));
  }

  private void show(Call call, ObjectNode answer) throws CommandException {
    RobotSession robot = robots.of(call);
    Catalogue catalogue = names.apply(robot);
    answer.put("simulated", robot.simulation().isPresent());
    ObjectNode lengths = answer.putObject("lengths");
    for (String array : ARRAYS) {
      lengths.put(array, length(catalogue, array));
    }
    ArrayNode signals = answer.putArray("signals");
    for (SignalWires wires : catalogue.signals()) {
      ObjectNode signal = signals.addObject();
      signal.put("array", wires.array()).put("first", wires.first()).put("last", wires.last());
      wires.names().forEach(signal.putArray("names")::add);
    }
  }

  private static int length(Catalogue catalogue, String array) {
    return catalogue.find(array).map(CatalogueEntry::dimensions).stream()
        .flatMap(List::stream)
        .findFirst()
        .orElse(0);
  }

  /**
   * Sets a digital or analog input of a simulated robot; a real controller reads them from a bus.
   */
  private void setInput(Call call) throws IOException {
    RobotSession robot = robots.of(call);
    boolean analog = call.optionalFlag("analog");
    String array = analog ? "$ANIN" : "$IN";
    int number = (int) call.number("number", 1, length(names.apply(robot), array));
    String name = array + "[" + number + "]";
    String value =
        analog
            ? Double.toString(call.number("value", -1, 1))
            : call.flag("value") ? "TRUE" : "FALSE";
    changes.replace(
        call,
        robot,
        "set input",
        name,
        value,
        oldValue -> {
          MockServer server =
              robot
                  .simulation()
                  .orElseThrow(
                      () ->
                          new CommandException(
                              name
                                  + " is read-only: the controller takes it from its bus. Only"
                                  + " inputs of a robot that this page simulates can be set."));
          robot.lock().check(call, "set " + name);
          oldValue.accept(server.variables().get(name));
          server.variables().set(name, value);
        });
  }
}
