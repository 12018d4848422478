package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.product;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Distance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Exact;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSegment;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSpline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.ConstantSpeed;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Sections;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Spline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Timed;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Passed;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import no.hials.crosscom.simulator.internal.motion.SplineSegment.Shape;
import no.hials.crosscom.simulator.internal.path.Point;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SplineTest {
  private static final Axis START = new Axis(0, -90, 90, 0, 60, 0);
  private static final Frame FROM = Ride.ROBOT.forward(START);
  private static final ExternalTarget NONE = ExternalTarget.of(Axis.ZERO);

  /** Slow enough for neighbouring cycles to be close, fast enough to be reached at once. */
  private static final PathRates SLOW = new PathRates(0.05, 2.3, 200, 100);

  private static final List<Frame> POINTS =
      List.of(
          at(0, 40, 10),
          at(-30, 80, 40),
          at(-80, 90, 20),
          at(-100, 140, -20),
          at(-60, 190, 0),
          at(-20, 150, 60),
          at(10, 120, 30));

  private static Frame at(double x, double y, double z) {
    return new Frame(FROM.x() + x, FROM.y() + y, FROM.z() + z, FROM.a(), FROM.b(), FROM.c());
  }

  private static SplineSegment to(Shape shape, Frame target) {
    return new SplineSegment(
        shape, null, target, OptionalDouble.empty(), SLOW, OrientationControl.VAR, NONE);
  }

  private static SplineSegment circle(Frame auxiliary, Frame target) {
    return new SplineSegment(
        Shape.CIRCLE,
        auxiliary,
        target,
        OptionalDouble.empty(),
        SLOW,
        OrientationControl.VAR,
        NONE);
  }

  private static List<SplineSegment> through(List<Frame> points) {
    return points.stream().map(point -> to(Shape.THROUGH, point)).toList();
  }

  private static Ride ride(List<SplineSegment> segments) throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.spline(segments, new Exact());
    ride.toTheEnd();
    return ride;
  }

  // the path

  @Test
  void passesThroughAllPoints() throws MotionRefusedException {
    Ride ride = ride(through(POINTS));

    for (Frame point : POINTS) {
      assertThat(distance(point, ride.flanges())).isLessThan(0.01);
    }
    assertThat(ride.system.flange().distance(POINTS.get(6))).isLessThan(1e-6);
  }

  @Test
  void bendsEvenlyAtThePoints() throws MotionRefusedException {
    List<SplineSegment> segments = new ArrayList<>(through(POINTS.subList(0, 2)));
    segments.add(to(Shape.LINE, POINTS.get(2)));
    segments.add(to(Shape.THROUGH, POINTS.get(3)));
    segments.add(circle(at(-85, 175, -15), POINTS.get(4)));
    segments.add(to(Shape.THROUGH, POINTS.get(5)));
    List<Frame> flanges = ride(segments).flanges();

    assertThat(largestTurn(flanges)).isLessThan(6);
  }

  @Test
  void isExactlyStraightAndExactlyRound() throws MotionRefusedException {
    Frame first = at(0, 50, 0);
    Frame second = at(-60, 100, 30);
    Frame third = at(-100, 150, 0);
    Frame auxiliary = at(-90, 190, 20);
    Frame fourth = at(-40, 210, 10);
    List<Frame> flanges =
        ride(List.of(
                to(Shape.THROUGH, first),
                to(Shape.LINE, second),
                to(Shape.THROUGH, third),
                circle(auxiliary, fourth),
                to(Shape.THROUGH, at(0, 160, 50))))
            .flanges();

    List<Frame> line = part(flanges, first, second);
    assertThat(line).hasSizeGreaterThan(50);
    assertThat(line)
        .allSatisfy(point -> assertThat(distance(point, first, second)).isLessThan(1e-6));
    Point centre = centre(third, auxiliary, fourth);
    double radius = Point.of(third).minus(centre).length();
    List<Frame> arc = part(flanges, third, fourth);
    assertThat(arc).hasSizeGreaterThan(50);
    assertThat(arc)
        .allSatisfy(
            point ->
                assertThat(Point.of(point).minus(centre).length()).isCloseTo(radius, within(1e-6)));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6})
  void changesTwoSegmentsOnEachSideOfAMovedPoint(int moved) throws MotionRefusedException {
    List<Frame> points = new ArrayList<>(POINTS);
    Frame point = points.get(moved);
    points.set(moved, new Frame(point.x() + 5, point.y(), point.z() + 8, 0, 0, 0));
    Frame turned = points.get(moved);
    points.set(
        moved, new Frame(turned.x(), turned.y(), turned.z(), point.a() + 10, point.b(), point.c()));
    SplineCurve before = curve(through(POINTS));
    SplineCurve after = curve(through(points));

    for (int segment = 0; segment < POINTS.size(); segment++) {
      boolean same = isSame(before, after, segment);
      // segment n ends at point n
      boolean near = segment >= moved - 1 && segment <= moved + 2;
      assertThat(same).as("segment " + segment).isEqualTo(!near);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6})
  void changesOnlyTheNeighboursOfASegmentThatBecomesStraight(int straight)
      throws MotionRefusedException {
    List<SplineSegment> changed = new ArrayList<>(through(POINTS));
    changed.set(straight, to(Shape.LINE, POINTS.get(straight)));
    SplineCurve before = curve(through(POINTS));
    SplineCurve after = curve(changed);

    for (int segment = 0; segment < POINTS.size(); segment++) {
      boolean near = Math.abs(segment - straight) <= 1;
      assertThat(isSame(before, after, segment)).as("segment " + segment).isEqualTo(!near);
    }
  }

  private static SplineCurve curve(List<SplineSegment> segments) throws MotionRefusedException {
    return new SplineCurve(FROM, Axis.ZERO, segments, new Point(0, 0, 0));
  }

  private static boolean isSame(SplineCurve one, SplineCurve other, int segment) {
    for (int i = 0; i <= 20; i++) {
      Frame first = at(one, segment, i / 20.0);
      Frame second = at(other, segment, i / 20.0);
      if (first.distance(second) > 1e-9 || angle(first, second) > 1e-6) {
        return false;
      }
    }
    return true;
  }

  private static Frame at(SplineCurve curve, int segment, double part) {
    double from = curve.parameter(segment);
    return curve.at(Math.min(1, from + part * (curve.parameter(segment + 1) - from)));
  }

  @Test
  void passesTheSamePointsWhateverOverrideSpeedAndAcceleration() throws MotionRefusedException {
    Ride whole = ride(through(POINTS));
    Ride half = new Ride(START);
    half.override = 0.5;
    half.spline(through(POINTS), new Exact());
    half.toTheEnd();
    PathRates other = new PathRates(0.3, 1, 90, 300);
    Ride fast =
        ride(
            POINTS.stream()
                .map(
                    point ->
                        new SplineSegment(
                            Shape.THROUGH,
                            null,
                            point,
                            OptionalDouble.empty(),
                            other,
                            OrientationControl.VAR,
                            NONE))
                .toList());

    assertThat(half.positions).hasSizeGreaterThan(whole.positions.size() * 19 / 10);
    for (Ride ride : List.of(whole, fast)) {
      assertThat(ride.flanges())
          .allSatisfy(point -> assertThat(distance(point, half.flanges())).isLessThan(0.01));
    }
  }

  // the speed

  @Test
  void keepsItsSpeedAlongGentleBends() throws MotionRefusedException {
    List<Frame> arc = new ArrayList<>();
    for (int i = 1; i <= 8; i++) {
      double turn = Math.toRadians(15 * i);
      arc.add(at(100 * (Math.cos(turn) - 1), 100 * Math.sin(turn), 0));
    }
    List<Double> speeds = ride(through(arc)).flangeSpeeds();

    assertThat(speeds.subList(4, speeds.size() - 4))
        .allSatisfy(speed -> assertThat(speed).isCloseTo(0.05, within(0.0005)));
  }

  @Test
  void keepsTheLimitsOfTheAxes() throws MotionRefusedException {
    List<SplineSegment> segments = new ArrayList<>();
    PathRates fast = new PathRates(2, 10, 800, 4000);
    for (int i = 0; i < POINTS.size(); i++) {
      Frame point = product(POINTS.get(i), new Frame(0, 0, 0, 10 * i, i % 2 * 20, 15));
      segments.add(
          new SplineSegment(
              Shape.THROUGH,
              null,
              point,
              OptionalDouble.empty(),
              fast,
              OrientationControl.VAR,
              NONE));
    }
    Ride ride = ride(segments);

    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakSpeed(axis)).isLessThan(Ride.ROBOT.maxSpeed(axis) * 1.001);
      assertThat(ride.peakAcceleration(axis)).isLessThan(Ride.ROBOT.maxAcceleration(axis) * 1.1);
    }
    assertThat(ride.flangeSpeeds()).allMatch(speed -> speed < 2.002);
  }

  @Test
  void standsBetweenStraightSegmentsButNotWhereTheyContinue() throws MotionRefusedException {
    Frame first = at(0, 50, 0);
    Frame second = at(0, 100, 0);
    Frame third = at(-50, 100, 0);
    Ride ride = ride(List.of(to(Shape.LINE, first), to(Shape.LINE, second), to(Shape.LINE, third)));

    List<Frame> flanges = ride.flanges();
    List<Double> speeds = ride.flangeSpeeds();
    assertThat(slowestNear(first, flanges, speeds)).isCloseTo(0.05, within(1e-4));
    assertThat(slowestNear(second, flanges, speeds)).isLessThan(0.03);
    assertThat(distance(second, flanges)).isLessThan(0.05);
    assertThat(flanges)
        .allSatisfy(
            point ->
                assertThat(Math.min(distance(point, FROM, second), distance(point, second, third)))
                    .isLessThan(1e-6));
  }

  @Test
  void continuesACircleInTwoSegments() throws MotionRefusedException {
    Frame[] points = new Frame[4];
    for (int i = 0; i < 4; i++) {
      double turn = Math.toRadians(40 * (i + 1));
      points[i] = at(60 * (Math.cos(turn) - 1), 60 * Math.sin(turn), 0);
    }
    Ride ride = ride(List.of(circle(points[0], points[1]), circle(points[2], points[3])));

    assertThat(slowestNear(points[1], ride.flanges(), ride.flangeSpeeds()))
        .isCloseTo(0.05, within(1e-3));
  }

  @Test
  void standsAtTwoIdenticalPoints() throws MotionRefusedException {
    List<Frame> points = new ArrayList<>(POINTS.subList(0, 4));
    points.add(2, points.get(1));
    Ride ride = ride(through(points));

    assertThat(slowestNear(points.get(1), ride.flanges(), ride.flangeSpeeds())).isLessThan(0.03);
    assertThat(curve(through(points)).identical()).containsExactly(3);
  }

  @Test
  void turnsEvenlyFromPointToPoint() throws MotionRefusedException {
    List<Frame> points = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      Frame point = at(0, 40 * (i + 1), 0);
      points.add(product(point, new Frame(0, 0, 0, 0, i % 2 * 6, 4 * i)));
    }
    List<Frame> flanges = ride(through(points)).flanges();

    double before = 0;
    for (int i = 4; i < flanges.size() - 4; i++) {
      double turn = angle(flanges.get(i), flanges.get(i + 1));
      assertThat(i == 4 ? 0 : Math.abs(turn - before)).isLessThan(0.02);
      before = turn;
    }
    for (Frame point : points) {
      Frame nearest = nearest(point, flanges);
      assertThat(angle(nearest, point)).isLessThan(0.2);
    }
  }

  // approximation, events

  @Test
  void leavesABlockInItsLastSegmentAndNextMotionJoinsIt() throws MotionRefusedException {
    Ride ride = new Ride(START);
    List<Frame> points = POINTS.subList(0, 3);
    MotionCommand block = ride.spline(through(points), new Distance(1000));
    Frame end = at(-180, 90, 20);
    MotionCommand line = ride.lin(end);
    ride.toTheEnd();

    assertThat(distance(points.get(1), ride.flanges())).isLessThan(0.01);
    assertThat(distance(points.get(2), ride.flanges())).isGreaterThan(1);
    assertThat(ride.events)
        .containsExactly(
            new Started(block), new Started(line), new Passed(block), new Passed(line));
    List<Double> speeds = ride.flangeSpeeds();
    assertThat(speeds.subList(4, speeds.size() - 4)).allMatch(speed -> speed > 0.04);
    assertThat(largestTurn(ride.flanges())).isLessThan(12);
  }

  // sections

  @Test
  void takesTheTimesOfATimeBlock() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Sections sections = new Sections(List.of(new Timed(1, 3, 4), new Timed(3, 5, 6)), List.of());
    ride.add(new Spline(ride.nextId(), through(POINTS), sections, Frame.IDENTITY, new Exact()));
    ride.toTheEnd();

    List<Frame> flanges = ride.flanges();
    assertThat(cycles(POINTS.get(0), POINTS.get(2), flanges) * 0.012).isCloseTo(4, within(0.05));
    assertThat(cycles(POINTS.get(2), POINTS.get(4), flanges) * 0.012).isCloseTo(6, within(0.05));
  }

  @Test
  void keepsOneSpeedInASectionOfConstantSpeed() throws MotionRefusedException {
    List<SplineSegment> segments = new ArrayList<>(through(POINTS));
    SplineSegment third = segments.get(2);
    PathRates slower = new PathRates(0.02, 2.3, 200, 100);
    segments.set(
        2,
        new SplineSegment(
            third.shape(), null, third.target(), third.angle(), slower, third.orientation(), NONE));
    Ride ride = new Ride(START);
    ConstantSpeed section = new ConstantSpeed(new PathPoint(1, 10), new PathPoint(5, -10));
    Sections sections = new Sections(List.of(), List.of(section));
    ride.add(new Spline(ride.nextId(), segments, sections, Frame.IDENTITY, new Exact()));
    ride.toTheEnd();

    List<Frame> flanges = ride.flanges();
    List<Double> speeds = ride.flangeSpeeds();
    int first = flanges.indexOf(nearest(POINTS.get(1), flanges));
    int last = flanges.indexOf(nearest(POINTS.get(3), flanges));
    assertThat(speeds.subList(first, last))
        .allSatisfy(speed -> assertThat(speed).isCloseTo(0.02, within(0.0002)));
    assertThat(speeds).anyMatch(speed -> speed > 0.045);
  }

  // blocks of axes

  @Test
  void movesTheAxesSmoothlyThroughAllPoints() throws MotionRefusedException {
    List<Axis> targets =
        List.of(
            new Axis(20, -80, 80, 10, 50, 0),
            new Axis(40, -90, 70, 0, 40, 30),
            new Axis(30, -100, 100, -20, 60, 10));
    Ride ride = new Ride(START);
    AxisRates rates = AxisRates.of(50, 100);
    List<AxisSegment> segments =
        targets.stream().map(target -> new AxisSegment(target, rates, NONE)).toList();
    ride.add(new AxisSpline(ride.nextId(), segments, Sections.NONE, Frame.IDENTITY, new Exact()));
    ride.override = 0.2;
    ride.toTheEnd();

    for (Axis target : targets) {
      double nearest =
          ride.positions.stream().mapToDouble(target::largestDifference).min().orElseThrow();
      assertThat(nearest).isLessThan(0.5);
    }
    assertThat(ride.positions).last().isEqualTo(targets.get(2));
    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakSpeed(axis)).isLessThan(Ride.ROBOT.maxSpeed(axis) * 0.5);
      assertThat(ride.peakAcceleration(axis)).isLessThan(Ride.ROBOT.maxAcceleration(axis));
    }
    assertThat(ride.flangeSpeeds().subList(5, ride.flangeSpeeds().size() - 20))
        .allMatch(speed -> speed > 0.005);
  }

  // measures, by other means than the planner's

  private static double distance(Frame point, Frame from, Frame to) {
    Point way = Point.of(to).minus(Point.of(from));
    Point there = Point.of(point).minus(Point.of(from));
    double length = way.dot(way);
    double part = length == 0 ? 0 : Math.max(0, Math.min(1, there.dot(way) / length));
    return there.minus(way.times(part)).length();
  }

  /** Returns the distance of a point from a polyline. */
  private static double distance(Frame point, List<Frame> path) {
    double nearest = Double.MAX_VALUE;
    for (int i = 1; i < path.size(); i++) {
      nearest = Math.min(nearest, distance(point, path.get(i - 1), path.get(i)));
    }
    return nearest;
  }

  private static Frame nearest(Frame point, List<Frame> path) {
    Frame nearest = path.get(0);
    for (Frame candidate : path) {
      nearest = candidate.distance(point) < nearest.distance(point) ? candidate : nearest;
    }
    return nearest;
  }

  private static List<Frame> part(List<Frame> path, Frame from, Frame to) {
    int first = path.indexOf(nearest(from, path));
    int last = path.indexOf(nearest(to, path));
    return path.subList(first + 1, last);
  }

  private static int cycles(Frame from, Frame to, List<Frame> path) {
    return path.indexOf(nearest(to, path)) - path.indexOf(nearest(from, path));
  }

  private static double slowestNear(Frame point, List<Frame> path, List<Double> speeds) {
    int at = path.indexOf(nearest(point, path));
    return Math.min(speeds.get(at - 1), speeds.get(at));
  }

  /** Returns the largest change of direction from one cycle to the next, degrees. */
  private static double largestTurn(List<Frame> path) {
    double largest = 0;
    for (int i = 6; i < path.size() - 6; i++) {
      Point in = Point.of(path.get(i)).minus(Point.of(path.get(i - 1)));
      Point out = Point.of(path.get(i + 1)).minus(Point.of(path.get(i)));
      largest = Math.max(largest, Math.atan2(in.cross(out).length(), in.dot(out)));
    }
    return Math.toDegrees(largest);
  }

  /** Returns the point of the plane of three that is as far from each of them. */
  private static Point centre(Frame one, Frame two, Frame three) {
    Point a = Point.of(one);
    Point ab = Point.of(two).minus(a);
    Point ac = Point.of(three).minus(a);
    Point normal = ab.cross(ac);
    // the bisecting lines of both sides cross there
    Point along = ab.cross(normal);
    double t = (ac.dot(ac) - ac.dot(ab)) / 2 / ac.dot(along);
    return a.plus(ab.times(0.5)).plus(along.times(t));
  }
}
