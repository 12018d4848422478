package no.hials.crosscom.cli.variables;

import java.io.IOException;
import java.util.Map;
import no.hials.crosscom.ConnectionEvent;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.cell.SampledRobot;
import no.hials.crosscom.cell.Sampling;
import no.hials.crosscom.cell.TimeText;
import no.hials.crosscom.cell.recording.SampleJson;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.cli.base.Screen;
import no.hials.crosscom.cli.base.StopSignal;
import no.hials.crosscom.cli.base.Terminal;
import no.hials.crosscom.protocol.value.KrlValue;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code watch}. */
@Command(
    name = "watch",
    description = {
      "Shows the values of variables until Ctrl-C: as a table on a terminal, otherwise as lines.",
      "There is one line TIME NAME = VALUE for each sample of each variable."
    },
    footer = {
      "",
      "The table has one row for each number or text, with its last change and the age of its"
          + " value. The lines below the table show the access time and the number of missed"
          + " periods. Press q or Ctrl-C to quit; the exit code is then 0, also after SIGTERM."
          + " With --verbose, in the background, or if TERM is dumb, lines are printed instead of"
          + " a table. NO_COLOR=1 disables colours.",
      "",
      "All variables must be readable at the start. After a lost connection, the command"
          + " reconnects; if --for or --count ends it before that, the exit code is 4. Lines of"
          + " several robots are in the order of their times, except with --changes.",
      "",
      "JSON: one object per sample (JSON Lines) with time; seconds since the first sample of all"
          + " robots; robot, if it has a name; access_ms, the duration of the reading; missed,"
          + " the number of periods skipped before it because a reading took too long; failed,"
          + " the number of failed readings before it; values by name, in the form of 'read"
          + " --json'; errors by name, for variables that could not be read; changed, the names"
          + " of changed variables.",
      "",
      "Quoting: a shell replaces $NAME and [ ] patterns, so put names in single quotes.",
      "",
      "Examples:",
      "  jopenshowvar watch '$POS_ACT' '$OV_PRO' --host 172.31.1.147",
      "  jopenshowvar watch '$IN[1]' '$MODE_OP' --changes --mock | tee changes.txt",
      "  jopenshowvar watch '$AXIS_ACT' --period 20ms --count 50 --json --mock"
    })
public final class WatchCommand extends SamplingCommand {
  @Option(names = "--changes", description = "Print only variables that have changed.")
  private boolean changes;

  @Option(names = "--json", order = 5, description = "Print JSON, see below.")
  private boolean json;

  @Override
  public ExitCode run() throws IOException {
    try (StopSignal stop = new StopSignal();
        Sampling sampling = sampling()) {
      ExitCode first = readFirst(sampling);
      if (first != ExitCode.DONE) {
        return first;
      }
      boolean table = !json && !isVerbose() && Terminal.isInteractive() && Terminal.isForeground();
      Screen screen = table ? Screen.open(console()) : null;
      return screen == null
          ? run(sampling, changes, stop, json ? new Json(sampling) : new Lines())
          : show(screen, sampling, stop);
    }
  }

  private ExitCode show(Screen screen, Sampling sampling, StopSignal stop) throws IOException {
    WatchTable table = new WatchTable(sampling.robots());
    ExitCode result;
    try (screen) {
      result = run(sampling, changes, stop, new OnScreen(table, screen));
    }
    // the former screen is back; the last table stays visible
    table.text().forEach(console()::print);
    return result;
  }

  /** Reports connections on stderr. */
  private abstract class Printed implements Sampling.Listener {
    @Override
    public final void connectionChanged(SampledRobot robot, ConnectionEvent event) {
      if (event.kind() == ConnectionChange.LOST || event.kind() == ConnectionChange.RECONNECTED) {
        console().error(robot.label() + SampledRobot.text(event));
      }
    }

    @Override
    public final boolean tick() {
      return true;
    }
  }

  /** Prints a line for each variable. */
  private final class Lines extends Printed {
    @Override
    public void sampled(SampledRobot robot, Sample sample) {
      String time = TimeText.instant(sample.time());
      for (Map.Entry<String, Reading> entry : sample.readings().entrySet()) {
        String name = entry.getKey();
        boolean changed = sample.changed().contains(name);
        KrlValue value = entry.getValue().value();
        CrossComException failure = entry.getValue().failure();
        if (value != null && (changed || !changes)) {
          console().print(time + " " + robot.qualified(name) + " = " + value.print());
        } else if (failure != null && changed) {
          console().error(robot.label() + failure.getMessage());
        }
      }
    }
  }

  /** Prints a line for each sample. */
  private final class Json extends Printed {
    private final Sampling sampling;

    Json(Sampling sampling) {
      this.sampling = sampling;
    }

    @Override
    public void sampled(SampledRobot robot, Sample sample) {
      console().print(SampleJson.of(robot, sample, sampling.since(sample.time())));
    }
  }

  /** Shows a table. */
  private record OnScreen(WatchTable table, Screen screen) implements Sampling.Listener {
    @Override
    public void sampled(SampledRobot robot, Sample sample) {
      table.add(robot, sample);
    }

    @Override
    public void connectionChanged(SampledRobot robot, ConnectionEvent event) {
      table.connectionChanged(robot, event);
    }

    @Override
    public boolean tick() throws IOException {
      screen.show(table::lines);
      return !screen.isLeft();
    }
  }
}
