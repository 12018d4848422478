package no.hials.crosscom.cli.variables;

import java.io.IOException;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.cli.base.ControllerCommand;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.cli.base.StopSignal;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** A command that reads repeatedly: the variables, the period and the duration. */
abstract class SamplingCommand extends ControllerCommand {
  private static final Duration MAX_PERIOD = Duration.ofDays(1);

  @Parameters(
      arity = "1..*",
      paramLabel = "NAME",
      description =
          "A variable, a field ('$POS_ACT.X'), an element ('$TORQUE_AXIS_ACT[3]') or a whole"
              + " array ('$TORQUE_AXIS_ACT[]'). Case does not matter.")
  private List<String> names = List.of();

  @Option(
      names = "--period",
      paramLabel = "TIME",
      description = "Period of the readings, such as 20ms, 1.5s, 1m. Default: 100ms.")
  private Duration period = Duration.ofMillis(100);

  @Option(
      names = "--for",
      paramLabel = "TIME",
      description = "Stop after this time. Default: run until Ctrl-C.")
  private @Nullable Duration length;

  @Option(
      names = "--count",
      paramLabel = "NUMBER",
      description = "Stop after this number of samples of each robot.")
  private @Nullable Long count;

  /** Connects to all robots that the user chose. */
  final Sampling sampling() throws IOException {
    check();
    return Sampling.open(
        new Sampling.SamplingPlan(
            distinct(), period, length, count == null ? Long.MAX_VALUE : count),
        targets(),
        Robots::open);
  }

  /** Returns each variable once; the case of its name does not matter. */
  private List<String> distinct() {
    Set<String> seen = new HashSet<>();
    return names.stream().filter(name -> seen.add(name.toUpperCase(Locale.ROOT))).toList();
  }

  /** Reads all variables once, prints the failures, and returns the worst of them. */
  final ExitCode readFirst(Sampling sampling) {
    ExitCode result = ExitCode.DONE;
    for (Sampling.Failure failure : sampling.failedToConnect()) {
      console().failure(failure.label(), failure.cause(), isVerbose());
      result = result.orWorse(ExitCode.of(failure.cause()));
    }
    List<Sampling.Failure> failures;
    try {
      failures = sampling.readFirst();
    } catch (IllegalArgumentException e) {
      // a name that cannot be sent
      throw wrongUsage(String.valueOf(e.getMessage()));
    }
    for (Sampling.Failure failure : failures) {
      result = result.orWorse(ExitCode.of(failure.cause()));
    }
    failures.stream().map(Sampling.Failure::message).distinct().forEach(console()::error);
    return result;
  }

  /** Samples until it ends, and returns {@link ExitCode#LOST} if it ended without a connection. */
  static ExitCode run(
      Sampling sampling, boolean changesOnly, StopSignal stop, Sampling.Listener listener)
      throws IOException {
    return sampling.run(changesOnly, stop::isStopped, listener) ? ExitCode.LOST : ExitCode.DONE;
  }

  /** Checks the rules that picocli does not check. */
  private void check() {
    checkNames(names);
    if (period.compareTo(MAX_PERIOD) > 0) {
      throw wrongUsage("--period must be at most a day, is " + period.toHours() + " h");
    }
    if (count != null && count < 1) {
      throw wrongUsage("--count must be 1 or more, is " + count);
    }
  }
}
