package no.hials.crosscom.cell.feed;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import no.hials.crosscom.cell.Printable;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.protocol.ServerType;

/**
 * The accesses that read the variables of one robot. Two fields of one structure are read as the
 * whole structure. C3 Bridge reads all variables of a period in one access.
 *
 * @param robot the robot
 * @param variables its variables by their names in upper case
 * @param accessTime the expected time of one access
 */
public record PollPlan(Robot robot, Map<String, PlannedVariable> variables, Duration accessTime) {
  /** The variables of one access of C3 Bridge (docs/reference/c3-messages.md, read multiple). */
  private static final int MAX_BATCH = 255;

  /** Keeps the order of the variables. */
  public PollPlan {
    variables = Collections.unmodifiableMap(new LinkedHashMap<>(variables));
  }

  /** A configured variable, as the configuration writes it, and its group. */
  private record Wish(String name, Group group) {
    String key() {
      return name.toUpperCase(Locale.ROOT);
    }

    /** Returns the structure of a field in upper case; empty if it has to be read alone. */
    String structure() {
      int dot = name.indexOf('.');
      return dot < 0 || name.indexOf('[', dot) >= 0 ? "" : key().substring(0, dot);
    }

    boolean isAsOftenAs(Wish other) {
      return group.period().equals(other.group.period());
    }
  }

  /** Returns the plan of a robot. A variable of several groups has the shortest period of them. */
  static PollPlan of(Plant plant, Robot robot) {
    Map<String, Wish> wishes = new LinkedHashMap<>();
    for (Group group : plant.groups()) {
      if (group.robots().isEmpty() || group.robots().contains(robot.name())) {
        for (String name : group.variables()) {
          Wish wish = new Wish(name, group);
          wishes.merge(
              wish.key(), wish, (a, b) -> b.group.period().compareTo(a.group.period()) < 0 ? b : a);
        }
      }
    }
    Map<String, PlannedVariable> variables = new LinkedHashMap<>();
    wishes.forEach(
        (key, wish) -> {
          VariableSettings settings = plant.settings(key);
          Double own = settings == null ? null : settings.deadBand();
          variables.put(
              key,
              new PlannedVariable(
                  wish.name,
                  read(wish, wishes.values()),
                  wish.group.period(),
                  wish.group.onChange(),
                  own == null ? wish.group.deadBand() : own,
                  settings));
        });
    return new PollPlan(robot, variables, plant.accessTime());
  }

  /** Returns the structure of a field if it or another field of it is read as often. */
  private static String read(Wish wish, Collection<Wish> all) {
    String structure = wish.structure();
    boolean shared =
        !structure.isEmpty()
            && all.stream()
                .filter(other -> !other.equals(wish) && other.isAsOftenAs(wish))
                .anyMatch(
                    other -> other.key().equals(structure) || other.structure().equals(structure));
    return shared ? wish.name.substring(0, structure.length()) : wish.name;
  }

  /** Returns the variables and structures to read, by their period, the shortest first. */
  public Map<Duration, List<String>> reads() {
    Map<Duration, Map<String, String>> reads = new TreeMap<>();
    for (PlannedVariable variable : variables.values()) {
      reads
          .computeIfAbsent(variable.period(), it -> new LinkedHashMap<>())
          .putIfAbsent(variable.read().toUpperCase(Locale.ROOT), variable.read());
    }
    Map<Duration, List<String>> result = new LinkedHashMap<>();
    reads.forEach((period, names) -> result.put(period, List.copyOf(names.values())));
    return result;
  }

  /**
   * Returns the accesses per second. Assumes KUKAVARPROXY, which needs more of them, if the type of
   * the server is not configured.
   */
  public double accessesPerSecond() {
    double sum = 0;
    for (Map.Entry<Duration, List<String>> one : reads().entrySet()) {
      int count = one.getValue().size();
      int accesses = isC3() ? (count + MAX_BATCH - 1) / MAX_BATCH : count;
      sum += accesses * 1e9 / one.getKey().toNanos();
    }
    return sum;
  }

  private boolean isC3() {
    return robot.server() == ServerType.C3_BRIDGE;
  }

  /** Returns the expected load of the controller: the percentage of its time spent on accesses. */
  public double load() {
    return accessesPerSecond() * accessTime.toNanos() / 1e7;
  }

  /** Returns a description of the plan in one line. */
  public String text() {
    Set<String> periods = new LinkedHashSet<>();
    reads().forEach((period, names) -> periods.add(period.toMillis() + " ms"));
    return String.format(
        Locale.ROOT,
        "%s: %s every %s, %.1f accesses/s, %.0f %% load%s",
        robot.name(),
        Printable.count(variables.size(), "variable"),
        String.join(" and ", periods),
        accessesPerSecond(),
        load(),
        robot.server() == null ? " with KUKAVARPROXY, less with C3 Bridge" : "");
  }

  /** Returns the variables that are read by one name of {@link #reads}. */
  List<PlannedVariable> readBy(String read) {
    List<PlannedVariable> found = new ArrayList<>();
    for (PlannedVariable variable : variables.values()) {
      if (variable.read().equalsIgnoreCase(read)) {
        found.add(variable);
      }
    }
    return found;
  }
}
