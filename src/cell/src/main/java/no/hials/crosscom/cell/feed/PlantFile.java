package no.hials.crosscom.cell.feed;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import no.hials.crosscom.WatchConfig;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Profiles;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.SettingText;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/**
 * Reads a plant from the tables {@code limits}, {@code robots}, {@code groups}, {@code variables}.
 */
public final class PlantFile {
  /** The tables of a file that are read here. */
  public static final List<String> TABLES = List.of("limits", "robots", "groups", "variables");

  private static final String GROUPS = "groups";
  private static final String PERIOD = "period";
  private static final String VARIABLES = "variables";
  private static final String WRITE = "write";
  private static final Duration ACCESS_TIME = Duration.ofMillis(5);
  private static final double MAX_LOAD = 50;
  private static final Duration MAX_PERIOD = Duration.ofDays(1);
  private static final String TIME_RULE =
      "must be a text in quotes such as \"100ms\", or a whole number of ms";

  private PlantFile() {}

  /** The groups of a plant that configures none: the position and the state of the robot. */
  public static final List<Group> DEFAULT_GROUPS =
      List.of(
          new Group(
              "motion",
              List.of(),
              List.of("$POS_ACT", "$AXIS_ACT"),
              Duration.ofMillis(100),
              false,
              0),
          new Group(
              "state",
              List.of(),
              List.of("$MODE_OP", "$OV_PRO", "$PRO_STATE1", "$STOPMESS", "$PERI_RDY"),
              Duration.ofSeconds(1),
              false,
              0));

  /**
   * Reads a plant.
   *
   * @param more further robots, which are not in the file
   * @throws FileException if something is wrong, with its line and the rule
   */
  public static Plant read(TomlTable root, Map<String, Robot> more) throws FileException {
    Map<String, Robot> robots = new LinkedHashMap<>(Profiles.robots(root, ServerType.C3_BRIDGE));
    for (Robot robot : more.values()) {
      if (robots.putIfAbsent(robot.name(), robot) != null) {
        throw root.error("robots", "the name " + robot.name() + " is also of another robot");
      }
    }
    if (robots.isEmpty()) {
      throw new FileException(root.place() + ": there is no robot: add a table [robots.NAME]");
    }
    Map<String, VariableSettings> settings = settings(root);
    List<Group> groups = groups(root, robots);
    TomlTable limits = root.table("limits");
    limits.allow("access-time", "load");
    Duration accessTime = limits.converted("access-time", SettingText::time, TIME_RULE, TIMES);
    Double load = limits.number("load");
    if (load != null && !(load > 0 && load <= 100)) {
      throw limits.error("load", "must be more than 0 and at most 100 %, is " + load);
    }
    return new Plant(
        robots,
        groups.isEmpty() ? DEFAULT_GROUPS : groups,
        settings,
        accessTime == null ? ACCESS_TIME : accessTime,
        load == null ? MAX_LOAD : load);
  }

  private static final Class<?>[] TIMES = {String.class, Integer.class, Long.class};

  private static List<Group> groups(TomlTable root, Map<String, Robot> robots)
      throws FileException {
    List<Group> groups = new ArrayList<>();
    for (TomlTable table : root.tables(GROUPS)) {
      table.allow("robots", VARIABLES, PERIOD, "on-change", "dead-band");
      Duration period = table.converted(PERIOD, SettingText::time, TIME_RULE, TIMES);
      if (period == null) {
        throw table.error("a group needs a period, such as period = \"100ms\"");
      }
      if (period.compareTo(MAX_PERIOD) > 0) {
        throw table.error(PERIOD, "must be at most 1 day, is " + period.toMillis() + " ms");
      }
      List<String> chosen = table.texts("robots");
      if (table.has("robots") && chosen.isEmpty()) {
        throw table.error("robots", "name at least one robot, or leave it out for all");
      }
      for (String robot : chosen) {
        if (!robots.containsKey(robot)) {
          throw table.error(
              "robots",
              "no robot is named " + robot + "; known: " + String.join(", ", robots.keySet()));
        }
      }
      List<String> variables = table.texts(VARIABLES).stream().map(String::strip).toList();
      checkNames(table, VARIABLES, variables);
      Double deadBand = deadBand(table);
      if (deadBand != null && !table.flag("on-change")) {
        throw table.error("dead-band", "needs on-change = true, without which all values are new");
      }
      groups.add(
          new Group(
              table.name(),
              chosen,
              variables,
              period,
              table.flag("on-change"),
              deadBand == null ? 0 : deadBand));
    }
    return groups;
  }

  /** Checks names by the rules of the client. */
  private static void checkNames(TomlTable table, String key, List<String> names)
      throws FileException {
    try {
      WatchConfig.create(names, cfg -> {});
    } catch (IllegalArgumentException e) {
      throw table.error(key, String.valueOf(e.getMessage()));
    }
  }

  private static @Nullable Double deadBand(TomlTable table) throws FileException {
    Double deadBand = table.number("dead-band");
    if (deadBand != null && !(deadBand >= 0 && Double.isFinite(deadBand))) {
      throw table.error("dead-band", "must be 0 or more, is " + deadBand);
    }
    return deadBand;
  }

  private static Map<String, VariableSettings> settings(TomlTable root) throws FileException {
    Map<String, VariableSettings> all = new LinkedHashMap<>();
    for (TomlTable table : root.tables(VARIABLES)) {
      table.allow("unit", "dead-band", "range", "values", WRITE);
      String name = table.name().strip().toUpperCase(Locale.ROOT);
      try {
        WatchConfig.create(List.of(name), cfg -> {});
      } catch (IllegalArgumentException e) {
        throw table.error(String.valueOf(e.getMessage()));
      }
      List<String> values = values(table);
      Range range = range(table);
      boolean writable = table.flag(WRITE);
      if (writable && range == null && values.isEmpty()) {
        throw table.error(
            WRITE, "needs the range of the numbers, or the list of the values, that are allowed");
      }
      VariableSettings settings =
          new VariableSettings(name, table.text("unit"), deadBand(table), range, values, writable);
      if (all.put(name, settings) != null) {
        throw table.error("the variable is there twice: KRL does not tell cases apart");
      }
    }
    return all;
  }

  private static List<String> values(TomlTable table) throws FileException {
    List<String> values = table.texts("values");
    for (String value : values) {
      // a text of KRL has no double quote, so that the value would allow nothing
      if (value.contains("\"")) {
        throw table.error(
            "values",
            "must be texts without a double quote in them, such as \"Home\", is " + value);
      }
    }
    return values;
  }

  private static @Nullable Range range(TomlTable table) throws FileException {
    if (!table.has("range")) {
      return null;
    }
    List<Double> numbers = table.numbers("range");
    if (numbers.size() != 2) {
      throw table.error("range", "must be two numbers, such as [0, 100]");
    }
    try {
      return new Range(numbers.get(0), numbers.get(1));
    } catch (IllegalArgumentException e) {
      throw table.error("range", String.valueOf(e.getMessage()));
    }
  }
}
