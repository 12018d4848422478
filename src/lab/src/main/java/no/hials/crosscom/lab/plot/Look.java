package no.hials.crosscom.lab.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * Colour, stroke and mark of a series.
 *
 * <p>The colours are those of Okabe and Ito, which people with any colour vision can tell apart,
 * without the yellow, which is too light on white. After the last colour they repeat with dashed
 * lines.
 */
record Look(Color color, BasicStroke stroke, Marker marker) {
  static final Color INK = new Color(0x222222);
  static final Color GRID = new Color(0xDDDDDD);
  private static final Color GREY = new Color(0x666666);

  private static final Color[] COLORS = {
    new Color(0x0072B2),
    new Color(0xD55E00),
    new Color(0x009E73),
    new Color(0xCC79A7),
    new Color(0xE69F00),
    new Color(0x56B4E9),
    new Color(0x000000)
  };

  private static final float[][] DASHES = {{}, {7, 4}, {2, 3}, {9, 3, 2, 3}};

  private static final Marker[] MARKERS = {
    SeriesMarkers.CIRCLE, SeriesMarkers.SQUARE, SeriesMarkers.DIAMOND, SeriesMarkers.TRIANGLE_UP
  };

  /**
   * Returns the look of a series.
   *
   * @param index the index of the series, counted separately for guides and for all others
   */
  static Look of(Series.Style style, int index) {
    if (style == Series.Style.GUIDE) {
      return new Look(GREY, stroke(1.2f, DASHES[(index + 1) % DASHES.length]), SeriesMarkers.NONE);
    }
    float[] dashes = DASHES[index / COLORS.length % DASHES.length];
    Marker marker =
        style == Series.Style.POINTS ? MARKERS[index % MARKERS.length] : SeriesMarkers.NONE;
    Color color = COLORS[index % COLORS.length];
    return new Look(color, stroke(1.6f, dashes), marker);
  }

  /** Returns the marker of a point without neighbours. */
  Marker dot() {
    return SeriesMarkers.CIRCLE;
  }

  /** Returns the colour of an area, transparent so that the grid shows through. */
  Color fill() {
    return new Color(color.getRed(), color.getGreen(), color.getBlue(), 90);
  }

  private static BasicStroke stroke(float width, float... dashes) {
    return dashes.length == 0
        ? new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
        : new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dashes, 0);
  }
}
