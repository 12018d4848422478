package no.hials.crosscom.kinematics;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Properties;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The robots that are known by name: the KR 6 R900 sixx and those of {@code robots.tsv}. */
final class RobotTable {
  /**
   * The time to the highest speed, s, of a robot that does not state its accelerations; assumed.
   */
  static final double RAISE_TIME = 0.3;

  private static final String FILE = "robots.tsv";

  /** The number of names in an error message. */
  private static final int NEAREST = 3;

  /** The robots by {@link #key}, in the order of the table. */
  private static final Map<String, RobotModel> ROBOTS = read();

  private RobotTable() {}

  static List<String> names() {
    return ROBOTS.values().stream().map(RobotModel::name).toList();
  }

  static RobotModel named(String name) {
    RobotModel robot = ROBOTS.get(key(name));
    if (robot == null) {
      throw new IllegalArgumentException(
          "no robot is named " + name + ", the nearest names are " + nearest(key(name)));
    }
    return robot;
  }

  private static String key(String name) {
    return name.replaceAll("\\s", "").toUpperCase(Locale.ROOT);
  }

  private static String nearest(String key) {
    return ROBOTS.entrySet().stream()
        .sorted(
            Comparator.<Map.Entry<String, RobotModel>, Boolean>comparing(
                    robot -> !robot.getKey().startsWith(key))
                .thenComparingInt(robot -> distance(key, robot.getKey())))
        .limit(NEAREST)
        .map(robot -> robot.getValue().name())
        .collect(Collectors.joining(", "));
  }

  /** Returns the fewest characters to insert, remove or replace to change one text to the other. */
  private static int distance(String one, String other) {
    int[] row = new int[other.length() + 1];
    for (int j = 0; j < row.length; j++) {
      row[j] = j;
    }
    for (int i = 0; i < one.length(); i++) {
      int diagonal = row[0];
      row[0] = i + 1;
      for (int j = 1; j < row.length; j++) {
        int replaced = diagonal + (one.charAt(i) == other.charAt(j - 1) ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
      }
    }
    return row[other.length()];
  }

  private static Map<String, RobotModel> read() {
    InputStream file = Objects.requireNonNull(RobotTable.class.getResourceAsStream(FILE), FILE);
    try (file) {
      List<String[]> rows =
          new String(file.readAllBytes(), StandardCharsets.UTF_8)
              .lines()
              .filter(line -> !line.startsWith("#"))
              .map(line -> line.split("\t"))
              .toList();
      Map<String, RobotModel> robots = new LinkedHashMap<>();
      put(robots, RobotModel.kr6r900sixx());
      for (String[] row : rows.subList(1, rows.size())) {
        put(robots, RobotFile.of(FILE, properties(rows.get(0), row)).toModel());
      }
      return robots;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void put(Map<String, RobotModel> robots, RobotModel robot) {
    robots.put(key(robot.name()), robot);
  }

  /** Returns the properties of a row; {@code robots.tsv} explains those that all rows share. */
  private static Properties properties(String[] keys, String[] row) {
    Properties properties = new Properties();
    // the last column is the source
    for (int i = 0; i < keys.length - 1; i++) {
      properties.setProperty(keys[i], row[i]);
    }
    properties.setProperty("offset", "0 -90 0 0 0 0");
    properties.setProperty("home", "0 -90 90 0 0 0");
    properties.setProperty(
        "acceleration",
        Stream.of(properties.getProperty("speed").split(" "))
            .map(speed -> String.valueOf(Double.parseDouble(speed) / RAISE_TIME))
            .collect(Collectors.joining(" ")));
    return properties;
  }
}
