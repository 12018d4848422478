package no.hials.crosscom.gateway.internal.sparkplug;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.LongSupplier;
import no.hials.crosscom.cell.Leaf;
import no.hials.crosscom.cell.Units;
import no.hials.crosscom.cell.feed.PlannedVariable;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.protocol.value.KrlValue;
import org.eclipse.tahu.message.model.Metric;
import org.eclipse.tahu.message.model.MetricDataType;
import org.jspecify.annotations.Nullable;

/** A robot as a device of Sparkplug. Not thread-safe. */
final class Device {
  private static final Units UNITS = new Units();

  private final RobotFeed robot;
  private final LongSupplier aliases;
  private final Map<String, DeviceMetric> metrics = new LinkedHashMap<>();

  /** The variables that were read or refused since the robot was connected. */
  private final Set<String> known = new HashSet<>();

  /** The metrics that have changed since the last message about them. */
  private final Set<DeviceMetric> unsent = new LinkedHashSet<>();

  private boolean born;
  private boolean changed;

  /**
   * Creates a device.
   *
   * @param aliases returns an alias that the node does not use yet
   */
  Device(RobotFeed robot, LongSupplier aliases) {
    this.robot = robot;
    this.aliases = aliases;
  }

  RobotFeed robot() {
    return robot;
  }

  String name() {
    return robot.name();
  }

  /** Returns whether its birth was published, and its death was not. */
  boolean isBorn() {
    return born;
  }

  /**
   * Returns whether a birth must be published: all its variables are known now, or its metrics
   * differ from those of its last birth.
   */
  boolean isBirthDue() {
    return robot.isConnected()
        && (born ? changed : known.containsAll(robot.plan().variables().keySet()));
  }

  /** Returns whether its metrics differ from those of its birth. */
  boolean isChanged() {
    return changed;
  }

  /** Applies updates. */
  void take(List<Update> updates) {
    for (Update update : updates) {
      PlannedVariable variable = update.variable();
      KrlValue value = update.value();
      if (value != null) {
        boolean read = update.quality() == Quality.GOOD;
        Set<DeviceMetric> present = new HashSet<>();
        for (Leaf leaf : Leaf.of(variable.key(), value)) {
          DeviceMetric metric = metric(leaf, variable);
          // a late value is stale, too; only one from before the loss of the robot has a known time
          read |= !metric.isOf(update.time());
          changed |= metric.take(leaf, update.time(), update.quality());
          present.add(metric);
          unsent.add(metric);
        }
        if (read) {
          known.add(variable.key());
        }
        for (DeviceMetric metric : metrics.values()) {
          if (metric.isOf(variable.key()) && !metric.isBad() && !present.contains(metric)) {
            // a field that the value no longer has
            metric.without(Quality.BAD, update.time());
            unsent.add(metric);
          }
        }
      } else {
        if (update.quality() == Quality.BAD) {
          known.add(variable.key());
        }
        for (DeviceMetric metric : metrics.values()) {
          if (metric.isOf(variable.key())) {
            metric.without(update.quality(), update.time());
            unsent.add(metric);
          }
        }
      }
    }
  }

  /** Returns the metrics with a new value or quality that no message had yet, and forgets them. */
  List<DeviceMetric> takeUnsent() {
    List<DeviceMetric> taken = List.copyOf(unsent);
    unsent.clear();
    return taken;
  }

  private DeviceMetric metric(Leaf leaf, PlannedVariable variable) {
    return metrics.computeIfAbsent(
        leaf.name(), name -> create(name, variable, DeviceMetric.type(leaf.value())));
  }

  private DeviceMetric create(
      String name, @Nullable PlannedVariable variable, MetricDataType type) {
    changed = true;
    return new DeviceMetric(
        name,
        variable == null ? "" : variable.key(),
        aliases.getAsLong(),
        variable == null ? "" : variable.unit(UNITS, name),
        type);
  }

  /** Returns the metric of a stored message. A new metric becomes part of the next birth. */
  DeviceMetric fromStore(String name, MetricDataType type) {
    return metrics.computeIfAbsent(name, it -> create(it, variableOf(it), type));
  }

  /** Returns the planned variable with a leaf of a name: the smallest one; null without one. */
  private @Nullable PlannedVariable variableOf(String name) {
    PlannedVariable found = null;
    for (PlannedVariable variable : robot.plan().variables().values()) {
      if (isLeaf(name, variable.key())
          && (found == null || variable.key().length() > found.key().length())) {
        found = variable;
      }
    }
    return found;
  }

  private static boolean isLeaf(String name, String key) {
    if (Leaf.isWholeArray(key)) {
      return name.startsWith(key.substring(0, key.length() - 1));
    }
    return name.equals(key) || name.startsWith(key + ".") || name.startsWith(key + "[");
  }

  /** Returns the metric of an alias or, ignoring case, of a name, or null. */
  @Nullable DeviceMetric find(@Nullable Long alias, @Nullable String name) {
    for (DeviceMetric metric : metrics.values()) {
      if (alias == null ? metric.name().equalsIgnoreCase(name) : metric.alias() == alias) {
        return metric;
      }
    }
    return null;
  }

  /** Returns the metrics of a birth that is published now. */
  List<Metric> birth() {
    born = true;
    changed = false;
    return metrics.values().stream().map(DeviceMetric::birth).toList();
  }

  /** Called when its birth is no longer valid. */
  void unborn() {
    born = false;
  }

  /** Called when the robot is lost: its variables must be read again before the next birth. */
  void lost() {
    known.clear();
  }
}
