package no.hials.crosscom.lab.plot;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import no.hials.crosscom.cell.Printable;

/** Points that belong together, and how they are drawn. Immutable. */
public final class Series {
  /** How a series is drawn. */
  public enum Style {
    /** A coloured line from point to point. */
    LINE,
    /** A mark at each point. */
    POINTS,
    /** The area between a line and zero. */
    AREA,
    /** A thin grey line that helps to read the others. */
    GUIDE
  }

  /** The largest number that is drawn. XChart does not end for numbers beyond a long. */
  private static final double MAX = 1e15;

  /** The same for x, which may be nanoseconds since 1970, unless both axes have one scale. */
  private static final double MAX_X = 2e18;

  private final String name;
  private final Style style;
  private final double[] x;
  private final double[] y;

  private final double maxX;

  private Series(String name, Style style, double[] x, double[] y, double maxX) {
    if (x.length != y.length) {
      throw new IllegalArgumentException(
          "a series must have as many x as y, has " + x.length + " and " + y.length);
    }
    this.name = name;
    this.style = style;
    this.x = x.clone();
    this.y = y.clone();
    this.maxX = maxX;
  }

  /**
   * Creates a series.
   *
   * @param name its name in the legend; empty to leave it out of the legend
   * @param style how it is drawn
   * @param x the x coordinates of its points
   * @param y the y coordinates, as many; the line has a gap where x or y is NaN. Numbers that are
   *     infinite, or too large for an axis, are gaps as well; the picture has their count.
   * @return the series
   */
  public static Series of(String name, Style style, double[] x, double[] y) {
    return new Series(name, style, x, y, MAX_X);
  }

  /**
   * Creates a histogram: an area with a step for each bin.
   *
   * @param name its name in the legend
   * @param start the start of the first bin
   * @param width the width of each bin
   * @param counts the count of each bin
   * @return the series
   */
  public static Series histogram(String name, double start, double width, long... counts) {
    double[] x = new double[2 * counts.length + 2];
    double[] y = new double[x.length];
    for (int i = 0; i <= counts.length; i++) {
      x[2 * i] = start + i * width;
      x[2 * i + 1] = x[2 * i];
      y[2 * i] = i == 0 ? 0 : counts[i - 1];
      y[2 * i + 1] = i == counts.length ? 0 : counts[i];
    }
    return new Series(name, Style.AREA, x, y, MAX_X);
  }

  /** Returns the series for axes of one scale. */
  Series withOneScale() {
    return new Series(name, style, x, y, MAX);
  }

  public String name() {
    return name;
  }

  Style style() {
    return style;
  }

  public int size() {
    return x.length;
  }

  double x(int i) {
    return x[i];
  }

  double y(int i) {
    return y[i];
  }

  boolean isGap(int i) {
    return !(Math.abs(x[i]) <= maxX && isShown(y[i]));
  }

  static boolean isShown(double y) {
    return Math.abs(y) <= MAX;
  }

  /** Returns a text about the points that cannot be shown; empty if there are none. */
  static String leftOut(List<Series> all) {
    List<Series> data = all.stream().filter(series -> series.style != Style.GUIDE).toList();
    Map<String, Long> counts = new TreeMap<>();
    for (Series one : data) {
      for (int i = 0; i < one.size(); i++) {
        if (one.isGap(i) && !Double.isNaN(one.x[i]) && !Double.isNaN(one.y[i])) {
          counts.merge(one.reason(i), 1L, Long::sum);
        }
      }
    }
    return counts.entrySet().stream()
        .map(
            count ->
                Printable.count(count.getValue(), "value")
                    + " "
                    + count.getKey()
                    + (count.getValue() == 1 ? " is" : " are")
                    + " not shown")
        .collect(Collectors.joining(", "));
  }

  private String reason(int i) {
    if (Double.isInfinite(x[i]) || Double.isInfinite(y[i])) {
      return "without a finite number";
    }
    return isShown(y[i]) && maxX == MAX_X ? "with x beyond 2e18" : "beyond 1e15";
  }

  /** Returns the range of x, without gaps. */
  Range xRange() {
    return range(x);
  }

  /** Returns the range of y, without gaps. */
  Range yRange() {
    Range range = range(y);
    return style == Style.AREA ? range.with(0) : range;
  }

  private Range range(double[] values) {
    Range range = Range.EMPTY;
    for (int i = 0; i < values.length; i++) {
      range = isGap(i) ? range : range.with(values[i]);
    }
    return range;
  }
}
