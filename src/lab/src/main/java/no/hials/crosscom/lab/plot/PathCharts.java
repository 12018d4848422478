package no.hials.crosscom.lab.plot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;

/** Creates charts of the path of a point. */
public final class PathCharts {
  private PathCharts() {}

  /**
   * Creates a chart of one quantity over another, such as Y over X, with start and end marked.
   *
   * @param title the title of the chart
   * @param name the name of the path in the legend
   * @param x the axis to the right
   * @param y the axis upwards; both have the same scale if they have the same unit
   * @param xs the x coordinates of the points
   * @param ys the y coordinates, as many; the path has a gap where x or y is NaN
   * @return the chart
   */
  public static Chart plane(
      String title, String name, Quantity x, Quantity y, double[] xs, double[] ys) {
    boolean same = x.unit().equals(y.unit()) && !x.unit().isEmpty();
    List<Series> series = new ArrayList<>();
    series.add(Series.of(name, Series.Style.LINE, xs, ys));
    addEnds(series, List.of(new Flat(xs, ys)));
    return Chart.stacked(
        title, List.of(Panel.of("", x, y, same ? Panel.Scale.EQUAL : Panel.Scale.FREE, series)));
  }

  /**
   * Creates a chart of paths in space: from above, from two sides, and isometric.
   *
   * @param title the title of the chart
   * @param unit the unit of the positions
   * @param tracks the paths, at least one
   * @return the chart
   */
  public static Chart space(String title, String unit, List<Track> tracks) {
    Quantity x = new Quantity("X", unit);
    Quantity y = new Quantity("Y", unit);
    Quantity z = new Quantity("Z", unit);
    return new Chart(
        title,
        List.of(
            view("from above", x, y, tracks, t -> new Flat(t.x(), t.y())),
            isometricView(tracks),
            view("from the side, along Y", x, z, tracks, t -> new Flat(t.x(), t.z())),
            view("from the front, along X", y, z, tracks, t -> new Flat(t.y(), t.z()))),
        2);
  }

  /** A track projected onto a plane. */
  private static final class Flat {
    private final double[] u;
    private final double[] v;

    Flat(double[] u, double[] v) {
      this.u = u;
      this.v = v;
    }
  }

  private static Panel view(
      String title, Quantity x, Quantity y, List<Track> tracks, Function<Track, Flat> projection) {
    return Panel.of(title, x, y, Panel.Scale.EQUAL, series(tracks, projection));
  }

  private static List<Series> series(List<Track> tracks, Function<Track, Flat> projection) {
    List<Flat> flats = tracks.stream().map(projection).toList();
    List<Series> series = new ArrayList<>();
    for (int i = 0; i < flats.size(); i++) {
      Flat flat = flats.get(i);
      series.add(Series.of(tracks.get(i).name(), Series.Style.LINE, flat.u, flat.v));
    }
    addEnds(series, flats);
    return series;
  }

  private static void addEnds(List<Series> series, List<Flat> flats) {
    List<double[]> starts = new ArrayList<>();
    List<double[]> ends = new ArrayList<>();
    for (Flat flat : flats) {
      Series line = Series.of("", Series.Style.LINE, flat.u, flat.v).withOneScale();
      int first = 0;
      int last = line.size() - 1;
      while (first < last && line.isGap(first)) {
        first++;
      }
      while (last > first && line.isGap(last)) {
        last--;
      }
      if (first <= last) {
        starts.add(new double[] {line.x(first), line.y(first)});
        ends.add(new double[] {line.x(last), line.y(last)});
      }
    }
    series.add(points("start", starts));
    series.add(points("end", ends));
  }

  private static Series points(String name, List<double[]> points) {
    return Series.of(
        name,
        Series.Style.POINTS,
        points.stream().mapToDouble(p -> p[0]).toArray(),
        points.stream().mapToDouble(p -> p[1]).toArray());
  }

  // the isometric view: X to the right and down, Y to the right and up, Z up

  private static Flat isometric(double[] x, double[] y, double[] z) {
    double[] u = new double[x.length];
    double[] v = new double[x.length];
    for (int i = 0; i < u.length; i++) {
      u[i] = (x[i] + y[i]) / Math.sqrt(2);
      v[i] = (2 * z[i] - x[i] + y[i]) / Math.sqrt(6);
    }
    return new Flat(u, v);
  }

  private static Panel isometricView(List<Track> tracks) {
    Range x = range(tracks.stream().map(t -> t.x()));
    Range y = range(tracks.stream().map(t -> t.y()));
    Range z = range(tracks.stream().map(t -> t.z()));
    List<Series> series = new ArrayList<>(series(tracks, t -> isometric(t.x(), t.y(), t.z())));
    Flat box = box(x, y, z);
    series.add(0, Series.of("", Series.Style.GUIDE, box.u, box.v));
    for (int i = 0; i < tracks.size(); i++) {
      Track track = tracks.get(i);
      double[] floor = new double[track.z().length];
      Arrays.fill(floor, z.min());
      Flat shadow = isometric(track.x(), track.y(), floor);
      String name = i == 0 ? "its shadow" : "";
      series.add(1 + i, Series.of(name, Series.Style.GUIDE, shadow.u, shadow.v));
    }
    Quantity none = new Quantity("", "");
    return new Panel("isometric", none, none, series, axisNames(x, y, z), Panel.Scale.VIEW);
  }

  private static Range range(Stream<double[]> values) {
    Range range =
        values
            .flatMapToDouble(Arrays::stream)
            .filter(Series::isShown)
            .mapToObj(v -> new Range(v, v))
            .reduce(Range.EMPTY, Range::with);
    return range.padded(0);
  }

  /** Returns the edges of the box around all tracks. */
  private static Flat box(Range x, Range y, Range z) {
    double gap = Double.NaN;
    double[] xs = {0, 1, 1, 0, 0, gap, 0, 1, 1, 0, 0, gap, 0, 0, gap, 1, 1, gap, 1, 1, gap, 0, 0};
    double[] ys = {0, 0, 1, 1, 0, gap, 0, 0, 1, 1, 0, gap, 0, 0, gap, 0, 0, gap, 1, 1, gap, 1, 1};
    double[] zs = {0, 0, 0, 0, 0, gap, 1, 1, 1, 1, 1, gap, 0, 1, gap, 0, 1, gap, 0, 1, gap, 0, 1};
    return isometric(between(x, xs), between(y, ys), between(z, zs));
  }

  private static double[] between(Range range, double... parts) {
    return Arrays.stream(parts).map(part -> range.min() + part * range.span()).toArray();
  }

  /** Returns the names of the three edges at the front. */
  private static List<Panel.PanelText> axisNames(Range x, Range y, Range z) {
    double out = -0.11 * Math.max(x.span(), Math.max(y.span(), z.span()));
    double[][] at = {
      {x.min() + x.span() / 2, y.min() + out, z.min()},
      {x.max() - out, y.min() + y.span() / 2, z.min()},
      {x.min() + out / 2, y.min() + out / 2, z.min() + z.span() / 2}
    };
    String[] names = {"X", "Y", "Z"};
    List<Panel.PanelText> labels = new ArrayList<>();
    for (int i = 0; i < names.length; i++) {
      Flat flat =
          isometric(new double[] {at[i][0]}, new double[] {at[i][1]}, new double[] {at[i][2]});
      labels.add(new Panel.PanelText(names[i], flat.u[0], flat.v[0]));
    }
    return labels;
  }
}
