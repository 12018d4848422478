package no.hials.crosscom.web.internal.robot;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.protocol.value.KrlValue;
import no.hials.crosscom.web.internal.robot.Readings.ReadOutcome;
import no.hials.crosscom.web.internal.socket.Json;
import no.hials.crosscom.web.internal.socket.Viewer;
import org.jspecify.annotations.Nullable;

/**
 * The state of a robot that is always visible: connection, mode, programs, override, stop and lock.
 * It is read while a viewer shows it. Thread-safe.
 */
final class Header {
  private static final Duration PERIOD = Duration.ofMillis(250);

  /** The fields of the event, by the names of the variables. */
  private static final Map<String, String> FIELDS =
      Map.of(
          "$MODE_OP", "mode",
          "$PRO_STATE1", "robot_state",
          "$PRO_NAME1[]", "robot_program",
          "$PRO_STATE0", "submit_state",
          "$PRO_NAME0[]", "submit_program",
          "$OV_PRO", "override",
          "$STOPMESS", "stop");

  private final RobotSession robot;
  private final AuditLog audit;

  // guarded by this
  private final Set<Viewer> viewers = new HashSet<>();
  private final Set<Viewer> hidden = new HashSet<>();
  private Hub.@Nullable Subscription subscription;
  private @Nullable Readings last;

  /**
   * The last result of each variable. A reading may have only some of them, since a variable that a
   * viewer needs more often is read at another period.
   */
  private final Map<String, ReadOutcome> values = new HashMap<>();

  private String connection = "connecting";

  /** A page that misses a short loss sees by it that the controller may be another one. */
  private long connections;

  private String reason = "";

  Header(RobotSession robot, AuditLog audit) {
    this.robot = robot;
    this.audit = audit;
  }

  /** Sends the header to a viewer from now on, until its socket is closed. */
  void show(Viewer viewer) {
    synchronized (this) {
      viewers.add(viewer);
      update();
    }
    viewer.send(key(), event());
    viewer.atClose(
        () -> {
          synchronized (this) {
            viewers.remove(viewer);
            hidden.remove(viewer);
            update();
          }
        });
  }

  /** Pauses the readings for a viewer whose page is hidden. */
  synchronized void pause(Viewer viewer, boolean paused) {
    if (paused) {
      hidden.add(viewer);
    } else {
      hidden.remove(viewer);
    }
    update();
  }

  private void update() {
    boolean needed = !hidden.containsAll(viewers);
    if (needed && subscription == null) {
      subscription = robot.hub().subscribe(List.copyOf(FIELDS.keySet()), PERIOD, this::read);
    } else if (!needed && subscription != null) {
      subscription.close();
      subscription = null;
    }
  }

  private void read(Readings readings) {
    if (!readings.isMissed()) {
      robot.findServer();
    }
    synchronized (this) {
      if (readings.isMissed()) {
        // later events only count down to the next attempt
        setLost(reason.isEmpty() ? readings.values().values().iterator().next().error() : reason);
      } else {
        last = readings;
        values.putAll(readings.values());
        connection = "connected";
        reason = "";
      }
    }
    send();
  }

  void connectionChanged(ConnectionEvent event) {
    synchronized (this) {
      if (event.kind() != ConnectionChange.CONNECTED
          && event.kind() != ConnectionChange.RECONNECTED) {
        setLost(event.cause() == null ? "" : String.valueOf(event.cause().getMessage()));
      } else {
        connections++;
      }
    }
    send();
  }

  private void setLost(String why) {
    connection = last == null ? "connecting" : "lost";
    reason = why;
  }

  /** Sends the state to all viewers. */
  void send() {
    List<Viewer> all;
    String text;
    synchronized (this) {
      all = List.copyOf(viewers);
      text = event().toString();
    }
    all.forEach(viewer -> viewer.sendText(key(), text));
  }

  private String key() {
    return "header/" + robot.name();
  }

  private synchronized ObjectNode event() {
    ObjectNode event = Json.event("header");
    event.put("robot", robot.name());
    event.put("now", Readings.millis(Instant.now()));
    event.put("server", robot.server());
    event.put("simulated", robot.simulation().isPresent());
    event.put("connection", connection);
    event.put("reason", reason);
    event.put("connections", connections);
    event.put("period_ms", PERIOD.toMillis());
    Readings readings = last;
    if (readings != null) {
      event.put("time", Readings.millis(readings.time()));
      event.put("access_ms", Readings.millis(readings.access()));
      values.forEach((name, reading) -> put(event, FIELDS.get(name), reading));
    }
    event.put("audit_failure", audit.failure());
    event.set("lock", robot.lock().json());
    return event;
  }

  private static void put(ObjectNode event, @Nullable String field, ReadOutcome reading) {
    KrlValue value = reading.value();
    // a value that the controller does not know is null, which the page shows as unknown
    event.put(
        field, value == null ? null : new Leaf(field == null ? "" : field, value).text().strip());
  }
}
