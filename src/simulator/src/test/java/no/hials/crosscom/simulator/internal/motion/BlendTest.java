package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.product;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.AxisDistance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Distance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Exact;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Orientation;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Speed;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Passed;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import no.hials.crosscom.simulator.internal.path.Point;
import no.hials.crosscom.simulator.internal.path.Trapezoid;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BlendTest {
  private static final RobotModel ROBOT = Ride.ROBOT;
  private static final Axis HOME = ROBOT.home();
  private static final Axis START = new Axis(0, -90, 90, 0, 60, 0);
  private static final Frame FROM = ROBOT.forward(START);

  @Test
  void flowsThroughAChainOfSmallAxisIncrements() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    Axis target = HOME;
    for (int i = 0; i < 60; i++) {
      // As a loop with $ADVANCE=1 does: one motion is planned while another one runs.
      while (ride.system.planned() < 1) {
        target = target.with(0, target.a1() + 0.5);
        ride.ptp(target, Ride.FULL, new AxisDistance(50));
      }
      ride.cycle();
      if (i > 10) {
        // The peak of a triangle of 0.5 degrees.
        double speed = Math.sqrt(0.5 * ROBOT.maxAcceleration(0));
        assertThat(ride.system.axisVelocity().a1()).isCloseTo(speed, within(speed * 1e-6));
      }
    }
    ride.toTheEnd();

    assertThat(ride.system.axes()).isEqualTo(target);
    assertThat(ride.peakAcceleration(0)).isLessThan(ROBOT.maxAcceleration(0) * 1.000001);
  }

  @Test
  void flowsThroughAChainOfTheSmallestIncrements() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    Axis target = HOME;
    for (int i = 0; i < 200; i++) {
      while (ride.system.planned() < 1) {
        target = target.with(5, target.a6() + 0.001);
        ride.ptp(target, Ride.FULL, new AxisDistance(50));
      }
      ride.cycle();
      if (i > 10) {
        double speed = 0.001 / Trapezoid.SHORTEST_RAMP;
        assertThat(ride.system.axisVelocity().a6()).isCloseTo(speed, within(speed * 1e-6));
      }
    }
  }

  @Test
  void flowsThroughAChainOfSmallPathIncrements() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame target = FROM;
    for (int i = 0; i < 80; i++) {
      while (ride.system.planned() < 1) {
        target = moved(target, 0, 2, 0);
        ride.lin(target, new Distance(3));
      }
      ride.cycle();
      if (i > 10) {
        // It must be able to stop within the half of a motion and the whole next one.
        assertThat(ride.system.pathVelocity()).isGreaterThan(Math.sqrt(2 * 2.3 * 0.002));
      }
    }
    ride.toTheEnd();

    assertThat(ride.system.flange().distance(target)).isLessThan(1e-6);
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * 1.01);
  }

  @ParameterizedTest
  @CsvSource({"0.02", "0.04", "0.09", "0.2"})
  void keepsMovingWhileTargetsFollowASlowPoint(double speed) throws MotionRefusedException {
    Ride ride = new Ride(START);
    for (int i = 1; i <= 120; i++) {
      // a client writes a target in every cycle, and the program takes it when it can
      if (ride.system.planned() < 1) {
        ride.lin(moved(FROM, 0, i * speed * 1000 * Interpolator.CYCLE, 0), new Distance(3));
      }
      ride.cycle();
    }

    assertThat(ride.flangeSpeeds().subList(10, 120))
        .allSatisfy(v -> assertThat(v).isBetween(0.5 * speed, 1.5 * speed));
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * 1.05);
  }

  @Test
  void cutsASmallerCornerIfTheNextMotionComesLate() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame corner = moved(FROM, 0, 100, 0);
    PathRates rates = new PathRates(0.1, 2.3, 200, 100);
    ride.lin(corner, Frame.IDENTITY, rates, OrientationControl.VAR, new Distance(40));
    do {
      ride.cycle();
    } while (ride.system.distanceToEnd() > 20);
    ride.lin(moved(corner, -100, 0, 0), Frame.IDENTITY, rates, OrientationControl.VAR, new Exact());
    ride.toTheEnd();

    assertThat(ride.flanges()).noneMatch(flange -> flange.distance(corner) < 3);
    assertThat(ride.flangeSpeeds().subList(3, ride.flangeSpeeds().size() - 3))
        .allMatch(speed -> speed > 0.05);
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * 1.05);
  }

  @Test
  void passesACornerOfAxesWithoutStanding() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    Axis corner = HOME.with(0, 60);
    ride.ptp(corner, Ride.FULL, new AxisDistance(50));
    ride.ptp(corner.with(1, -40));
    ride.toTheEnd();

    assertThat(ride.positions).allMatch(axes -> axes.a1() <= 60 && axes.a2() >= -90);
    double nearest =
        ride.positions.stream().mapToDouble(axes -> axes.largestDifference(corner)).min().orElse(0);
    assertThat(nearest).isBetween(2.0, 45.0);
    assertThat(ride.system.axes()).isEqualTo(corner.with(1, -40));
    for (int axis = 0; axis < 2; axis++) {
      assertThat(ride.peakSpeed(axis)).isLessThan(ROBOT.maxSpeed(axis) * 1.000001);
      assertThat(ride.peakAcceleration(axis)).isLessThan(ROBOT.maxAcceleration(axis) * 1.000001);
    }
  }

  @Test
  void beginsWithinThePartOfTheAxisDistance() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    Axis corner = HOME.with(0, 60);
    ride.ptp(corner, Ride.FULL, new AxisDistance(10));
    ride.ptp(corner.with(1, -40));
    ride.toTheEnd();

    assertThat(ride.positions)
        .filteredOn(axes -> axes.a1() < 60 - 9 - 1e-6)
        .allMatch(axes -> axes.a2() == -90);
    assertThat(ride.positions)
        .filteredOn(axes -> axes.a2() > -90 + 9 + 1e-6)
        .allMatch(axes -> axes.a1() == 60);
    assertThat(ride.positions).noneMatch(corner::equals);
  }

  @Test
  void doublesAnAccelerationAtMostOnTheWayBack() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(HOME.with(0, 60), Ride.FULL, new AxisDistance(50));
    ride.ptp(HOME);
    ride.toTheEnd();

    assertThat(ride.system.axes()).isEqualTo(HOME);
    assertThat(ride.peakSpeed(0)).isLessThan(ROBOT.maxSpeed(0) * 1.000001);
    assertThat(ride.peakAcceleration(0)).isLessThan(ROBOT.maxAcceleration(0) * 2.05);
  }

  @Test
  void cutsACornerOfLinesWithinItsDistance() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame corner = moved(FROM, 0, 100, 0);
    Frame end = moved(FROM, -100, 100, 0);
    ride.lin(corner, new Distance(10));
    ride.lin(end);
    ride.toTheEnd();

    double nearest = Double.MAX_VALUE;
    for (Frame flange : ride.flanges()) {
      boolean onTheLines =
          Math.abs(flange.x() - FROM.x()) < 0.001 || Math.abs(flange.y() - corner.y()) < 0.001;
      assertThat(onTheLines || flange.distance(corner) <= 10.001).isTrue();
      nearest = Math.min(nearest, flange.distance(corner));
    }
    assertThat(nearest).isBetween(1.0, 10.0);
    assertThat(ride.flangeSpeeds().subList(3, ride.flangeSpeeds().size() - 3))
        .allMatch(speed -> speed > 0.05);
    assertThat(ride.system.flange().distance(end)).isLessThan(1e-6);
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * 1.05);
  }

  @ParameterizedTest
  @CsvSource({"0.2, 20", "0.2, 45", "0.02, 20", "1, 20", "0.2, 200"})
  void leavesALineAtItsDistanceWhateverTheSpeed(double speed, double mm)
      throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame corner = moved(FROM, 0, 100, 0);
    PathRates rates = new PathRates(speed, 2.3, 200, 100);
    ride.lin(corner, Frame.IDENTITY, rates, OrientationControl.VAR, new Distance(mm));
    ride.lin(moved(corner, -100, 0, 0), Frame.IDENTITY, rates, OrientationControl.VAR, new Exact());
    ride.toTheEnd();

    double legs = Math.min(mm, 50);
    double furthest = 0;
    for (Frame flange : ride.flanges()) {
      double before = corner.y() - flange.y();
      double after = corner.x() - flange.x();
      if (before >= legs + 1e-6) {
        assertThat(after).isCloseTo(0, within(1e-6));
      } else if (after >= legs + 1e-6) {
        assertThat(before).isCloseTo(0, within(1e-6));
      } else {
        // the parabola that touches both lines there
        assertThat(Math.sqrt(before) + Math.sqrt(after)).isCloseTo(Math.sqrt(legs), within(1e-3));
        furthest = Math.max(furthest, Math.min(before, after));
      }
    }
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * 1.05);
    assertThat(furthest).isBetween(legs / 8, legs / 4 + 1e-6);
    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakAcceleration(axis)).isLessThan(ROBOT.maxAcceleration(axis) * 1.05);
    }
  }

  @Test
  void keepsItsSpeedThroughAGentleCorner() throws MotionRefusedException {
    Ride ride = new Ride(START);
    PathRates rates = new PathRates(0.1, 2.3, 200, 100);
    Frame corner = moved(FROM, 0, 100, 0);
    ride.lin(corner, Frame.IDENTITY, rates, OrientationControl.VAR, new Distance(40));
    ride.lin(moved(corner, -50, 80, 0), Frame.IDENTITY, rates, OrientationControl.VAR, new Exact());
    ride.toTheEnd();

    List<Double> speeds = ride.flangeSpeeds();
    assertThat(speeds.subList(6, speeds.size() - 6))
        .allSatisfy(speed -> assertThat(speed).isCloseTo(0.1, within(0.001)));
  }

  @Test
  void passesTheSamePointsAtHalfTheOverride() throws MotionRefusedException {
    List<Frame> whole = corner(1);
    List<Frame> half = corner(0.5);

    for (Frame point : whole) {
      double nearest = Double.MAX_VALUE;
      for (int i = 1; i < half.size(); i++) {
        nearest = Math.min(nearest, distance(point, half.get(i - 1), half.get(i)));
      }
      assertThat(nearest).isLessThan(0.01);
    }
  }

  private static List<Frame> corner(double override) throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.override = override;
    Frame corner = moved(FROM, 0, 100, 0);
    ride.lin(corner, new Distance(30));
    ride.lin(moved(corner, -80, 20, 30), new Distance(30));
    ride.lin(moved(corner, -80, 90, 30));
    ride.toTheEnd();
    return ride.flanges();
  }

  /** Returns the distance of a point from a straight piece. */
  private static double distance(Frame point, Frame from, Frame to) {
    Point way = Point.of(to).minus(Point.of(from));
    Point there = Point.of(point).minus(Point.of(from));
    double length = way.dot(way);
    double part = length == 0 ? 0 : Math.max(0, Math.min(1, there.dot(way) / length));
    return there.minus(way.times(part)).length();
  }

  @Test
  void turnsThroughACornerEvenly() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame corner = product(moved(FROM, 0, 100, 0), new Frame(0, 0, 0, 20, 0, 0));
    Frame end = product(moved(corner, 0, 100, 0), new Frame(0, 0, 0, 0, 20, 0));
    ride.lin(corner, new Speed(100));
    ride.lin(end);
    ride.toTheEnd();

    List<Frame> flanges = ride.flanges();
    double before = 0;
    for (int i = 1; i < flanges.size(); i++) {
      double turn = angle(flanges.get(i), flanges.get(i - 1)) / Interpolator.CYCLE;
      assertThat(Math.abs(turn - before) / Interpolator.CYCLE).isLessThan(100 * 1.1);
      before = turn;
    }
    assertThat(angle(ride.system.flange(), end)).isLessThan(1e-5);
  }

  @Test
  void leavesALineWhenTheSpeedHasFallen() throws MotionRefusedException {
    double half = nearestToTheCorner(new Speed(50));
    double whole = nearestToTheCorner(new Speed(100));

    assertThat(nearestToTheCorner(new Speed(0))).isLessThan(1e-3);
    assertThat(half).isGreaterThan(1);
    // Half of the time is a quarter of the way.
    assertThat(whole).isCloseTo(4 * half, within(0.2 * whole));
  }

  @Test
  void leavesALineWhenTheOrientationIsNear() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame corner = product(moved(FROM, 0, 100, 0), new Frame(0, 0, 0, 30, 0, 0));
    ride.lin(corner, new Orientation(2));
    ride.lin(moved(corner, -100, 0, 0));
    ride.toTheEnd();

    assertThat(ride.flanges())
        .filteredOn(flange -> angle(flange, corner) > 2.001)
        .allMatch(flange -> Math.abs(flange.x() - FROM.x()) < 0.001);
    assertThat(ride.flanges()).noneMatch(flange -> flange.distance(corner) < 0.1);
  }

  @Test
  void blendsFromAxesToPathAndBack() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(START, Ride.FULL, new AxisDistance(50));
    Frame second = moved(FROM, 0, 100, 0);
    ride.lin(second, new Distance(20));
    ride.ptp(HOME.with(0, -30));
    ride.toTheEnd();

    assertThat(ride.system.axes()).isEqualTo(HOME.with(0, -30));
    assertThat(ride.flanges())
        .noneMatch(flange -> flange.distance(FROM) < 0.1)
        .noneMatch(flange -> flange.distance(second) < 0.1);
    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakSpeed(axis)).isLessThan(ROBOT.maxSpeed(axis) * 1.00001);
      assertThat(ride.peakAcceleration(axis)).isLessThan(ROBOT.maxAcceleration(axis) * 1.5);
    }
  }

  @Test
  void blendsTheAxesOfPathsOfTwoTools() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame tool = new Frame(0, 0, 100, 0, 0, 0);
    Frame corner = moved(FROM, 0, 100, 0);
    Frame end = product(moved(corner, -100, 0, 0), tool);
    ride.lin(corner, new Distance(10));
    ride.lin(end, tool, Ride.PATH, OrientationControl.VAR, new Exact());
    ride.toTheEnd();

    assertThat(product(ROBOT.forward(ride.system.axes()), tool).distance(end)).isLessThan(1e-6);
    assertThat(ride.flanges()).noneMatch(flange -> flange.distance(corner) < 0.5);
    assertThat(ride.flangeSpeeds().subList(3, ride.flangeSpeeds().size() - 3))
        .allMatch(speed -> speed > 0.02);
  }

  @Test
  void passesInTheMiddleOfTheBlend() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    MotionCommand first = ride.ptp(HOME.with(0, 60), Ride.FULL, new AxisDistance(50));
    MotionCommand second = ride.ptp(HOME.with(0, 60).with(1, -40));
    while (ride.events.size() < 2) {
      ride.cycle();
    }

    assertThat(ride.events).containsExactly(new Started(first), new Started(second));
    assertThat(ride.system.current()).contains(first);
    assertThat(ride.system.planned()).isZero();
    double left = ride.system.distanceToEnd();
    while (ride.events.size() < 3) {
      ride.cycle();
    }
    assertThat(ride.events.get(2)).isEqualTo(new Passed(first));
    assertThat(ride.system.current()).contains(second);
    assertThat(left).isGreaterThan(50);
    ride.toTheEnd();
    assertThat(ride.events).last().isEqualTo(new Passed(second));
  }

  @Test
  void turnsBackWithoutStandingIfTheRobotIsTooFastForACorner() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame corner = moved(FROM, 0, 10, 0);
    ride.lin(corner, new Distance(3));
    do {
      ride.cycle();
    } while (ride.system.distanceToEnd() > 2);
    ride.lin(FROM);
    do {
      ride.cycle();
    } while (!ride.system.standing());

    assertThat(ride.system.finished()).isTrue();
    assertThat(ride.system.flange().distance(FROM)).isLessThan(1e-6);
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * 1.05);
  }

  @Test
  void standsOnTheTargetIfNoMotionFollows() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(HOME.with(0, 20), Ride.FULL, new AxisDistance(50));
    ride.toTheEnd();

    assertThat(ride.system.axes()).isEqualTo(HOME.with(0, 20));
  }

  @Test
  void standsOnTheTargetIfTheNextMotionComesTooLate() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    Axis corner = HOME.with(0, 20);
    ride.ptp(corner, Ride.FULL, new AxisDistance(50));
    // 20 degrees take 21.5 cycles; the blend would begin after half of them.
    ride.cycles(12);
    ride.ptp(HOME.with(0, 40));
    ride.toTheEnd();

    assertThat(ride.positions).contains(corner);
    assertThat(ride.system.axes()).isEqualTo(HOME.with(0, 40));
  }

  @Test
  void standsOnTheTargetBeforeAMotionThatLeadsNowhere() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    Axis corner = HOME.with(0, 20);
    ride.ptp(corner, Ride.FULL, new AxisDistance(50));
    ride.ptp(corner, Ride.FULL, new AxisDistance(50));
    ride.ptp(HOME);
    ride.toTheEnd();

    assertThat(ride.positions).contains(corner);
  }

  @Test
  void refusesValuesOutsideOfTheirRange() {
    assertThatThrownBy(() -> new AxisDistance(101))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("C_PTP must be 0 to 100 %, is 101.0");
    assertThatThrownBy(() -> new Distance(-1)).hasMessage("C_DIS must be 0 or more, is -1.0");
    assertThatThrownBy(() -> new Speed(Double.NaN)).hasMessage("C_VEL must be 0 to 100 %, is NaN");
    assertThatThrownBy(() -> new Orientation(-0.1)).hasMessage("C_ORI must be 0 or more, is -0.1");
  }

  private static double nearestToTheCorner(ApproximationZone approximation)
      throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame corner = moved(FROM, 0, 100, 0);
    ride.lin(corner, approximation);
    ride.lin(moved(corner, -100, 0, 0));
    ride.toTheEnd();
    return ride.flanges().stream()
        .mapToDouble(flange -> flange.distance(corner))
        .min()
        .orElseThrow();
  }

  private static Frame moved(Frame from, double x, double y, double z) {
    return new Frame(from.x() + x, from.y() + y, from.z() + z, from.a(), from.b(), from.c());
  }
}
