package no.hials.crosscom.lab.experiment;

import java.util.List;
import no.hials.crosscom.lab.plot.Chart;

/**
 * What came out of an experiment.
 *
 * @param runs what its loops have done, at least one
 * @param figures what was computed of them
 * @param chart the picture
 * @param height how high the picture is to be if it is 1000 pixels wide
 */
public record Outcome(List<Run> runs, List<Figure> figures, Chart chart, int height) {

  /** Keeps copies of the lists. */
  public Outcome {
    runs = List.copyOf(runs);
    figures = List.copyOf(figures);
  }

  /**
   * One number.
   *
   * @param name what it is
   * @param value how much
   * @param unit its unit, empty if it is a count
   */
  public record Figure(String name, double value, String unit) {}
}
