package no.hials.crosscom.lab.plot;

import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;

/** Draws a series, and its sample in the legend. */
final class SeriesPainter {
  /** The size of a mark in pixels. */
  private static final int MARK = 7;

  /** The size of the dot of a point between two gaps, in pixels. */
  private static final int DOT = 4;

  /** A line leaves out points nearer than this to the previous point, in pixels. */
  private static final double NEAR = 0.2;

  private final Series series;
  private final Look look;
  private final Graphics2D g;
  private final AffineTransform toScreen;

  private SeriesPainter(Series series, Look look, Graphics2D g, AffineTransform toScreen) {
    this.series = series;
    this.look = look;
    this.g = g;
    this.toScreen = toScreen;
  }

  static void paint(Series series, Look look, Graphics2D g, AffineTransform toScreen) {
    SeriesPainter painter = new SeriesPainter(series, look, g, toScreen);
    g.setColor(look.color());
    g.setStroke(look.stroke());
    switch (series.style()) {
      case POINTS -> painter.paintPoints();
      case AREA -> painter.paintArea();
      case LINE, GUIDE -> painter.paintLine();
    }
  }

  /** Draws a sample of a style for the legend. */
  static void paintSample(
      Series.Style style, Look look, Graphics2D g, double x, double y, int width) {
    double[] xs = {x, x + width};
    double[] ys = {y, y};
    if (style == Series.Style.AREA) {
      g.setColor(look.fill());
      g.fill(new Rectangle2D.Double(x, y - 5, width, 10));
      ys = new double[] {y - 5, y - 5};
    } else if (style == Series.Style.POINTS) {
      xs = new double[] {x + width / 2.0};
      ys = new double[] {y};
    }
    Series.Style shown = style == Series.Style.AREA ? Series.Style.LINE : style;
    paint(Series.of("", shown, xs, ys), look, g, new AffineTransform());
  }

  private Point2D point(int i) {
    return toScreen.transform(new Point2D.Double(series.x(i), series.y(i)), null);
  }

  private void paintPoints() {
    for (int i = 0; i < series.size(); i++) {
      if (!series.isGap(i)) {
        Point2D point = point(i);
        look.marker().paint(g, point.getX(), point.getY(), MARK);
      }
    }
  }

  private void paintArea() {
    Path2D outline = line();
    Path2D area = new Path2D.Double(outline);
    Range range = series.xRange();
    Point2D right = toScreen.transform(new Point2D.Double(range.max(), 0), null);
    Point2D left = toScreen.transform(new Point2D.Double(range.min(), 0), null);
    area.lineTo(right.getX(), right.getY());
    area.lineTo(left.getX(), left.getY());
    area.closePath();
    g.setColor(look.fill());
    g.fill(area);
    g.setColor(look.color());
    g.draw(outline);
  }

  private void paintLine() {
    g.draw(line());
  }

  /** Returns the line with its gaps; a single point between two gaps becomes a dot. */
  private Path2D line() {
    Path2D line = new Path2D.Double();
    for (int i = 0; i < series.size(); i++) {
      if (series.isGap(i)) {
        continue;
      }
      Point2D point = point(i);
      boolean begins = i == 0 || series.isGap(i - 1);
      boolean ends = i + 1 == series.size() || series.isGap(i + 1);
      if (begins && ends) {
        look.dot().paint(g, point.getX(), point.getY(), DOT);
      } else if (begins) {
        line.moveTo(point.getX(), point.getY());
      } else if (ends || point.distance(line.getCurrentPoint()) >= NEAR) {
        line.lineTo(point.getX(), point.getY());
      }
    }
    return line;
  }
}
