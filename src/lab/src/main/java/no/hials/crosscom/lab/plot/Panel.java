package no.hials.crosscom.lab.plot;

import java.util.List;

/**
 * A plot with a pair of axes, part of a {@link Chart}.
 *
 * @param title the title above it; empty for no title
 * @param x the axis to the right
 * @param y the axis upwards
 * @param series the series, the first one at the back
 * @param labels the texts in it
 * @param scale how the scales of the axes relate
 */
public record Panel(
    String title,
    Quantity x,
    Quantity y,
    List<Series> series,
    List<PanelText> labels,
    Scale scale) {

  /** How the scales of the two axes relate. */
  public enum Scale {
    /** Each axis fits its data; panels with the same x axis share its range. */
    FREE,
    /** Both axes have the same scale, so that a circle is round. */
    EQUAL,
    /** Like {@link #EQUAL}, without drawn axes. */
    VIEW
  }

  /**
   * A text in a panel.
   *
   * @param text the text
   * @param x the x coordinate of its centre
   * @param y the y coordinate of its centre
   */
  public record PanelText(String text, double x, double y) {}

  /** Keeps copies of the lists. */
  public Panel {
    series =
        scale == Scale.FREE
            ? List.copyOf(series)
            : series.stream().map(Series::withOneScale).toList();
    labels = List.copyOf(labels);
  }

  /**
   * Creates a panel without labels.
   *
   * @param title the title above it; empty for no title
   * @param x the axis to the right
   * @param y the axis upwards
   * @param scale how the scales of the axes relate
   * @param series the series, the first one at the back
   * @return the panel
   */
  public static Panel of(String title, Quantity x, Quantity y, Scale scale, List<Series> series) {
    return new Panel(title, x, y, series, List.of(), scale);
  }

  /** Returns a text about the values that are not shown; empty if there are none. */
  String leftOut() {
    return Series.leftOut(series);
  }

  Range xRange() {
    return series.stream().map(Series::xRange).reduce(Range.EMPTY, Range::with);
  }

  Range yRange() {
    return series.stream().map(Series::yRange).reduce(Range.EMPTY, Range::with);
  }
}
