package no.hials.crosscom.web.internal.programs;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import no.hials.crosscom.web.Role;
import no.hials.crosscom.web.internal.robot.Hub;
import no.hials.crosscom.web.internal.robot.Readings;
import no.hials.crosscom.web.internal.robot.Readings.ReadOutcome;
import no.hials.crosscom.web.internal.robot.RobotSession;
import no.hials.crosscom.web.internal.robot.RobotSessions;
import no.hials.crosscom.web.internal.socket.Call;
import no.hials.crosscom.web.internal.socket.CommandException;
import no.hials.crosscom.web.internal.socket.Commands;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Viewer;
import org.jspecify.annotations.Nullable;

/** Sends the checks for why a robot does not move, to the viewers that show them. */
public final class CheckCommands {
  private static final Duration PERIOD = Duration.ofSeconds(1);

  private final RobotSessions robots;
  private final Map<Viewer, Look> looks = new ConcurrentHashMap<>();

  public CheckCommands(RobotSessions robots) {
    this.robots = robots;
  }

  /** Adds the command. */
  public void addTo(Commands commands) {
    commands.addQuick("checks", Role.VIEW, (call, answer) -> look(call));
  }

  private void look(Call call) throws CommandException {
    RobotSession robot = robots.of(call);
    Viewer viewer = call.viewer();
    Look look = looks.get(viewer); // the commands of one viewer run in order
    if (look == null) {
      Look added = new Look(viewer);
      looks.put(viewer, added);
      viewer.atClose(
          () -> {
            looks.remove(viewer);
            added.end();
          });
      look = added;
    }
    look.end();
    if (call.flag("on")) {
      look.begin(robot);
    }
  }

  /** The checks that one viewer sees. Thread-safe. */
  private static final class Look {
    private final Viewer viewer;

    // guarded by this
    private final Map<String, ReadOutcome> values = new HashMap<>();
    private Hub.@Nullable Subscription subscription;
    private int number;

    Look(Viewer viewer) {
      this.viewer = viewer;
    }

    synchronized void begin(RobotSession robot) {
      int own = ++number;
      subscription =
          robot.hub().subscribe(MoveChecks.VARIABLES, PERIOD, it -> read(robot, own, it));
    }

    synchronized void end() {
      if (subscription != null) {
        subscription.close();
        subscription = null;
        number++; // so that readings still under way do not count
        values.clear();
      }
    }

    private void read(RobotSession robot, int own, Readings readings) {
      synchronized (this) {
        if (own != number) {
          return;
        }
        // variables that others read more often arrive separately, and are never older than these
        values.putAll(readings.values());
        if (readings.values().containsKey(MoveChecks.LAST_READ)) {
          viewer.send("checks/" + robot.name(), event(robot, readings));
        }
      }
    }

    private ObjectNode event(RobotSession robot, Readings readings) {
      ObjectNode event = Json.event("checks").put("robot", robot.name());
      event.put("time", readings.time().toEpochMilli());
      event.put("moving", MoveChecks.isMoving(values));
      ArrayNode list = event.putArray("checks");
      List<MoveChecks.Check> checks = MoveChecks.of(values);
      for (MoveChecks.Check check : checks) {
        list.addObject()
            .put("name", check.name())
            .put("state", check.state().name().toLowerCase(Locale.ROOT))
            .put("read", check.read())
            .put("advice", check.advice());
      }
      return event;
    }
  }
}
