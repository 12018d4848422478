package no.hials.crosscom.cli.base;

import java.io.IOException;
import java.nio.charset.Charset;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.regex.Pattern;
import no.hials.crosscom.cell.FileException;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.protocol.ServerType;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** A command that talks to a controller, and the options that choose the controller. */
public abstract class ControllerCommand extends ConsoleCommand {
  private static final Pattern ROBOT = Pattern.compile("@(\\w[\\w.-]*)?");

  @Option(
      names = "--host",
      paramLabel = "HOST",
      description = "Name or address of the controller; also HOST:PORT or [IPV6]:PORT.")
  private @Nullable String host;

  @Option(
      names = "--robot",
      paramLabel = "NAME",
      description =
          "A robot of the configuration file; short form: @NAME. Without --host, --robot and"
              + " --mock: JOPENSHOWVAR_HOST, or the default robot of the file; see 'jopenshowvar"
              + " --help'.")
  private List<String> robots = new ArrayList<>();

  @Option(
      names = "--port",
      paramLabel = "PORT",
      converter = Converters.Port.class,
      description = "TCP port of the server. Default: 7000.")
  private @Nullable Integer port;

  @Option(
      names = "--mock",
      description =
          "Use a simulated controller (KR 6 R900 sixx, KR C4), which runs only during this"
              + " command.")
  private boolean mock;

  @Option(
      names = "--server",
      paramLabel = "SERVER",
      completionCandidates = Converters.ServerName.class,
      description =
          "Server of the simulated controller: kukavarproxy, or c3 for C3 Bridge. The type of a"
              + " real server is detected, or set by 'server' in config.toml.")
  private @Nullable ServerType server;

  @Option(
      names = "--charset",
      paramLabel = "NAME",
      converter = Converters.CharsetName.class,
      description =
          "Charset of texts on KUKAVARPROXY: the code page of the controller's Windows, such as"
              + " windows-1251. Default: windows-1252.")
  private @Nullable Charset charset;

  @Option(
      names = "--timeout",
      order = 0,
      paramLabel = "TIME",
      description =
          "Maximum time to wait for the connection and for each answer, such as 500 or 500ms,"
              + " 3s, 1m. Default: 5s for the connection, 3s for an answer.")
  private @Nullable Duration timeout;

  /** Returns whether an argument is {@code @NAME}, a robot. */
  public static boolean isRobot(String arg) {
    return ROBOT.matcher(arg).matches();
  }

  /** Replaces each argument {@code @NAME} before {@code --} by {@code --robot=NAME}. */
  public static String[] withNamesAsOptions(String... args) {
    List<String> result = new ArrayList<>();
    boolean options = true;
    for (String arg : args) {
      options &= !arg.equals("--");
      result.add(options && isRobot(arg) ? "--robot=" + arg : arg);
    }
    return result.toArray(String[]::new);
  }

  /**
   * Returns the controllers that the user chose, at least one: by these options, else by the
   * environment, else the default robot of the configuration file. The file is read only if one of
   * its robots is needed.
   *
   * @throws FileException if the configuration file has an error, or lacks the robot
   */
  protected final List<Robot> targets() throws FileException {
    return new RobotChoice(
            this,
            "--host",
            host,
            "--port",
            port,
            robots,
            mock,
            simulated(),
            server,
            charset,
            timeout)
        .targets();
  }

  /**
   * Returns the one controller that the user chose, as {@link #targets}; several are wrong usage.
   */
  protected final Robot target() throws FileException {
    List<Robot> targets = targets();
    if (targets.size() != 1) {
      throw wrongUsage("this command takes one robot, " + targets.size() + " are given");
    }
    return targets.get(0);
  }

  /** Returns the server of a simulated controller if the user does not choose one. */
  protected ServerType simulated() {
    return ServerType.KUKAVARPROXY;
  }

  /** Connects to the one controller that the user chose. */
  protected final RobotConnection open() throws IOException {
    return Robots.open(target(), Robot.ONE_SHOT);
  }

  /**
   * Connects to the chosen controller, unless it is read-only.
   *
   * @param what the operation, such as {@code write $OV_PRO}
   */
  protected final RobotConnection open(WriteOptions options, String what) throws IOException {
    Robot target = target();
    options.permission(console()).checkAllowed(target, what);
    return Robots.open(target, options.connection());
  }

  /** Refuses blank names of variables. */
  protected final void checkNames(Collection<String> names) {
    if (names.stream().anyMatch(String::isBlank)) {
      throw wrongUsage("a name is blank; in a shell, names with $ need single quotes: '$OV_PRO'");
    }
  }
}
