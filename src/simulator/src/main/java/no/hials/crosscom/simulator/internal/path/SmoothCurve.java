package no.hials.crosscom.simulator.internal.path;

/**
 * A curve through points, over intervals of given lengths. Between two points it is a polynomial of
 * degree 5; tangent and curvature do not change abruptly at a point. Those of a point are the ones
 * of the parabola through it and its neighbours, so a point changes two intervals on each side.
 */
public final class SmoothCurve {
  /** A shorter tangent is lengthened: a sharp bend gets no cusp. Assumed. */
  private static final double SHORTEST = 0.25;

  /**
   * How far tangent and bend at a point may carry over the longer interval next to it, in the
   * larger change of the two: an abrupt change within a short interval does not swing out over a
   * long one. Assumed.
   */
  private static final double MOST_TANGENT = 3;

  private static final double MOST_BEND = 8;

  private final double[][] points;
  private final double[] lengths;
  private final boolean[] stops;

  /** First and second derivatives by the length, at the start and at the end of each interval. */
  private final double[][][] tangents;

  private final double[][][] bends;

  /**
   * Creates the curve.
   *
   * @param points the points
   * @param lengths the lengths of the intervals, above 0; an interval with 0 is not used
   * @param stops whether the curve ends at a point and another one starts there
   */
  public SmoothCurve(double[][] points, double[] lengths, boolean[] stops) {
    this(points, lengths, stops, new double[points.length][], new double[points.length][]);
  }

  /**
   * Creates a curve whose derivatives at some points are known.
   *
   * @param tangents the first derivatives by the length; null for those that are free
   * @param bends the second derivatives
   */
  public SmoothCurve(
      double[][] points, double[] lengths, boolean[] stops, double[][] tangents, double[][] bends) {
    this.points = points;
    this.lengths = lengths;
    this.stops = stops;
    this.tangents = new double[lengths.length][2][];
    this.bends = new double[lengths.length][2][];
    for (int i = 0; i < lengths.length; i++) {
      if (lengths[i] > 0) {
        derive(i, tangents, bends);
      }
    }
  }

  private void derive(int i, double[][] knownTangents, double[][] knownBends) {
    double[] mean = slope(i);
    for (int side = 0; side < 2; side++) {
      int point = i + side;
      if (!isEnd(point)) {
        boolean known = knownTangents[point] != null;
        tangents[i][side] = known ? knownTangents[point] : tangent(point);
        double[] bend = known ? knownBends[point] : bend(point);
        double change = Math.max(change(point - 1), change(point));
        bends[i][side] = atMost(MOST_BEND * change / lengths[i] / lengths[i], bend);
      }
    }
    for (int side = 0; side < 2; side++) {
      if (isEnd(i + side)) {
        double[] other = isEnd(i + 1 - side) ? mean : tangents[i][1 - side];
        // the parabola that has the tangent at the other end
        tangents[i][side] = sum(mean, 2, other, -1);
        double sign = side == 0 ? 1 : -1;
        bends[i][side] = sum(other, sign / lengths[i], tangents[i][side], -sign / lengths[i]);
      }
    }
  }

  /** Returns whether the curve starts or ends at a point. */
  public boolean isEnd(int point) {
    return point == 0 || point == lengths.length || stops[point];
  }

  private double[] slope(int i) {
    return sum(points[i + 1], 1 / lengths[i], points[i], -1 / lengths[i]);
  }

  private double[] tangent(int point) {
    double[] tangent = parabola(slope(point - 1), lengths[point - 1], slope(point), lengths[point]);
    double length = length(tangent);
    double least = SHORTEST * Math.min(length(slope(point - 1)), length(slope(point)));
    return length > 0 && length < least ? sum(tangent, least / length, tangent, 0) : tangent;
  }

  /** Returns the tangent of the parabola at the middle one of three points. */
  public static double[] parabola(double[] slope, double length, double[] next, double nextLength) {
    double both = length + nextLength;
    double[] tangent = sum(slope, nextLength / both, next, length / both);
    double change = Math.max(length(slope) * length, length(next) * nextLength);
    return atMost(MOST_TANGENT * change / Math.max(length, nextLength), tangent);
  }

  private static double[] atMost(double most, double[] vector) {
    double length = length(vector);
    return length > most ? sum(vector, most / length, vector, 0) : vector;
  }

  private double change(int interval) {
    return length(sum(points[interval + 1], 1, points[interval], -1));
  }

  private double[] bend(int point) {
    double both = lengths[point - 1] + lengths[point];
    return sum(slope(point), 2 / both, slope(point - 1), -2 / both);
  }

  public static double[] sum(double[] one, double factor, double[] other, double otherFactor) {
    double[] sum = new double[one.length];
    for (int i = 0; i < sum.length; i++) {
      sum[i] = factor * one[i] + otherFactor * other[i];
    }
    return sum;
  }

  public static double length(double[] vector) {
    double sum = 0;
    for (double part : vector) {
      sum += part * part;
    }
    return Math.sqrt(sum);
  }

  /** Returns the value at a part of an interval. */
  public double[] at(int interval, double part) {
    double[] from = points[interval];
    double[] to = points[interval + 1];
    double h = lengths[interval];
    if (h == 0) {
      return sum(from, 1 - part, to, part);
    }
    double u = part;
    double u3 = u * u * u;
    double u4 = u3 * u;
    double u5 = u4 * u;
    double end = 10 * u3 - 15 * u4 + 6 * u5;
    double tangentStart = h * (u - 6 * u3 + 8 * u4 - 3 * u5);
    double tangentEnd = h * (-4 * u3 + 7 * u4 - 3 * u5);
    double bendStart = h * h * (u * u / 2 - 1.5 * u3 + 1.5 * u4 - u5 / 2);
    double bendEnd = h * h * (u3 / 2 - u4 + u5 / 2);
    double[] value = new double[from.length];
    for (int i = 0; i < value.length; i++) {
      value[i] =
          from[i]
              + end * (to[i] - from[i])
              + tangentStart * tangents[interval][0][i]
              + tangentEnd * tangents[interval][1][i]
              + bendStart * bends[interval][0][i]
              + bendEnd * bends[interval][1][i];
    }
    return value;
  }
}
