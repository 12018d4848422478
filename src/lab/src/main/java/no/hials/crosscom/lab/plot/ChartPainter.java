package no.hials.crosscom.lab.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Draws a chart: its title, and its panels in rows and columns. */
final class ChartPainter {
  private static final int MARGIN = 10;
  private static final int GAP = 12;
  private static final int TITLE_HEIGHT = 34;
  private static final int MIN_PLOT_HEIGHT = 100;

  /** The margin at each end of an axis, as a fraction of its range. */
  private static final double PADDING_X = 0.01;

  private static final double PADDING_Y = 0.06;

  private final Chart chart;
  private final Chart.Size size;
  private final int columnWidth;
  private final List<Legend> legends;

  private ChartPainter(Chart chart, Chart.Size size) {
    this.chart = chart;
    this.size = size;
    int columns = chart.columns();
    this.columnWidth = (size.width() - 2 * MARGIN - (columns - 1) * GAP) / columns;
    this.legends = chart.panels().stream().map(p -> new Legend(p, columnWidth)).toList();
  }

  /**
   * Draws a chart.
   *
   * @throws IllegalArgumentException if the size is too small for its panels
   */
  static void paint(Chart chart, Graphics2D g, Chart.Size size) throws NoFontsException {
    check(chart, size);
    new ChartPainter(chart, size).paint(g);
  }

  /**
   * Checks that a chart can be drawn in a size.
   *
   * @throws IllegalArgumentException if the size is too small for its panels
   */
  static void check(Chart chart, Chart.Size size) throws NoFontsException {
    Typeface.check();
    ChartPainter painter = new ChartPainter(chart, size);
    int missing = painter.missingHeight();
    if (missing > 0) {
      throw painter.tooSmall((size.height() + missing) + " pixels high");
    }
    int needed = size.width();
    for (missing = painter.missingWidth(); missing > 0; ) {
      needed += missing;
      missing = new ChartPainter(chart, new Chart.Size(needed, size.height())).missingWidth();
    }
    if (needed > size.width()) {
      throw painter.tooSmall(needed + " pixels wide");
    }
  }

  private IllegalArgumentException tooSmall(String needed) {
    return new IllegalArgumentException(
        "a picture of "
            + size.width()
            + "x"
            + size.height()
            + " is too small for its "
            + chart.panels().size()
            + (chart.panels().size() == 1 ? " panel" : " panels")
            + ": it must be at least "
            + needed);
  }

  /** Returns by how many pixels the picture is too low; 0 if it is high enough. */
  private int missingHeight() {
    return Math.max(0, (MIN_PLOT_HEIGHT - plotHeight()) * rows());
  }

  /** Returns by how many pixels the picture is too narrow; 0 if it is wide enough. */
  private int missingWidth() {
    return chart.columns()
        * painters(plotHeight()).stream().mapToInt(PanelPainter::missingWidth).max().orElse(0);
  }

  private void paint(Graphics2D g) {
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    g.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    g.setRenderingHint(
        RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
    g.setColor(Color.WHITE);
    g.fill(new Rectangle2D.Double(0, 0, size.width(), size.height()));
    String title = Typeface.fit(chart.title(), Typeface.TITLE, size.width() - 2.0 * MARGIN);
    Typeface.draw(
        g,
        title,
        Typeface.TITLE,
        Look.INK,
        (size.width() - Typeface.width(title, Typeface.TITLE)) / 2,
        24);
    List<PanelPainter> painters = painters(plotHeight());
    double top = chart.title().isEmpty() ? MARGIN : TITLE_HEIGHT;
    for (int row = 0; row < rows(); row++) {
      for (int i = row * chart.columns(); i < rowEnd(row); i++) {
        double left = MARGIN + (i % chart.columns()) * (double) (columnWidth + GAP);
        AffineTransform before = g.getTransform();
        int header = headerHeight(row);
        g.translate(left, top + header - legends.get(i).height());
        legends.get(i).paint(g);
        g.translate(0, legends.get(i).height());
        painters.get(i).paint(g);
        g.setTransform(before);
      }
      top += headerHeight(row) + plotHeight();
    }
  }

  private int rows() {
    return (chart.panels().size() + chart.columns() - 1) / chart.columns();
  }

  private int rowEnd(int row) {
    return Math.min((row + 1) * chart.columns(), chart.panels().size());
  }

  private int headerHeight(int row) {
    int legend =
        legends.subList(row * chart.columns(), rowEnd(row)).stream()
            .mapToInt(Legend::height)
            .max()
            .orElse(0);
    return row == 0 ? legend : legend + GAP;
  }

  private int plotHeight() {
    int left = size.height() - MARGIN - (chart.title().isEmpty() ? MARGIN : TITLE_HEIGHT);
    for (int row = 0; row < rows(); row++) {
      left -= headerHeight(row);
    }
    return Math.floorDiv(left, rows());
  }

  /** Creates the painters, whose left edges are aligned in each column. */
  private List<PanelPainter> painters(int plotHeight) {
    List<PanelPainter> painters = new ArrayList<>();
    for (int i = 0; i < chart.panels().size(); i++) {
      Panel panel = chart.panels().get(i);
      painters.add(
          new PanelPainter(
              panel, xRange(panel), yRange(panel), columnWidth, plotHeight, hasXTitle(i)));
    }
    for (int column = 0; column < chart.columns(); column++) {
      double widest = 0;
      for (int i = column; i < painters.size(); i += chart.columns()) {
        widest = Math.max(widest, painters.get(i).axisWidth());
      }
      for (int i = column; i < painters.size(); i += chart.columns()) {
        painters.get(i).setAxisWidth(widest);
      }
    }
    return painters;
  }

  /** Returns the range of the x axis of a panel: shared by all panels with this axis. */
  private Range xRange(Panel panel) {
    if (panel.scale() != Panel.Scale.FREE) {
      return panel.xRange().padded(PADDING_Y);
    }
    Range common =
        chart.panels().stream()
            .filter(p -> p.scale() == Panel.Scale.FREE && p.x().equals(panel.x()))
            .map(Panel::xRange)
            .reduce(Range.EMPTY, Range::with);
    return common.padded(PADDING_X);
  }

  /** Returns the range of the y axis, which starts at zero if the smallest value is zero. */
  private static Range yRange(Panel panel) {
    Range range = panel.yRange();
    Range padded = range.padded(PADDING_Y);
    return range.min() == 0 && range.max() > 0 ? padded.fromZero() : padded;
  }

  /** Returns whether the x axis is named: not if the panel below has the same x axis. */
  private boolean hasXTitle(int i) {
    int below = i + chart.columns();
    return below >= chart.panels().size()
        || chart.panels().get(i).scale() != Panel.Scale.FREE
        || !chart.panels().get(below).x().equals(chart.panels().get(i).x());
  }
}
