package no.hials.crosscom.lab.plot;

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

  private final String name;
  private final Style style;
  private final double[] x;
  private final double[] y;

  private Series(String name, Style style, double[] x, double[] y) {
    if (x.length != y.length) {
      throw new IllegalArgumentException(
          "a series must have as many x as y, has " + x.length + " and " + y.length);
    }
    this.name = name;
    this.style = style;
    this.x = x.clone();
    this.y = y.clone();
  }

  /**
   * Creates a series.
   *
   * @param name its name in the legend; empty to leave it out of the legend
   * @param style how it is drawn
   * @param x the x coordinates of its points
   * @param y the y coordinates, as many; the line has a gap where x or y is NaN
   * @return the series
   */
  public static Series of(String name, Style style, double[] x, double[] y) {
    return new Series(name, style, x, y);
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
    return new Series(name, Style.AREA, x, y);
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
    return !Double.isFinite(x[i]) || !Double.isFinite(y[i]);
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
