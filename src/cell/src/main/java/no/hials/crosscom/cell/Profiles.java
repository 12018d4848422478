package no.hials.crosscom.cell;

import java.math.BigInteger;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/**
 * The named robots of the configuration file.
 *
 * @param file the configuration file
 * @param defaultRobot the robot to use if no robot is named; null if the file sets no default
 * @param robots the robots by their names
 */
public record Profiles(Path file, @Nullable String defaultRobot, Map<String, Robot> robots) {
  /** The environment variable that names another file. */
  static final String FILE_VARIABLE = "JOPENSHOWVAR_CONFIG";

  private static final String DEFAULT = "default";
  private static final String ROBOTS = "robots";

  /** Returns the path of the file, which may not exist. */
  public static Path path(Function<String, @Nullable String> environment) {
    String own = environment.apply(FILE_VARIABLE);
    return own == null
        ? configFolder(environment).resolve("jopenshowvar").resolve("config.toml")
        : Path.of(own);
  }

  private static Path configFolder(Function<String, @Nullable String> environment) {
    String appData = environment.apply("APPDATA");
    if (appData != null && System.getProperty("os.name").startsWith("Windows")) {
      return Path.of(appData);
    }
    String xdg = environment.apply("XDG_CONFIG_HOME");
    // a relative path must be ignored (XDG Base Directory Specification)
    if (xdg != null && Path.of(xdg).isAbsolute()) {
      return Path.of(xdg);
    }
    String home = environment.apply("HOME");
    return Path.of(home == null ? System.getProperty("user.home") : home, ".config");
  }

  /**
   * Reads the file.
   *
   * @param simulated the server of simulated controllers for which the file names no server
   * @return the robots; null if the file does not exist and {@code JOPENSHOWVAR_CONFIG} is not set
   * @throws FileException if the file cannot be read or has an error
   */
  public static @Nullable Profiles read(
      Function<String, @Nullable String> environment, ServerType simulated) throws FileException {
    Path file = path(environment);
    if (Files.notExists(file)) {
      if (environment.apply(FILE_VARIABLE) == null) {
        return null;
      }
      throw new FileException(
          "cannot read " + file + ", which " + FILE_VARIABLE + " names: file not found");
    }
    return of(TomlTable.parse(file, TomlTable.textOf(file)), file, simulated);
  }

  private static Profiles of(TomlTable root, Path file, ServerType simulated) throws FileException {
    root.allow(DEFAULT, ROBOTS);
    Map<String, Robot> robots = robots(root, simulated);
    String name = root.text(DEFAULT);
    if (name != null && !robots.containsKey(name)) {
      throw root.error(DEFAULT, noRobot(name, robots));
    }
    return new Profiles(file, name, robots);
  }

  /**
   * Returns the robots of the table {@code robots}, by their names.
   *
   * @param simulated the server of simulated controllers for which the file names no server
   */
  public static Map<String, Robot> robots(TomlTable root, ServerType simulated)
      throws FileException {
    Map<String, Robot> robots = new TreeMap<>();
    Map<String, TomlTable> names = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
    for (TomlTable robot : root.tables(ROBOTS)) {
      TomlTable same = names.put(robot.name(), robot);
      if (same != null) {
        throw robot.error(
            "the name differs only in case from " + same.name() + " in " + same.place());
      }
      robots.put(robot.name(), robot(robot, simulated));
    }
    return robots;
  }

  private static Robot robot(TomlTable table, ServerType simulated) throws FileException {
    if (!SettingText.isRobotName(table.name())) {
      throw table.error("a robot's name must be letters, digits, _, - and ., for @NAME");
    }
    table.allow("host", "port", "timeout", "read-only", "mock", "server", "charset");
    boolean mock = table.flag("mock");
    boolean readOnly = table.flag("read-only");
    HostAndPort host = table.converted("host", HostAndPort::parse, TomlTable.TEXT, String.class);
    Integer port =
        table.converted(
            "port",
            SettingText::port,
            "must be a whole number, without quotes",
            Integer.class,
            Long.class,
            BigInteger.class);
    Duration timeout =
        table.converted(
            "timeout",
            SettingText::time,
            "must be a text in quotes such as \"1.5s\", or a whole number of ms",
            String.class,
            Integer.class,
            Long.class,
            BigInteger.class);
    ServerType server =
        table.converted("server", SettingText::server, TomlTable.TEXT, String.class);
    Charset charset =
        table.converted("charset", SettingText::charset, TomlTable.TEXT, String.class);
    if (mock && (host != null || port != null)) {
      throw table.error("mock excludes host and port");
    }
    if (!mock && host == null) {
      throw table.error("a robot needs a host, or mock = true");
    }
    return new Robot(
        table.name(),
        host == null ? null : host.host(),
        port(table, host, port),
        timeout,
        readOnly ? "read-only = true in " + table.place("read-only") : null,
        mock && server == null ? simulated : server,
        charset);
  }

  private static int port(TomlTable table, @Nullable HostAndPort host, @Nullable Integer port)
      throws FileException {
    try {
      return host == null
          ? ClientConfig.DEFAULT_PORT
          : host.portOr(port, ClientConfig.DEFAULT_PORT);
    } catch (IllegalArgumentException e) {
      throw table.error("host", String.valueOf(e.getMessage()));
    }
  }

  /**
   * Returns a robot.
   *
   * @throws FileException if no robot has this name
   */
  public Robot robot(String name) throws FileException {
    Robot robot = robots.get(name);
    if (robot == null) {
      throw new FileException(file + ": " + noRobot(name, robots));
    }
    return robot;
  }

  private static String noRobot(String name, Map<String, Robot> robots) {
    String known =
        robots.isEmpty() ? "there are none" : "known: " + String.join(", ", robots.keySet());
    return "no robot is named " + name + "; " + known;
  }
}
