package no.hials.crosscom.cell.feed;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Robot;
import org.jspecify.annotations.Nullable;

/**
 * The robots of a plant and what is read from them.
 *
 * @param robots the robots by their names
 * @param groups the variables that are read
 * @param settings the settings of variables by their names in upper case
 * @param accessTime the expected time of one access to a controller
 * @param maxLoad the highest load of a controller that is allowed, in percent of its time
 */
public record Plant(
    Map<String, Robot> robots,
    List<Group> groups,
    Map<String, VariableSettings> settings,
    Duration accessTime,
    double maxLoad) {
  /** The number of plans above the limit that an error lists. */
  private static final int MAX_LISTED = 5;

  /** Copies the collections. */
  public Plant {
    robots = Map.copyOf(robots);
    groups = List.copyOf(groups);
    settings = Map.copyOf(settings);
  }

  /** Returns the settings of a variable, whatever its case; null if it has none. */
  public @Nullable VariableSettings settings(String variable) {
    return settings.get(variable.toUpperCase(Locale.ROOT));
  }

  /** Returns the plans of all robots, in the order of their names. */
  public List<PollPlan> plans() {
    return robots.values().stream()
        .map(robot -> PollPlan.of(this, robot))
        .sorted((a, b) -> a.robot().name().compareTo(b.robot().name()))
        .toList();
  }

  /**
   * Checks that no plan uses too much of the time of a controller.
   *
   * @throws FileException if a plan is above the limit
   */
  public void checkLoad() throws FileException {
    List<PollPlan> above = plans().stream().filter(plan -> plan.load() > maxLoad).toList();
    if (!above.isEmpty()) {
      throw new FileException(
          String.format(
              Locale.ROOT,
              "%s: at most %.0f %% is allowed ([limits] load); read fewer variables, less often,"
                  + " or as structures",
              above.stream().limit(MAX_LISTED).map(PollPlan::text).collect(Collectors.joining("; "))
                  + (above.size() > MAX_LISTED
                      ? "; and " + (above.size() - MAX_LISTED) + " more robots"
                      : ""),
              maxLoad));
    }
  }
}
