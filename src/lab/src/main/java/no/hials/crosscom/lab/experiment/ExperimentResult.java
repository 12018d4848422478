package no.hials.crosscom.lab.experiment;

import java.util.List;
import no.hials.crosscom.lab.plot.Chart;

/**
 * The outcome of an experiment.
 *
 * @param runs the runs of its loops, at least one
 * @param figures the figures computed from the runs
 * @param chart the chart
 * @param height the height of a picture that is 1000 pixels wide, in pixels
 */
public record ExperimentResult(List<Run> runs, List<Figure> figures, Chart chart, int height) {

  /** Keeps copies of the lists. */
  public ExperimentResult {
    runs = List.copyOf(runs);
    figures = List.copyOf(figures);
  }

  /**
   * A computed number.
   *
   * @param name its name
   * @param value its value
   * @param unit its unit; empty for a count
   */
  public record Figure(String name, double value, String unit) {}
}
