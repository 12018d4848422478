package no.hials.crosscom.lab.experiment;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.Trace;
import no.hials.crosscom.lab.plot.Chart;
import no.hials.crosscom.lab.plot.Panel;
import no.hials.crosscom.lab.plot.Quantity;
import no.hials.crosscom.lab.plot.Series;
import no.hials.crosscom.simulator.KrlPrograms;

/**
 * Draws a figure by one kind of control.
 *
 * @param control the kind of control
 * @param shape the figure
 */
record FollowShape(ControlMethod control, Shape shape) implements Experiment {
  private static final int HEIGHT = 1080;

  @Override
  public String name() {
    return control.label() + "-" + figure();
  }

  private String figure() {
    return shape.name().toLowerCase(Locale.ROOT);
  }

  @Override
  public String description() {
    return "A "
        + figure()
        + " by the "
        + control.quantity()
        + ": "
        + control.program()
        + " and "
        + control.program().target().name()
        + ".";
  }

  @Override
  public Settings usual() {
    return Settings.OF_THE_PAPERS;
  }

  @Override
  public Optional<ExperimentResult> run(Settings settings, CycleObserver observer)
      throws ControlRefusedException, IOException {
    Run run =
        Run.of(
            "",
            settings,
            observer,
            KrlPrograms.START,
            control.program(),
            control.law(shape, settings.lapSeconds()));
    return run == null ? Optional.empty() : Optional.of(result(run, settings));
  }

  private ExperimentResult result(Run run, Settings settings) {
    List<Trace.Cycle> cycles = run.cycles();
    double[] errors = Plots.values(cycles, cycle -> error(cycle, settings));
    return new ExperimentResult(
        List.of(run),
        ErrorMetrics.figures("tracking error", control.unit(), errors),
        new Chart(settings.title(name() + ": " + control.program()), panels(cycles, settings), 2),
        HEIGHT);
  }

  private Shape.Point desired(Trace.Cycle cycle, Settings settings) {
    return control.desired(shape, cycle.time() / settings.lapSeconds());
  }

  private double error(Trace.Cycle cycle, Settings settings) {
    Shape.Point desired = desired(cycle, settings);
    int first = control.firstCoordinate();
    return Math.hypot(
        cycle.actual().get(first) - desired.u(), cycle.actual().get(first + 1) - desired.v());
  }

  private List<Panel> panels(List<Trace.Cycle> cycles, Settings settings) {
    int first = control.firstCoordinate();
    String right = control.name(first);
    String up = control.name(first + 1);
    ToDoubleFunction<Trace.Cycle> desiredRight = cycle -> desired(cycle, settings).u();
    ToDoubleFunction<Trace.Cycle> desiredUp = cycle -> desired(cycle, settings).v();
    ToDoubleFunction<Trace.Cycle> actualRight = cycle -> cycle.actual().get(first);
    ToDoubleFunction<Trace.Cycle> actualUp = cycle -> cycle.actual().get(first + 1);
    return List.of(
        Panel.of(
            "path",
            new Quantity(right, control.unit()),
            new Quantity(up, control.unit()),
            Panel.Scale.EQUAL,
            List.of(
                path("desired", cycles, desiredRight, desiredUp),
                path("actual", cycles, actualRight, actualUp))),
        Plots.overTime(
            "tracking error",
            new Quantity("distance", control.unit()),
            List.of(Plots.line("", cycles, cycle -> error(cycle, settings)))),
        Plots.overTime(
            right,
            new Quantity(right, control.unit()),
            List.of(
                Plots.line("desired", cycles, desiredRight),
                Plots.line("actual", cycles, actualRight))),
        Plots.overTime(
            up,
            new Quantity(up, control.unit()),
            List.of(
                Plots.line("desired", cycles, desiredUp), Plots.line("actual", cycles, actualUp))),
        Plots.overTime(
            "sent: " + control.program().target().name(),
            new Quantity("increment", control.unit()),
            List.of(
                Plots.line(right, cycles, cycle -> cycle.sent().get(first)),
                Plots.line(up, cycles, cycle -> cycle.sent().get(first + 1)))),
        Plots.accessTimes(cycles, settings.period()));
  }

  private static Series path(
      String name,
      List<Trace.Cycle> cycles,
      ToDoubleFunction<Trace.Cycle> right,
      ToDoubleFunction<Trace.Cycle> up) {
    return Series.of(
        name, Series.Style.LINE, Plots.values(cycles, right), Plots.values(cycles, up));
  }
}
