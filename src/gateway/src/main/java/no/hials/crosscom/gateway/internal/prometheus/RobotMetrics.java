package no.hials.crosscom.gateway.internal.prometheus;

import io.prometheus.metrics.model.snapshots.Labels;
import java.util.Comparator;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import no.hials.crosscom.ClientStatistics;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.cell.feed.PlannedVariable;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlValue;

/** The last updates of one robot, as metrics. */
final class RobotMetrics {
  private static final Units UNITS = new Units();

  private final RobotFeed robot;
  private final Map<String, Update> updates = new ConcurrentHashMap<>();

  RobotMetrics(RobotFeed robot) {
    this.robot = robot;
  }

  void put(Update update) {
    updates.put(update.variable().key(), update);
  }

  void addTo(MetricFamilies families) {
    Labels labels = Labels.of("robot", robot.name());
    families.gauge(
        "robot_connected", "Whether the robot is connected", labels, robot.isConnected() ? 1 : 0);
    families.gauge(
        "robot_load_ratio",
        "Expected share of the controller's time that the readings take",
        labels,
        robot.plan().load() / 100);
    families.counter("robot_readings", "Readings that were started", labels, robot.polls());
    families.counter(
        "robot_readings_failed", "Readings that failed as a whole", labels, robot.failedPolls());
    families.counter(
        "robot_readings_missed",
        "Readings left out because the robot was too slow",
        labels,
        robot.missedPolls());
    families.counter(
        "robot_samples_dropped",
        "Readings that were lost in the gateway",
        labels,
        robot.droppedSamples());
    ClientStatistics statistics = robot.client().statistics();
    families.histogram(
        "robot_access_seconds",
        "Times from a request to its answer",
        labels,
        statistics.accessTimes());
    families.counter(
        "robot_accesses_refused",
        "Requests that the controller has refused",
        labels,
        statistics.refusals());
    families.counter(
        "robot_accesses_timed_out",
        "Requests that were not answered in time",
        labels,
        statistics.timeouts());
    families.counter(
        "robot_accesses_lost",
        "Requests without a valid answer for another reason",
        labels,
        statistics.losses());
    families.counter(
        "robot_reconnects", "Connections after the first one", labels, statistics.reconnects());
    // a field that is read alone and with its structure is one series, with its newest value
    Set<String> shown = new HashSet<>();
    updates.values().stream()
        .sorted(Comparator.comparing(Update::time).reversed())
        .forEach(update -> add(update, shown, families));
  }

  private void add(Update update, Set<String> shown, MetricFamilies families) {
    PlannedVariable variable = update.variable();
    boolean good = update.quality() == Quality.GOOD;
    Labels labels = Labels.of("robot", robot.name(), "variable", variable.name());
    families.gauge(
        "variable_good", "Whether the last reading of a variable is current", labels, good ? 1 : 0);
    robot
        .age(variable.key())
        .ifPresent(
            age ->
                families.gauge(
                    "variable_age_seconds",
                    "Time since the request of the last reading of a variable",
                    labels,
                    age.toNanos() / 1e9));
    KrlValue value = update.value();
    if (good && value != null) {
      for (Leaf leaf : Leaf.of(variable.name(), value)) {
        if (shown.add(leaf.name())) {
          add(leaf, variable, families);
        }
      }
    }
  }

  private void add(Leaf leaf, PlannedVariable variable, MetricFamilies families) {
    KrlValue value = leaf.value();
    if (value instanceof KrlInt || value instanceof KrlReal || value instanceof KrlBool) {
      double number = value instanceof KrlBool bool ? (bool.value() ? 1 : 0) : value.asDouble();
      families.gauge(
          "value",
          "A number of a robot; 1 and 0 for TRUE and FALSE",
          Labels.of(
              "robot",
              robot.name(),
              "variable",
              leaf.name(),
              "unit",
              variable.unit(UNITS, leaf.name())),
          number);
    } else {
      families.gauge(
          "state",
          "1 for the text or constant that a variable of a robot has",
          Labels.of("robot", robot.name(), "variable", leaf.name(), "state", leaf.text()),
          1);
    }
  }
}
