package no.hials.crosscom.lab.experiment;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import no.hials.crosscom.control.Trace;
import no.hials.crosscom.lab.plot.Panel;
import no.hials.crosscom.lab.plot.Quantity;
import no.hials.crosscom.lab.plot.Series;

/** Creates the panels that several experiments share. */
final class Plots {
  static final Quantity TIME = new Quantity("time", "s");
  private static final double LONGEST_SHOWN = 25;
  private static final double BIN = 0.5;

  private Plots() {}

  /** Returns a number for each cycle. */
  static double[] values(List<Trace.Cycle> cycles, ToDoubleFunction<Trace.Cycle> value) {
    return cycles.stream().mapToDouble(value).toArray();
  }

  static double[] times(List<Trace.Cycle> cycles) {
    return values(cycles, Trace.Cycle::time);
  }

  static Series line(String name, List<Trace.Cycle> cycles, ToDoubleFunction<Trace.Cycle> value) {
    return Series.of(name, Series.Style.LINE, times(cycles), values(cycles, value));
  }

  static Panel overTime(String title, Quantity y, List<Series> series) {
    return Panel.of(title, TIME, y, Panel.Scale.FREE, series);
  }

  /** Returns a panel of the read and write times of each cycle, with the period. */
  static Panel accessTimes(List<Trace.Cycle> cycles, Duration period) {
    double[] ends = {0, cycles.isEmpty() ? 0 : cycles.get(cycles.size() - 1).time()};
    double dt = period.toNanos() / 1e6;
    return overTime(
        "access times of each cycle",
        new Quantity("time of the access", "ms"),
        List.of(
            Series.of("period", Series.Style.GUIDE, ends, new double[] {dt, dt}),
            line("reading", cycles, Trace.Cycle::read),
            line("writing", cycles, Trace.Cycle::write)));
  }

  /** Returns a histogram of the read and write times. */
  static Panel accessHistogram(List<Trace.Cycle> cycles) {
    List<Series> series = new ArrayList<>();
    series.add(histogram("reading", values(cycles, Trace.Cycle::read)));
    series.add(histogram("writing", values(cycles, Trace.Cycle::write)));
    return Panel.of(
        "how often an access took how long",
        new Quantity("time of the access", "ms"),
        new Quantity("cycles", ""),
        Panel.Scale.FREE,
        series);
  }

  /** Returns a histogram; values beyond the axis count in the last bin. */
  static Series histogram(String name, double... values) {
    long[] counts = new long[(int) (LONGEST_SHOWN / BIN)];
    for (double value : values) {
      counts[Math.min(counts.length - 1, (int) (value / BIN))]++;
    }
    return Series.histogram(name, 0, BIN, counts);
  }
}
