package no.hials.crosscom.kinematics;

import java.io.IOException;
import java.io.Reader;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.DoublePredicate;
import no.hials.crosscom.protocol.value.Axis;

/** Reads a robot from a properties file. Error messages have the file, key, rule and value. */
final class RobotFile {
  private static final Set<String> KEYS =
      Set.of(
          "name",
          "a1",
          "a2",
          "b",
          "c1",
          "c2",
          "c3",
          "c4",
          "sign",
          "offset",
          "minimum",
          "maximum",
          "speed",
          "acceleration",
          "home");

  private final String file;
  private final Properties properties;

  private RobotFile(String file, Properties properties) {
    this.file = file;
    this.properties = properties;
  }

  static RobotFile read(Reader reader, String file) throws IOException {
    Properties properties = new Properties();
    try {
      properties.load(reader);
    } catch (IllegalArgumentException e) {
      throw new IOException(file + ": expected a properties file, found " + e.getMessage(), e);
    }
    return of(file, properties);
  }

  static RobotFile of(String file, Properties properties) throws IOException {
    RobotFile robot = new RobotFile(file, properties);
    for (String key : new TreeSet<>(properties.stringPropertyNames())) {
      if (!KEYS.contains(key)) {
        throw robot.error(key, "one of " + new TreeSet<>(KEYS), "this key");
      }
    }
    return robot;
  }

  RobotModel toModel() throws IOException {
    Axis minimum = axes("minimum");
    Axis maximum = axes("maximum");
    for (int axis = 0; axis < Axis.COUNT; axis++) {
      if (minimum.get(axis) >= maximum.get(axis)) {
        throw error(
            "minimum",
            "less than the maximum of A" + (axis + 1) + ", " + maximum.get(axis),
            minimum.get(axis));
      }
    }
    RobotModel model =
        new RobotModel(
            text("name"),
            arm(),
            minimum,
            maximum,
            axes("speed", "six numbers above 0", speed -> speed > 0),
            axes("acceleration", "six numbers above 0", acceleration -> acceleration > 0),
            axes("home"));
    for (int axis : model.axesOutsideLimits(model.home())) {
      throw error(
          "home",
          "A" + (axis + 1) + " from " + minimum.get(axis) + " to " + maximum.get(axis),
          model.home().get(axis));
    }
    return model;
  }

  private OrthoParallelArm arm() throws IOException {
    return new OrthoParallelArm(
        number("a1"),
        number("a2"),
        number("b"),
        number("c1"),
        positive("c2"),
        positive("c3"),
        number("c4"),
        axes("sign", "six numbers, each 1 or -1", sign -> Math.abs(sign) == 1),
        axes("offset"));
  }

  private Axis axes(String key) throws IOException {
    return axes(key, "six numbers", Double::isFinite);
  }

  private Axis axes(String key, String expected, DoublePredicate rule) throws IOException {
    String text = text(key);
    String[] words = text.split("\\s+", -1);
    if (words.length != Axis.COUNT) {
      throw error(key, expected, text);
    }
    double[] six = new double[Axis.COUNT];
    for (int axis = 0; axis < six.length; axis++) {
      six[axis] = number(key, expected, words[axis], rule);
    }
    return Axis.of(six);
  }

  private double number(String key) throws IOException {
    return number(key, "a number", text(key), Double::isFinite);
  }

  private double positive(String key) throws IOException {
    return number(key, "a number above 0", text(key), value -> value > 0);
  }

  private double number(String key, String expected, String text, DoublePredicate rule)
      throws IOException {
    double value;
    try {
      value = Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw error(key, expected, text);
    }
    if (!Double.isFinite(value) || !rule.test(value)) {
      throw error(key, expected, text);
    }
    return value;
  }

  private String text(String key) throws IOException {
    String value = properties.getProperty(key, "").strip();
    if (value.isEmpty()) {
      throw error(key, "a value", "none");
    }
    return value;
  }

  private IOException error(String key, String expected, Object found) {
    return new IOException(file + ": " + key + ": expected " + expected + ", found " + found);
  }
}
