package no.hials.crosscom.simulator.internal.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.AxisDistance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Distance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Exact;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Orientation;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Speed;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSegment;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.AxisSpline;
import no.hials.crosscom.simulator.internal.motion.MotionCommand.Sections;
import no.hials.crosscom.simulator.internal.motion.SplineSegment.Shape;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Points that are almost where the robot is, as taught points and computed ones often are. */
class TinyDistanceTest {
  private static final Axis START = new Axis(0, -90, 90, 0, 60, 0);
  private static final Frame FROM = Ride.ROBOT.forward(START);
  private static final ExternalTarget NONE = ExternalTarget.of(Axis.ZERO);

  /** The longest of the rides takes about 950 cycles. */
  private static final int ENOUGH = 2000;

  private final Ride ride = new Ride(START);

  @AfterEach
  void staysOnFiniteAxes() {
    assertThat(ride.positions)
        .allMatch(axes -> Double.isFinite(axes.toArray()[0] + axes.largestDifference(START)));
  }

  private static Frame at(double x, double y, double z) {
    return new Frame(FROM.x() + x, FROM.y() + y, FROM.z() + z, FROM.a(), FROM.b(), FROM.c());
  }

  private static Frame turned(Frame frame, double degrees) {
    return Frames.product(frame, new Frame(0, 0, 0, degrees, 0, 0));
  }

  private static SplineSegment to(Shape shape, Frame target) {
    return segment(shape, null, target, NONE);
  }

  private static SplineSegment segment(
      Shape shape, Frame auxiliary, Frame target, ExternalTarget external) {
    PathRates rates = new PathRates(0.2, 2.3, 200, 100);
    OptionalDouble whole = OptionalDouble.empty();
    return new SplineSegment(
        shape, auxiliary, target, whole, rates, OrientationControl.VAR, external);
  }

  private void ride(SplineSegment... segments) throws MotionRefusedException {
    ride.spline(List.of(segments), new Exact());
    endsAt(segments[segments.length - 1].target());
  }

  private void endsAt(Frame target) {
    assertThat(ride.toTheEnd()).isLessThan(ENOUGH);
    assertThat(ride.system.flange().distance(target)).isLessThan(0.002);
    assertThat(Frames.angle(ride.system.flange(), target)).isLessThan(0.002);
    assertThat(ride.events).noneMatch(MotionEvent.Faulted.class::isInstance);
  }

  @ParameterizedTest
  @CsvSource({
    "THROUGH, 0", "THROUGH, 1e-12", "THROUGH, 1e-7", "THROUGH, 5e-4", "THROUGH, 0.0011",
    "LINE, 0", "LINE, 1e-12", "LINE, 1e-7", "LINE, 5e-4", "LINE, 0.0011"
  })
  void aBlockCanStartAlmostWhereTheRobotIs(Shape shape, double mm) throws MotionRefusedException {
    ride(to(shape, at(mm, 0, 0)), to(Shape.THROUGH, at(0, 40, 10)), to(shape, at(-30, 80, 40)));
  }

  @ParameterizedTest
  @CsvSource({
    "THROUGH, 0", "THROUGH, 1e-12", "THROUGH, 1e-7", "THROUGH, 5e-4", "THROUGH, 0.0011",
    "LINE, 0", "LINE, 1e-12", "LINE, 1e-7", "LINE, 5e-4", "LINE, 0.0011"
  })
  void pointsInTheMiddleAndAtTheEndCanAlmostBeTheSame(Shape shape, double mm)
      throws MotionRefusedException {
    ride(
        to(Shape.THROUGH, at(0, 40, 10)),
        to(shape, at(0, 40 + mm, 10)),
        to(Shape.THROUGH, at(-30, 80, 40)),
        to(shape, at(-30, 80, 40 + mm)));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-12, 1e-7, 5e-4, 0.0011})
  void aBlockCanHaveAlmostNoLength(double mm) throws MotionRefusedException {
    ride(
        to(Shape.THROUGH, at(mm, 0, 0)),
        to(Shape.LINE, at(mm, mm, 0)),
        to(Shape.THROUGH, at(0, mm, mm)));
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "0, 1e-9",
    "0, 1e-4",
    "0, 5",
    "1e-7, 1e-9",
    "1e-7, 5",
    "5e-4, 1e-9",
    "5e-4, 1e-4",
    "5e-4, 5",
    "0.0011, 5"
  })
  void theRobotTurnsWhereTheTcpAlmostStands(double mm, double degrees)
      throws MotionRefusedException {
    Frame middle = at(0, 40, 10);
    Frame end = turned(at(-30, 80, 40), degrees);
    ride(
        to(Shape.THROUGH, turned(at(mm, 0, 0), degrees)),
        to(Shape.THROUGH, middle),
        to(Shape.THROUGH, turned(at(mm, 40, 10), degrees)),
        to(Shape.THROUGH, end),
        to(Shape.THROUGH, turned(end, degrees)));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0011, 0.01})
  void aCircleCanAlmostBeAPoint(double mm) throws MotionRefusedException {
    ride(
        to(Shape.THROUGH, at(0, 40, 10)),
        segment(Shape.CIRCLE, at(mm, 40, 10), at(mm, 40 + mm, 10), NONE),
        to(Shape.THROUGH, at(-30, 80, 40)));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-7, 5e-4})
  void aCircleOfOnePointIsRefused(double mm) {
    List<SplineSegment> segments =
        List.of(
            to(Shape.THROUGH, at(0, 40, 10)),
            segment(Shape.CIRCLE, at(mm, 40, 10), at(-mm, 40 + mm, 10), NONE));

    assertThat(refusal(segments)).isInstanceOf(MotionProblem.NotACircle.class);
  }

  private MotionProblem refusal(List<SplineSegment> segments) {
    try {
      ride.spline(segments, new Exact());
      return null;
    } catch (MotionRefusedException e) {
      return e.problem();
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-12, 1e-9, 1e-7, 1e-4, 1e-3})
  void aBlockOfAxesCanHavePointsThatAreAlmostTheSame(double degrees) throws MotionRefusedException {
    Axis near = START.with(0, degrees);
    Axis middle = new Axis(20, -80, 80, 10, 50, 0);
    List<Axis> points =
        List.of(near, START, middle, middle.with(4, 50 + degrees), near, near.with(1, -90));
    axes(points);
    endsAt(Ride.ROBOT.forward(near));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-12, 1e-9, 1e-7, 1e-4, 1e-3})
  void aBlockOfAxesCanHaveAlmostNoLength(double degrees) throws MotionRefusedException {
    axes(List.of(START.with(0, degrees), START.with(0, degrees), START.with(4, 60 - degrees)));
    endsAt(Ride.ROBOT.forward(START.with(4, 60 - degrees)));
  }

  private void axes(List<Axis> points) throws MotionRefusedException {
    AxisRates rates = AxisRates.of(50, 100);
    List<AxisSegment> segments =
        points.stream().map(target -> new AxisSegment(target, rates, NONE)).toList();
    ride.add(new AxisSpline(ride.nextId(), segments, Sections.NONE, Frame.IDENTITY, new Exact()));
  }

  private static List<ApproximationZone> approximations() {
    return List.of(
        new Exact(), new Distance(20), new Orientation(5), new Speed(50), new AxisDistance(50));
  }

  @ParameterizedTest
  @MethodSource("approximations")
  void singleMotionsCanGoAlmostNowhere(ApproximationZone approximation)
      throws MotionRefusedException {
    List<Frame> targets = new ArrayList<>();
    for (double mm : new double[] {0, 1e-12, 1e-9, 1e-7, 5e-4, 5e-4, 1e-3}) {
      Frame last = targets.isEmpty() ? FROM : targets.get(targets.size() - 1);
      targets.add(new Frame(last.x(), last.y() + mm, last.z(), last.a(), last.b(), last.c()));
      targets.add(turned(targets.get(targets.size() - 1), mm));
      targets.add(at(-30, 30, 20));
    }
    Axis axes = START;
    for (Frame target : targets) {
      ride.lin(target, approximation);
      axes = ride.system.plannedEnd().robot();
      ride.ptp(axes.with(0, axes.get(0) + 5e-4), Ride.FULL, approximation);
      ride.ptp(axes.with(0, axes.get(0) + 1e-10), Ride.FULL, approximation);
      ride.spline(List.of(to(Shape.THROUGH, target), to(Shape.LINE, target)), approximation);
    }
    Frame end = at(0, 40, 10);
    ride.lin(end);
    endsAt(end);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-12, 1e-7, 5e-4, 0.0011, 0.1})
  void approximatedBlocksCanEndAndStartAlmostInOnePoint(double mm) throws MotionRefusedException {
    Frame middle = at(0, 40, 10);
    Frame end = at(-60, 40, 40);
    ride.spline(
        List.of(to(Shape.THROUGH, middle), to(Shape.THROUGH, at(0, 40 + mm, 10))),
        new Distance(20));
    ride.spline(
        List.of(
            to(Shape.THROUGH, at(mm, 40 + mm, 10)),
            to(Shape.THROUGH, at(-30, 80, 40)),
            to(Shape.THROUGH, end)),
        new Distance(20));
    ride.lin(at(-60, 40 + mm, 40), new Distance(20));
    ride.lin(at(0, 0, 40));
    endsAt(at(0, 0, 40));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-12, 1e-9, 1e-7, 1e-4, 1e-2})
  void approximatedBlocksOfAxesCanEndAndStartAlmostInOnePoint(double degrees)
      throws MotionRefusedException {
    Axis middle = new Axis(20, -80, 80, 10, 50, 0);
    Axis near = middle.with(3, 10 + degrees);
    AxisRates rates = AxisRates.of(50, 100);
    for (List<Axis> points : List.of(List.of(middle, near), List.of(middle, START, near))) {
      List<AxisSegment> segments =
          points.stream().map(target -> new AxisSegment(target, rates, NONE)).toList();
      ride.add(
          new AxisSpline(ride.nextId(), segments, Sections.NONE, Frame.IDENTITY, new Distance(20)));
    }
    ride.ptp(START);
    endsAt(FROM);
  }
}
