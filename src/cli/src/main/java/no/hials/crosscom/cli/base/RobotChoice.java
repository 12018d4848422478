package no.hials.crosscom.cli.base;

import java.nio.charset.Charset;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.HostAndPort;
import no.hials.crosscom.cell.Profiles;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;

/**
 * The controllers that the user chose by the options of a command.
 *
 * @param command the command
 * @param hostOption the name of the option with the address of a controller
 * @param host its argument, or null
 * @param portOption the name of the option with the port of a controller
 * @param port its argument, or null
 * @param robots the names of robots of the configuration file, with or without @
 * @param mock whether a simulated controller is chosen
 * @param simulated the server of a simulated controller if {@code server} is null
 * @param server the server of a simulated controller, or null
 * @param charset the charset of texts on KUKAVARPROXY, or null for the robot's own
 * @param timeout the limit for connecting and for each answer, or null for the robot's own
 */
public record RobotChoice(
    ConsoleCommand command,
    String hostOption,
    @Nullable String host,
    String portOption,
    @Nullable Integer port,
    List<String> robots,
    boolean mock,
    ServerType simulated,
    @Nullable ServerType server,
    @Nullable Charset charset,
    @Nullable Duration timeout) {

  /**
   * Returns the controllers, at least one: by the options, else by the environment, else the
   * default robot of the configuration file. The file is read only if one of its robots is needed.
   *
   * @throws FileException if the configuration file has an error, or lacks the robot
   */
  public List<Robot> targets() throws FileException {
    EnvironmentSettings environment = EnvironmentSettings.of(command);
    boolean named = !robots.isEmpty();
    List<Robot> result = new ArrayList<>();
    for (Robot target : chosen(environment)) {
      Duration own = target.timeout();
      // the default robot has the lowest precedence
      Duration lesser = named ? or(own, environment.timeout()) : or(environment.timeout(), own);
      result.add(withOptions(target, or(timeout, lesser), environment.readOnly()));
    }
    return result;
  }

  private List<Robot> chosen(EnvironmentSettings environment) throws FileException {
    if (host != null && mock) {
      throw command.wrongUsage(hostOption + " and --mock exclude each other");
    }
    if (!robots.isEmpty()) {
      if (host != null || mock) {
        String other = mock ? "--mock" : hostOption;
        throw command.wrongUsage(other + " and @" + names().get(0) + " exclude each other");
      }
      return named();
    }
    if (mock) {
      return List.of(new Robot("", null, 0, null, null, simulated, null));
    }
    if (host != null) {
      HostAndPort at = command.argument(hostOption, host, HostAndPort::parse);
      int itsPort =
          command.argument(hostOption, host, text -> at.portOr(port, ClientConfig.DEFAULT_PORT));
      return List.of(new Robot("", at.host(), itsPort, null, null, null, null));
    }
    if (environment.host() != null) {
      return List.of(new Robot("", environment.host(), environment.port(), null, null, null, null));
    }
    Profiles profiles = Profiles.read(command.console()::environment, simulated);
    if (profiles == null || profiles.defaultRobot() == null) {
      throw command.wrongUsage(
          "which controller? give "
              + hostOption
              + " HOST, or --mock for a simulated one"
              + (profiles == null ? "" : ", or @NAME for a robot of " + profiles.file()));
    }
    return List.of(profiles.robot(profiles.defaultRobot()));
  }

  /** Returns the names of {@code --robot NAME} and {@code @NAME}. */
  private List<String> names() {
    return robots.stream().map(name -> name.startsWith("@") ? name.substring(1) : name).toList();
  }

  private List<Robot> named() throws FileException {
    List<String> names = names();
    if (names.contains("")) {
      throw command.wrongUsage("the name of the robot is missing: @NAME, without a blank after @");
    }
    Profiles profiles = Profiles.read(command.console()::environment, simulated);
    List<Robot> result = new ArrayList<>();
    for (String name : names) {
      if (profiles == null) {
        throw new FileException(
            "no robot is named "
                + name
                + ": there is no "
                + Profiles.path(command.console()::environment));
      }
      Robot robot = profiles.robot(name);
      if (result.contains(robot)) {
        throw command.wrongUsage("@" + name + " is given twice");
      }
      result.add(robot);
    }
    return result;
  }

  private Robot withOptions(Robot target, @Nullable Duration limit, boolean readOnly) {
    if (target.host() == null && port != null) {
      throw command.wrongUsage(
          portOption + " goes with " + hostOption + "; a simulated controller takes a free port");
    }
    if (target.host() != null && server != null) {
      throw command.wrongUsage("--server goes with --mock");
    }
    return new Robot(
        target.name(),
        target.host(),
        port == null ? target.port() : port,
        limit,
        readOnly ? "JOPENSHOWVAR_READ_ONLY=true" : target.readOnlyBy(),
        server == null ? target.server() : server,
        charset == null ? target.charset() : charset);
  }

  private static @Nullable Duration or(@Nullable Duration first, @Nullable Duration second) {
    return first == null ? second : first;
  }
}
