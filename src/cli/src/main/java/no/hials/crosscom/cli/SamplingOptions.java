package no.hials.crosscom.cli;

import java.time.Duration;
import java.util.List;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** What to read again and again, how often, and for how long. */
final class SamplingOptions {
  private static final Duration MAX_PERIOD = Duration.ofDays(1);

  @Parameters(
      arity = "1..*",
      paramLabel = "NAME",
      description =
          "A variable, a field of it ('$POS_ACT.X'), an element ('$TORQUE_AXIS_ACT[3]') or a whole"
              + " array ('$TORQUE_AXIS_ACT[]'). Upper or lower case.")
  private List<String> names = List.of();

  @Option(
      names = "--period",
      order = 4,
      paramLabel = "TIME",
      converter = Converters.Time.class,
      description = "From one reading to the next: 20ms, 1.5s, 1m; 100ms if not given.")
  private Duration period = Duration.ofMillis(100);

  @Option(
      names = "--for",
      order = 4,
      paramLabel = "TIME",
      converter = Converters.Time.class,
      description = "Stop after this time; if not given, with Ctrl-C.")
  private @Nullable Duration length;

  @Option(
      names = "--count",
      order = 4,
      paramLabel = "NUMBER",
      description = "Stop after this many samples, of each robot if there are several.")
  private @Nullable Long count;

  /** Checks what picocli does not. */
  void check(ConsoleCommand command) {
    for (String name : names) {
      if (name.isBlank()) {
        throw command.wrongUsage(
            "a name is blank; in a shell, names with $ need single quotes: '$OV_PRO'");
      }
    }
    if (period.compareTo(MAX_PERIOD) > 0) {
      throw command.wrongUsage("--period must be at most a day, is " + period.toHours() + " h");
    }
    if (count != null && count < 1) {
      throw command.wrongUsage("--count must be 1 or more, is " + count);
    }
  }

  /** Gives the variables, each once. */
  List<String> names() {
    return names.stream().distinct().toList();
  }

  Duration period() {
    return period;
  }

  /** Gives the greatest time; null if there is none. */
  @Nullable Duration length() {
    return length;
  }

  /** Gives the greatest number of samples. */
  long count() {
    return count == null ? Long.MAX_VALUE : count;
  }
}
