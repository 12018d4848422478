package no.hials.crosscom.lab.plot;

import java.util.List;

/**
 * A plot with a pair of axes; a {@link Chart} has one or several.
 *
 * @param title what stands above it; empty for none
 * @param x the axis to the right
 * @param y the axis upwards
 * @param series what it shows, the first one at the back
 * @param labels texts in it
 * @param scale how the axes go together
 */
public record Panel(
    String title, Axis x, Axis y, List<Series> series, List<Label> labels, Scale scale) {

  /** How the axes of a panel go together. */
  public enum Scale {
    /** Each axis as the data need it; panels with the same x axis have the same range there. */
    FREE,
    /** Both have the same scale, so that a circle is round. */
    EQUAL,
    /** As {@link #EQUAL}, and no axes are drawn. */
    VIEW
  }

  /**
   * A text in a panel.
   *
   * @param text what to write
   * @param x where its centre is
   * @param y where its centre is
   */
  public record Label(String text, double x, double y) {}

  /** Keeps copies of the lists. */
  public Panel {
    series = List.copyOf(series);
    labels = List.copyOf(labels);
  }

  /**
   * Creates a panel without texts.
   *
   * @param title what stands above it; empty for none
   * @param x the axis to the right
   * @param y the axis upwards
   * @param scale how the axes go together
   * @param series what it shows
   * @return the panel
   */
  public static Panel of(String title, Axis x, Axis y, Scale scale, List<Series> series) {
    return new Panel(title, x, y, series, List.of(), scale);
  }

  Range xRange() {
    return series.stream().map(Series::xRange).reduce(Range.EMPTY, Range::with);
  }

  Range yRange() {
    return series.stream().map(Series::yRange).reduce(Range.EMPTY, Range::with);
  }
}
