package no.hials.crosscom.cli.base;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.function.Function;
import no.hials.crosscom.cell.Printable;
import no.hials.crosscom.kinematics.RobotModel;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.UnmatchedArgumentException;

/** The common parts of all commands: the standard options, the exit codes, and a console. */
@Command(
    versionProvider = VersionProvider.class,
    sortOptions = false,
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:done",
      "1:refused by the controller, or nothing found",
      "2:wrong usage, or an error in a file",
      "3:could not connect, or could not listen on the port",
      "4:connection lost, timed out or not this protocol",
      "5:not sent: the controller is read-only, or the user did not confirm",
      "70:internal error, please report it",
      "74:stdout or a file could not be written",
      "129:ended by SIGHUP, as when its terminal is closed",
      "130:ended by Ctrl-C (SIGINT), unless described above",
      "143:ended by SIGTERM, unless described above"
    })
public abstract class ConsoleCommand implements Callable<Integer> {
  @SuppressWarnings("NullAway.Init") // picocli sets it
  @Spec
  private CommandSpec spec;

  // not picocli's own options, which would come after those of subclasses
  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Show this help message and exit.")
  @SuppressWarnings("unused") // by picocli only
  private boolean help;

  @Option(
      names = {"-V", "--version"},
      versionHelp = true,
      description = "Print version information and exit.")
  @SuppressWarnings("unused")
  private boolean version;

  @Option(
      names = {"-v", "--verbose"},
      order = 6,
      description = {
        "Log the connection and the stack traces of errors to stderr.",
        "Use -vv to log every frame in hex, too."
      })
  private boolean[] verbose = {};

  /** Does the work. */
  public abstract ExitCode run() throws IOException;

  @Override
  public final Integer call() throws IOException {
    Logging.setVerbosity(verbose.length);
    return run().code();
  }

  protected final CommandTree program() {
    return (CommandTree) spec.root().userObject();
  }

  public final Console console() {
    return program().console();
  }

  public final boolean isVerbose() {
    return verbose.length > 0;
  }

  /** Returns a message about wrong arguments. */
  public static String message(ParameterException e) {
    String first =
        e instanceof UnmatchedArgumentException unmatched ? unmatched.getUnmatched().get(0) : "";
    if (first.startsWith("--robot=@")) {
      return "this command takes no robot: " + first.substring("--robot=".length());
    }
    if (e instanceof UnmatchedArgumentException unmatched && !unmatched.isUnknownOption()) {
      String argument = "'" + first + "'";
      return e.getCommandLine().getSubcommands().isEmpty()
          ? "too many arguments: " + argument + "; an argument with blanks needs quotes"
          : "unknown command: " + argument;
    }
    return Printable.lowerFirst(String.valueOf(e.getMessage()));
  }

  /** Returns the first sentence of a description. */
  public static String firstSentence(String... description) {
    String text = String.join(" ", description);
    int end = text.indexOf(". ");
    return end < 0 ? text : text.substring(0, end + 1);
  }

  /**
   * Returns the model of a simulated robot.
   *
   * @param name the argument of {@code --robot}; null for the default
   */
  protected final RobotModel model(@Nullable String name) {
    if (name != null && name.startsWith("@")) { // a robot of the configuration file
      throw wrongUsage("this command takes no robot: " + name);
    }
    return name == null ? RobotModel.kr6r900sixx() : argument("--robot", name, RobotModel::named);
  }

  /** Parses the argument of an option as picocli does, after all options are known. */
  public final <T> T argument(String option, String text, Function<String, T> parser) {
    try {
      return parser.apply(text);
    } catch (IllegalArgumentException e) {
      throw wrongUsage("invalid value for option '" + option + "': " + e.getMessage());
    }
  }

  /** Creates an exception for an invalid combination of options. */
  public final ParameterException wrongUsage(String message) {
    return new ParameterException(spec.commandLine(), message);
  }
}
