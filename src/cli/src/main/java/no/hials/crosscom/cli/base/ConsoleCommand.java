package no.hials.crosscom.cli.base;

import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** What every command has: the standard options, the exit codes, and a console. */
@Command(
    mixinStandardHelpOptions = true,
    versionProvider = VersionProvider.class,
    sortOptions = false,
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:done",
      "1:refused by the controller",
      "2:wrong usage, or a file with errors",
      "3:could not connect, or not listen",
      "4:connection lost, timed out or not this protocol",
      "5:not sent: for reading only, or not confirmed",
      "70:internal error, please report it",
      "74:stdout or a file could not be written"
    })
public abstract class ConsoleCommand implements Callable<Integer> {
  private final Console console;

  @Spec private CommandSpec spec;

  @Option(
      names = {"-v", "--verbose"},
      order = 6,
      description = {
        "Log to stderr what the connection does, and where an error comes from.",
        "Twice (-vv): every frame, in hex."
      })
  private boolean[] verbose = {};

  @SuppressWarnings("NullAway.Init") // picocli sets the spec
  public ConsoleCommand(Console console) {
    this.console = console;
  }

  /** Does the work. */
  public abstract ExitCode run() throws IOException;

  @Override
  public final Integer call() throws IOException {
    Logging.setVerbosity(verbose.length);
    return run().code();
  }

  public final Console console() {
    return console;
  }

  public final boolean isVerbose() {
    return verbose.length > 0;
  }

  /** Creates an exception for what only shows when options are seen together. */
  public final ParameterException wrongUsage(String message) {
    return new ParameterException(spec.commandLine(), message);
  }
}
