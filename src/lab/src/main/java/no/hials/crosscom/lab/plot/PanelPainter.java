package no.hials.crosscom.lab.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * Draws the plot of a panel: XChart draws the axes, this class draws the series. XChart draws a
 * line piece by piece, so that dashes restart at each point and an SVG becomes long.
 */
final class PanelPainter {
  /** The minimum width within the axes, and the minimum distance of ticks, in pixels. */
  private static final int MIN_PLOT = 40;

  private static final BasicStroke THIN = new BasicStroke(1);

  private final Panel panel;
  private final int width;
  private final int height;
  private final boolean xTitle;
  private Range x;
  private Range y;
  private int axisWidth;

  /**
   * Creates a painter.
   *
   * @param xTitle whether the x axis is named
   */
  PanelPainter(Panel panel, Range x, Range y, int width, int height, boolean xTitle) {
    this.panel = panel;
    this.x = x;
    this.y = y;
    this.width = width;
    this.height = height;
    this.xTitle = xTitle;
    if (panel.scale() != Panel.Scale.FREE) {
      makeScalesEqual();
    }
  }

  /** Returns the width of the area left of the plot. */
  double axisWidth() {
    return laidOut().getYAxisLeftWidth();
  }

  void setAxisWidth(double newWidth) {
    axisWidth = (int) Math.ceil(newWidth);
    if (panel.scale() != Panel.Scale.FREE) {
      makeScalesEqual();
    }
  }

  /** Returns by how many pixels the plot is too narrow; 0 if it is wide enough. */
  int missingWidth() {
    return (int) Math.max(0, Math.ceil(MIN_PLOT - plot(laidOut()).getWidth()));
  }

  void paint(Graphics2D g) {
    XYChart chart = xyChart();
    chart.paint(g, width, height);
    Rectangle2D plot = plot(chart);
    AffineTransform toScreen = AffineTransform.getTranslateInstance(plot.getX(), plot.getMaxY());
    toScreen.scale(plot.getWidth() / x.span(), -plot.getHeight() / y.span());
    toScreen.translate(-x.min(), -y.min());
    Shape clip = g.getClip();
    g.setClip(plot);
    List<Look> looks = Legend.looks(panel);
    for (int i = 0; i < looks.size(); i++) {
      SeriesPainter.paint(panel.series().get(i), looks.get(i), g, toScreen);
    }
    g.setClip(clip);
    for (Panel.PanelText label : panel.labels()) {
      double[] at = {label.x(), label.y()};
      toScreen.transform(at, 0, at, 0, 1);
      double half = Typeface.width(label.text(), Typeface.HEADING) / 2;
      Typeface.draw(g, label.text(), Typeface.HEADING, Look.INK, at[0] - half, at[1] + 5);
    }
  }

  /** Widens the range of the axis with more pixels per unit. */
  private void makeScalesEqual() {
    Rectangle2D plot = plot(laidOut());
    double plotWidth = Math.max(MIN_PLOT, plot.getWidth());
    double unit = Math.max(x.span() / plotWidth, y.span() / plot.getHeight());
    x = x.ofSpan(unit * plotWidth);
    y = y.ofSpan(unit * plot.getHeight());
  }

  /** Returns the area within the axes of a drawn chart. */
  private Rectangle2D plot(XYChart chart) {
    // in a plot lower or narrower than this hint, XChart reports no positions
    chart.getStyler().setXAxisTickMarkSpacingHint(1);
    double left = chart.getScreenXFromChart(x.min());
    double top = chart.getScreenYFromChart(y.max());
    return new Rectangle2D.Double(
        left,
        top,
        chart.getScreenXFromChart(x.max()) - left,
        chart.getScreenYFromChart(y.min()) - top);
  }

  /** Returns the chart after a first drawing, which computes the layout. */
  private XYChart laidOut() {
    XYChart chart = xyChart();
    Graphics2D g = Format.image(new Chart.Size(300, 200)).createGraphics();
    try {
      chart.paint(g, width, height);
    } finally {
      g.dispose();
    }
    return chart;
  }

  private XYChart xyChart() {
    boolean axes = panel.scale() != Panel.Scale.VIEW;
    XYChart chart =
        new XYChartBuilder()
            .width(width)
            .height(height)
            .xAxisTitle(axes && xTitle ? panel.x().label() : "")
            .yAxisTitle(axes ? panel.y().label() : "")
            .build();
    style(chart.getStyler(), axes);
    XYSeries frame = chart.addSeries("frame", spread(x), spread(y));
    frame.setLineStyle(SeriesLines.NONE);
    frame.setMarker(SeriesMarkers.NONE);
    return chart;
  }

  /**
   * Returns the points of a series that XChart needs to draw axes. XChart would put its ticks at
   * equally spaced points.
   */
  private static double[] spread(Range range) {
    return new double[] {range.min(), range.min() + range.span() / 3, range.max()};
  }

  private void style(XYStyler styler, boolean axes) {
    styler.setLocale(Locale.ROOT);
    styler.setDecimalPattern("0.#########");
    styler.setBaseFont(Typeface.TEXT);
    styler.setChartBackgroundColor(Color.WHITE);
    styler.setChartFontColor(Look.INK);
    styler.setChartPadding(2);
    styler.setChartTitleVisible(false);
    styler.setLegendVisible(false);
    styler.setPlotBackgroundColor(Color.WHITE);
    styler.setPlotBorderColor(axes ? Color.GRAY : Look.GRID);
    styler.setPlotContentSize(1);
    styler.setAxisTitleFont(Typeface.TEXT);
    styler.setAxisTickLabelsFont(Typeface.TEXT);
    styler.setAxisTickLabelsColor(Look.INK);
    styler.setAxisTickMarksColor(Color.GRAY);
    styler.setAxisTicksVisible(axes);
    styler.setAxisTitlesVisible(axes);
    styler.setPlotGridLinesVisible(axes);
    styler.setPlotGridLinesColor(Look.GRID);
    styler.setPlotGridLinesStroke(THIN);
    styler.setPlotMargin(0);
    // XChart may space ticks at two thirds of the hint, where longer numbers would touch
    styler.setXAxisTickMarkSpacingHint(Math.max(MIN_PLOT, width / 12));
    styler.setYAxisTickMarkSpacingHint(MIN_PLOT);
    styler.setXAxisMin(x.min());
    styler.setXAxisMax(x.max());
    styler.setYAxisMin(y.min());
    styler.setYAxisMax(y.max());
    styler.setXAxisTitleVisible(axes && xTitle);
    styler.setYAxisLeftWidthHint(axisWidth);
  }
}
