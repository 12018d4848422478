package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.SplineSegment.Shape;
import no.hials.crosscom.simulator.internal.path.ArcLength;
import no.hials.crosscom.simulator.internal.path.Point;
import no.hials.crosscom.simulator.internal.path.SmoothCurve;
import org.jspecify.annotations.Nullable;

/**
 * The path of a spline block, over its length. SPL segments are polynomials ({@link SmoothCurve}),
 * whose tangents and bends are those of the straight and circular segments next to them. The
 * orientation is a curve of rotations with the same neighbours.
 *
 * <p>The robot stops between two straight or circular segments, unless they continue each other, at
 * two identical points, and where the path would turn back on itself.
 */
final class SplineCurve implements Curve {
  /** Points are the same if they are closer than this, mm or degrees. Assumed. */
  private static final double SAME = 1e-3;

  /** Directions are the same, and rates of the orientation, if they differ by less. Assumed. */
  private static final double SAME_DIRECTION = 1e-5;

  /** The path turns back if the tangent at a point is shorter than this. Assumed. */
  private static final double TURNS_BACK = 1e-3;

  /** The length of 1 degree, or of 1 mm of an external axis, where the TCP stands still, mm. */
  private static final double UNIT = 1;

  private final List<SplineSegment> segments;
  private final int count;
  private final Point rail;
  private final Frame[] frames;
  private final Axis[] external;

  /** The lengths of the intervals by which derivatives are taken; 0 if the TCP stands still. */
  private final double[] chords;

  private final @Nullable Arc[] arcs;
  private final boolean[] stops;
  private final SmoothCurve positions;
  private final SmoothCurve externals;

  /** The changes of the orientation by the length at the start and end of each interval. */
  private final double[][][] turns;

  private final @Nullable ArcLength[] arcLengths;

  /** The positions of the points on the path, mm. */
  private final double[] distances;

  /** The numbers of points that are the same as the one before. */
  private final List<Integer> identical = new ArrayList<>();

  private final boolean travels;

  private double angle;

  /**
   * Creates the path.
   *
   * @param rail the way of the robot's root at 1 mm of E1
   */
  SplineCurve(Frame start, Axis externalStart, List<SplineSegment> segments, Point rail)
      throws MotionRefusedException {
    this.segments = segments;
    this.rail = rail;
    count = segments.size();
    frames = new Frame[count + 1];
    external = new Axis[count + 1];
    chords = new double[count];
    arcs = new Arc[count];
    turns = new double[count][2][];
    arcLengths = new ArcLength[count];
    distances = new double[count + 1];
    frames[0] = start;
    external[0] = externalStart;
    for (int i = 0; i < count; i++) {
      set(i, segments.get(i));
    }
    travels = Arrays.stream(external).anyMatch(axes -> !axes.equals(externalStart));
    ignoreOrientations();
    stops = new boolean[count + 1];
    for (int i = 1; i < count; i++) {
      stops[i] = isStop(i);
    }
    positions = positions();
    externals = externals();
    setTurns();
    for (int i = 0; i < count; i++) {
      distances[i + 1] = distances[i] + measure(i);
      angle += Frames.angle(frames[i], frames[i + 1]);
    }
  }

  private void set(int i, SplineSegment segment) throws MotionRefusedException {
    Frame target = segment.target();
    boolean keeps = segment.orientation() == OrientationControl.CONSTANT;
    frames[i + 1] = keeps ? Point.of(target).turnedAs(frames[i]) : target;
    external[i + 1] = segment.external().axes();
    chords[i] = frames[i].distance(frames[i + 1]);
    if (segment.shape() == Shape.CIRCLE) {
      Frame auxiliary = Objects.requireNonNull(segment.auxiliary());
      Arc arc = Arc.through(frames[i], auxiliary, target, segment.angle(), frames[i + 1]);
      arcs[i] = arc;
      chords[i] = arc.length();
      frames[i + 1] = arc.at(1);
    }
    if (chords[i] < SAME) {
      stay(i);
    }
  }

  /** Lets the TCP stay where it is; what changes less than can be seen stays as well. */
  private void stay(int i) {
    chords[i] = 0;
    arcs[i] = null;
    boolean turns = Frames.angle(frames[i], frames[i + 1]) >= SAME;
    frames[i + 1] = turns ? Point.of(frames[i]).turnedAs(frames[i + 1]) : frames[i];
    if (external[i].largestDifference(external[i + 1]) < SAME) {
      external[i + 1] = external[i];
    }
    if (!turns && external[i].equals(external[i + 1])) {
      identical.add(i + 1);
    }
  }

  /** Turns the orientations of points that do not count evenly to the next one that does. */
  private void ignoreOrientations() {
    int known = 0;
    double length = 0;
    double[] lengths = new double[count + 1];
    for (int i = 1; i <= count; i++) {
      length += chords[i - 1];
      lengths[i] = length;
      boolean ignored = segments.get(i - 1).orientation() == OrientationControl.IGNORE;
      if (ignored && i < count) {
        continue;
      }
      Frame last = ignored ? frames[known] : frames[i];
      frames[i] = Point.of(frames[i]).turnedAs(last);
      for (int j = known + 1; j < i; j++) {
        double part = (lengths[j] - lengths[known]) / (length - lengths[known]);
        Frame turned = Frames.interpolate(frames[known], last, Double.isNaN(part) ? 1 : part);
        frames[j] = Point.of(frames[j]).turnedAs(turned);
      }
      known = i;
      length = lengths[i];
    }
  }

  // stops

  private boolean isStop(int point) {
    int before = point - 1;
    if (chords[before] == 0 || chords[point] == 0) {
      return true;
    }
    if (shape(before) == Shape.THROUGH || shape(point) == Shape.THROUGH) {
      return shape(before) == shape(point) && turnsBack(point);
    }
    if (shape(before) != shape(point)) {
      return true;
    }
    return shape(point) == Shape.LINE ? !continuesLine(point) : !continuesCircle(point);
  }

  private Shape shape(int segment) {
    return segments.get(segment).shape();
  }

  private boolean turnsBack(int point) {
    double[] tangent =
        SmoothCurve.parabola(
            vector(direction(point - 1)), chords[point - 1],
            vector(direction(point)), chords[point]);
    return SmoothCurve.length(tangent) < TURNS_BACK;
  }

  private Point direction(int segment) {
    Point way = Point.of(frames[segment + 1]).minus(Point.of(frames[segment]));
    return way.times(1 / way.length());
  }

  private boolean continuesLine(int point) {
    Point change = direction(point).minus(direction(point - 1));
    double[] turn = SmoothCurve.sum(turnRate(point), 1, turnRate(point - 1), -1);
    return change.length() < SAME_DIRECTION && SmoothCurve.length(turn) < SAME_DIRECTION;
  }

  private boolean continuesCircle(int point) {
    Arc first = Objects.requireNonNull(arcs[point - 1]);
    Arc second = Objects.requireNonNull(arcs[point]);
    boolean sameCentre = first.centre().minus(second.centre()).length() < SAME;
    return sameCentre
        && first.direction(1).minus(second.direction(0)).length() < SAME / second.arm().length();
  }

  // the curves

  private SmoothCurve positions() {
    double[][] points = new double[count + 1][];
    double[][] tangents = new double[count + 1][];
    double[][] bends = new double[count + 1][];
    for (int i = 0; i <= count; i++) {
      points[i] = vector(Point.of(frames[i]));
    }
    for (int i = 1; i < count; i++) {
      if (!stops[i]) {
        // at most one of them is straight or circular, or they continue each other
        int next = shape(i) == Shape.THROUGH ? i - 1 : i;
        if (shape(next) == Shape.LINE) {
          tangents[i] = vector(direction(next));
          bends[i] = new double[3];
        } else if (shape(next) == Shape.CIRCLE) {
          Arc arc = Objects.requireNonNull(arcs[next]);
          int end = next == i ? 0 : 1;
          tangents[i] = vector(arc.direction(end));
          Point in = arc.centre().minus(Point.of(frames[i]));
          bends[i] = vector(in.times(1 / in.dot(in)));
        }
      }
    }
    return new SmoothCurve(points, chords, stops, tangents, bends);
  }

  private SmoothCurve externals() {
    double[][] points = new double[count + 1][];
    for (int i = 0; i <= count; i++) {
      points[i] = external[i].toArray();
    }
    return new SmoothCurve(points, chords, stops);
  }

  private static double[] vector(Point point) {
    return new double[] {point.x(), point.y(), point.z()};
  }

  private void setTurns() {
    for (int i = 0; i < count; i++) {
      if (chords[i] > 0) {
        for (int side = 0; side < 2; side++) {
          turns[i][side] = turnRateAt(i, i + side);
        }
      }
    }
  }

  /** Returns the change of the orientation by the length at an end of an interval. */
  private double[] turnRateAt(int interval, int point) {
    if (!positions.isEnd(point)) {
      return innerTurnRate(point);
    }
    int other = 2 * interval + 1 - point;
    double[] mean = turnRate(interval);
    return positions.isEnd(other) ? mean : SmoothCurve.sum(mean, 2, innerTurnRate(other), -1);
  }

  private double[] innerTurnRate(int point) {
    if (keeps(point - 1) || keeps(point)) {
      return new double[3];
    }
    return SmoothCurve.parabola(
        turnRate(point - 1), chords[point - 1], turnRate(point), chords[point]);
  }

  private boolean keeps(int segment) {
    return segments.get(segment).orientation() == OrientationControl.CONSTANT;
  }

  private double[] turnRate(int interval) {
    double[] turn = Frames.turn(frames[interval], frames[interval + 1]);
    return SmoothCurve.sum(turn, 1 / chords[interval], turn, 0);
  }

  /** Returns the length of an interval. */
  private double measure(int i) {
    if (chords[i] == 0) {
      double way = external[i].largestDifference(external[i + 1]);
      return UNIT * Math.max(way, Frames.angle(frames[i], frames[i + 1]));
    }
    if (shape(i) != Shape.THROUGH) {
      return chords[i];
    }
    Point[] points = new Point[ArcLength.INTERVALS + 1];
    for (int j = 0; j < points.length; j++) {
      points[j] = position(i, (double) j / ArcLength.INTERVALS);
    }
    ArcLength length = new ArcLength(j -> points[j].minus(points[j + 1]).length());
    arcLengths[i] = length;
    return length.length();
  }

  private Point position(int interval, double part) {
    Arc arc = arcs[interval];
    if (arc != null) {
      return Point.of(arc.at(part));
    }
    if (shape(interval) == Shape.LINE) {
      Point from = Point.of(frames[interval]);
      return from.plus(Point.of(frames[interval + 1]).minus(from).times(part));
    }
    double[] at = positions.at(interval, part);
    return new Point(at[0], at[1], at[2]);
  }

  private Frame orientation(int interval, double part) {
    Frame from = frames[interval];
    Frame to = frames[interval + 1];
    double[] start = turns[interval][0];
    double[] end = turns[interval][1];
    if (start == null) {
      return Frames.interpolate(from, to, part);
    }
    if (isZero(start) && isZero(end) && !Curve.isTurn(from, to)) {
      return from;
    }
    double third = chords[interval] / 3;
    double[] first = SmoothCurve.sum(start, third, start, 0);
    double[] last = SmoothCurve.sum(end, third, end, 0);
    Frame begun = Frames.turned(from, first);
    Frame missing = Frames.turned(to, SmoothCurve.sum(last, -1, last, 0));
    double[] middle = Frames.turn(begun, missing);
    double rest = 1 - part;
    Frame turned = Frames.turned(from, scaled(first, 1 - rest * rest * rest));
    turned = Frames.turned(turned, scaled(middle, part * part * (3 - 2 * part)));
    return Frames.turned(turned, scaled(last, part * part * part));
  }

  private static boolean isZero(double[] vector) {
    return SmoothCurve.length(vector) == 0;
  }

  private static double[] scaled(double[] vector, double factor) {
    return SmoothCurve.sum(vector, factor, vector, 0);
  }

  // the path

  private int interval(double distance) {
    int found = Arrays.binarySearch(distances, distance);
    int interval = found >= 0 ? found : -found - 2;
    return Math.max(0, Math.min(count - 1, interval));
  }

  private double part(int interval, double distance) {
    double length = distances[interval + 1] - distances[interval];
    double part =
        length == 0 ? 1 : Math.max(0, Math.min(1, (distance - distances[interval]) / length));
    ArcLength arcLength = arcLengths[interval];
    return arcLength == null ? part : arcLength.parameter(part);
  }

  @Override
  public Frame at(double parameter) {
    double distance = parameter * length();
    int interval = interval(distance);
    double part = part(interval, distance);
    Point moved = rail.times(external(interval, part).get(0) - external[0].get(0));
    return position(interval, part).minus(moved).turnedAs(orientation(interval, part));
  }

  /** Returns the external axes. */
  Axis external(double parameter) {
    double distance = parameter * length();
    int interval = interval(distance);
    return external(interval, part(interval, distance));
  }

  private Axis external(int interval, double part) {
    return travels ? Axis.of(externals.at(interval, part)) : external[0];
  }

  @Override
  public double length() {
    return distances[count];
  }

  @Override
  public double angle() {
    return angle;
  }

  /** Returns positions on an interval, from 0 above its start to 1 at its end, that bend little. */
  double[] evenParts(int interval, int fewest) {
    ArcLength arcLength = arcLengths[interval];
    if (arcLength != null) {
      return arcLength.evenParts();
    }
    double[] even = new double[fewest];
    Arrays.setAll(even, i -> (i + 1.0) / fewest);
    return even;
  }

  int count() {
    return count;
  }

  /** Returns the parameter of a point. */
  double parameter(int point) {
    return point == count ? 1 : distances[point] / length();
  }

  /** Returns the parameters at which the robot stops. */
  double[] stops() {
    List<Double> found = new ArrayList<>();
    for (int i = 1; i < count; i++) {
      if (stops[i] && parameter(i) > 0 && parameter(i) < 1) {
        found.add(parameter(i));
      }
    }
    return found.stream().mapToDouble(Double::doubleValue).distinct().toArray();
  }

  /** Returns the numbers of points that are the same as the one before. */
  List<Integer> identical() {
    return identical;
  }

  SplineSegment segment(int index) {
    return segments.get(index);
  }
}
