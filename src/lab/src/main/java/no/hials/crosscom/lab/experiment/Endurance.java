package no.hials.crosscom.lab.experiment;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.State;
import no.hials.crosscom.control.Trace;
import no.hials.crosscom.lab.plot.Chart;
import no.hials.crosscom.lab.plot.Panel;
import no.hials.crosscom.lab.plot.Quantity;
import no.hials.crosscom.lab.plot.Series;
import no.hials.crosscom.simulator.KrlPrograms;

/**
 * Draws circles for a long time with the shortest useful period, and finds the cause of each missed
 * cycle.
 */
final class Endurance implements Experiment {
  private static final ControlMethod CONTROL = ControlMethod.POSITION;
  private static final int HEIGHT = 800;

  @Override
  public String name() {
    return "endurance";
  }

  @Override
  public String description() {
    return "Circles for 10 minutes with a period of 12 ms, and the cause of each missed cycle.";
  }

  @Override
  public Settings usual() {
    return new Settings(
        Duration.ofMinutes(10),
        Duration.ofSeconds(10),
        Duration.ofMillis(12),
        Duration.ofMillis(12),
        "krc4");
  }

  @Override
  public Optional<ExperimentResult> run(Settings settings, CycleObserver observer)
      throws ControlRefusedException, IOException {
    try (GarbageCollections pauses = new GarbageCollections()) {
      Law.CartesianPosition circles =
          (Law.CartesianPosition) CONTROL.law(Shape.CIRCLE, settings.lapSeconds());
      Law standing = Law.cartesianPosition(state -> circles.position(beforeStart(state)));
      Law law =
          Law.cartesianPosition(
              state -> {
                pauses.begin();
                return circles.position(state);
              });
      Run run = Run.of("", settings, observer, KrlPrograms.START, CONTROL.program(), standing, law);
      if (run == null) {
        return Optional.empty();
      }
      // the first call of the law follows the first reading
      List<GarbageCollections.Pause> seen = pauses.seen(run.cycles().get(0).read() / 1e3);
      MissedCycles misses = MissedCycles.of(run.cycles(), seen, settings.period());
      return Optional.of(
          new ExperimentResult(
              List.of(run), figures(misses, seen), chart(run, seen, settings), HEIGHT));
    }
  }

  /** Returns the state whose set point is the start position. */
  private static State beforeStart(State state) {
    return new State(
        -state.period(),
        state.period(),
        state.axes(),
        state.position(),
        state.incrementFactor(),
        state.input());
  }

  private static List<ExperimentResult.Figure> figures(
      MissedCycles misses, List<GarbageCollections.Pause> pauses) {
    double[] lengths = pauses.stream().mapToDouble(pause -> pause.length() * 1e3).toArray();
    double sum = 0;
    for (double length : lengths) {
      sum += length;
    }
    return List.of(
        new ExperimentResult.Figure(
            "missed, the accesses left less than 0.2 ms of the period", misses.byAccess(), ""),
        new ExperimentResult.Figure(
            "missed, woken too late by the computer for the accesses", misses.byWaking(), ""),
        new ExperimentResult.Figure("missed, garbage collection", misses.byCollection(), ""),
        new ExperimentResult.Figure("missed, anything else", misses.byOther(), ""),
        new ExperimentResult.Figure("garbage collections", lengths.length, ""),
        new ExperimentResult.Figure("garbage collections, together", sum, "ms"),
        new ExperimentResult.Figure(
            "garbage collections, longest", ErrorMetrics.maximum(lengths), "ms"));
  }

  private static Chart chart(Run run, List<GarbageCollections.Pause> pauses, Settings settings) {
    List<Trace.Cycle> cycles = run.cycles();
    List<Series> series = new ArrayList<>();
    series.add(
        Series.of(
            "period",
            Series.Style.POINTS,
            Plots.times(cycles),
            Plots.values(cycles, Trace.Cycle::period)));
    series.add(
        Series.of(
            "reading and writing",
            Series.Style.POINTS,
            Plots.times(cycles),
            Plots.values(cycles, cycle -> cycle.read() + cycle.write())));
    series.add(
        Series.of(
            "garbage collection",
            Series.Style.POINTS,
            pauses.stream().mapToDouble(GarbageCollections.Pause::begin).toArray(),
            pauses.stream().mapToDouble(pause -> pause.length() * 1e3).toArray()));
    Panel histogram = Plots.accessHistogram(cycles);
    return Chart.stacked(
        settings.title("endurance: circles by ACTUATOR"),
        List.of(Plots.overTime("each cycle", new Quantity("time", "ms"), series), histogram));
  }
}
