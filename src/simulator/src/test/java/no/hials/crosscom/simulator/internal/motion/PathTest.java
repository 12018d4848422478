package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.interpolate;
import static no.hials.crosscom.kinematics.Frames.product;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.NotACircle;
import org.junit.jupiter.api.Test;

class PathTest {
  private static final RobotModel ROBOT = Ride.ROBOT;
  private static final ApproximationZone EXACT = new ApproximationZone.Exact();

  /** Away from singularities. */
  private static final Axis START = new Axis(0, -90, 90, 0, 60, 0);

  private static final Frame TOOL = new Frame(30, -20, 100, 10, 20, 30);

  @Test
  void keepsToTheStraightLine() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame from = ROBOT.forward(START);
    Frame to = moved(from, 150, 200, -120, 20, -10, 15);
    ride.lin(to);
    ride.toTheEnd();

    for (Frame flange : ride.flanges()) {
      double part = from.distance(flange) / from.distance(to);
      Frame onTheLine = interpolate(from, to, Math.min(1, part));
      assertThat(flange.distance(onTheLine)).isLessThan(0.001);
      assertThat(angle(flange, onTheLine)).isLessThan(0.001);
    }
    assertThat(ride.system.flange().distance(to)).isLessThan(1e-6);
    assertThat(angle(ride.system.flange(), to)).isLessThan(1e-6);
  }

  @Test
  void takesTheTimeOfATrapezoidAndKeepsItsSpeedAndAcceleration() throws MotionRefusedException {
    Ride ride = new Ride(START);
    PathRates rates = new PathRates(0.25, 2.3, 200, 100);
    Frame to = moved(ROBOT.forward(START), 0, 300, 0, 0, 0, 0);
    ride.lin(to, Frame.IDENTITY, rates, OrientationControl.VAR, EXACT);
    double time = 0.3 / 0.25 + 0.25 / 2.3;

    assertThat(ride.toTheEnd()).isEqualTo((int) Math.ceil(time / Interpolator.CYCLE));
    assertThat(ride.flangeSpeeds()).allMatch(speed -> speed < 0.25 * 1.00001);
    assertThat(ride.peakPathAcceleration()).isBetween(2.3 * 0.99, 2.3 * 1.00001);
  }

  @Test
  void goesAtTheRateOfTheOrientationIfThatTakesLonger() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame from = ROBOT.forward(START);
    Frame to = product(from, new Frame(10, 0, 0, 60, 0, 0));
    ride.lin(to);

    double time = 2 * Math.sqrt(60.0 / 100);
    assertThat(ride.toTheEnd()).isEqualTo((int) Math.ceil(time / Interpolator.CYCLE));
  }

  @Test
  void turnsOnTheSpot() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame from = product(ROBOT.forward(START), TOOL);
    Frame to = product(from, new Frame(0, 0, 0, 20, 10, 0));
    ride.lin(to, TOOL, Ride.PATH, OrientationControl.VAR, EXACT);
    ride.toTheEnd();

    assertThat(ride.positions)
        .allMatch(axes -> product(ROBOT.forward(axes), TOOL).distance(from) < 0.001);
    assertThat(angle(product(ROBOT.forward(ride.system.axes()), TOOL), to)).isLessThan(1e-6);
  }

  @Test
  void keepsTheTcpOfATurningToolOnTheLine() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame from = product(ROBOT.forward(START), TOOL);
    Frame to = product(moved(from, 100, 150, -50, 0, 0, 0), new Frame(0, 0, 0, 30, -20, 25));
    ride.lin(to, TOOL, Ride.PATH, OrientationControl.VAR, EXACT);
    ride.toTheEnd();

    for (Axis axes : ride.positions) {
      Frame tcp = product(ROBOT.forward(axes), TOOL);
      double part = Math.min(1, from.distance(tcp) / from.distance(to));
      assertThat(tcp.distance(interpolate(from, to, part))).isLessThan(0.001);
    }
    assertThat(product(ROBOT.forward(ride.system.axes()), TOOL).distance(to)).isLessThan(1e-6);
  }

  @Test
  void keepsTheOrientationOfTheStartIfItIsConstant() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame from = ROBOT.forward(START);
    Frame to = moved(from, 100, 100, 0, 40, 40, 40);
    ride.lin(to, Frame.IDENTITY, Ride.PATH, OrientationControl.CONSTANT, EXACT);
    ride.toTheEnd();

    assertThat(ride.flanges()).allMatch(flange -> angle(flange, from) < 1e-5);
    assertThat(ride.system.flange().distance(to)).isLessThan(1e-6);
  }

  @Test
  void turnsTheWristAxesEvenlyIfToldTo() throws MotionRefusedException {
    Axis start = new Axis(10, -80, 100, 20, 30, 10);
    Ride ride = new Ride(start);
    Frame from = product(ROBOT.forward(start), TOOL);
    Frame to = product(ROBOT.forward(new Axis(-20, -70, 95, -60, -40, 50)), TOOL);
    ride.lin(to, TOOL, Ride.PATH, OrientationControl.JOINT, EXACT);
    ride.toTheEnd();

    Axis end = ride.system.axes();
    for (Axis axes : ride.positions) {
      double part = (axes.a4() - start.a4()) / (end.a4() - start.a4());
      assertThat(axes.a5()).isCloseTo(start.a5() + part * (end.a5() - start.a5()), within(1e-6));
      assertThat(axes.a6()).isCloseTo(start.a6() + part * (end.a6() - start.a6()), within(1e-6));
      Frame tcp = product(ROBOT.forward(axes), TOOL);
      assertThat(tcp.distance(interpolate(from, to, part))).isLessThan(0.001);
    }
    Frame last = product(ROBOT.forward(end), TOOL);
    assertThat(last.distance(to)).isLessThan(1e-6);
    assertThat(angle(last, to)).isLessThan(1e-4);
  }

  @Test
  void keepsToTheCircleThroughThreePoints() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame from = ROBOT.forward(START);
    Frame centre = moved(from, -80, 0, 0, 0, 0, 0);
    Frame to = moved(from, -160, 0, 0, 10, 0, 0);
    ride.circ(moved(from, -80, 80, 0, 0, 0, 0), to, OptionalDouble.empty(), OrientationControl.VAR);
    ride.toTheEnd();

    for (Frame flange : ride.flanges()) {
      assertThat(flange.distance(centre)).isCloseTo(80, within(0.001));
      assertThat(flange.z()).isCloseTo(from.z(), within(0.001));
      assertThat(flange.y()).isGreaterThan(from.y() - 0.001);
    }
    assertThat(ride.system.flange().distance(to)).isLessThan(1e-6);
    assertThat(angle(ride.system.flange(), to)).isLessThan(1e-6);
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * 1.01);
  }

  @Test
  void goesRoundByTheCircularAngle() throws MotionRefusedException {
    Frame from = ROBOT.forward(START);
    Frame auxiliary = moved(from, -60, 60, 0, 0, 0, 0);
    Frame target = moved(from, -120, 0, 0, 0, 0, 0);

    assertThat(endOfCircle(auxiliary, target, 90).distance(auxiliary)).isLessThan(1e-6);
    assertThat(endOfCircle(auxiliary, target, 360).distance(from)).isLessThan(1e-6);
    assertThat(endOfCircle(auxiliary, target, -90).distance(moved(from, -60, -60, 0, 0, 0, 0)))
        .isLessThan(1e-6);
    assertThat(endOfCircle(auxiliary, target, -540).distance(target)).isLessThan(1e-6);
  }

  @Test
  void goesTheLongWayIfTheAuxiliaryPointLiesThere() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame from = ROBOT.forward(START);
    Frame auxiliary = moved(from, -120, 0, 0, 0, 0, 0);
    ride.circ(
        auxiliary,
        moved(from, -60, 60, 0, 0, 0, 0),
        OptionalDouble.empty(),
        OrientationControl.CONSTANT);
    ride.toTheEnd();

    assertThat(ride.flanges()).anyMatch(flange -> flange.distance(auxiliary) < 5);
    assertThat(ride.system.flange().y()).isCloseTo(from.y() + 60, within(1e-6));
  }

  @Test
  void refusesPointsThroughWhichNoCircleGoes() {
    Ride ride = new Ride(START);
    Frame from = ROBOT.forward(START);
    Frame on = moved(from, 50, 0, 0, 0, 0, 0);

    assertThatThrownBy(
            () ->
                ride.circ(
                    on,
                    moved(from, 90, 0, 0, 0, 0, 0),
                    OptionalDouble.empty(),
                    OrientationControl.VAR))
        .isInstanceOf(MotionRefusedException.class)
        .hasMessageContaining("three points that are not on one line")
        .extracting(e -> ((MotionRefusedException) e).problem())
        .isEqualTo(new NotACircle());
    assertThatThrownBy(() -> ride.circ(on, from, OptionalDouble.empty(), OrientationControl.VAR))
        .hasMessageContaining("three points");
    assertThatThrownBy(() -> ride.circ(from, on, OptionalDouble.of(90), OrientationControl.VAR))
        .hasMessageContaining("three points");
    assertThatThrownBy(
            () -> ride.circ(from, on, OptionalDouble.of(Double.NaN), OrientationControl.VAR))
        .hasMessage("the circular angle must be finite, is NaN");
  }

  @Test
  void slowsDownBesideASingularitySoThatNoAxisExceedsItsSpeed() throws MotionRefusedException {
    Axis start = new Axis(0, -90, 90, 20, 20, 0);
    Frame from = ROBOT.forward(start);
    Ride ride = new Ride(start);
    // The axis of the flange passes that of A4 with little between them: A4 has to swing round.
    Frame to = ROBOT.forward(new Axis(0, -90, 90, 170, 10, -150));
    ride.lin(to, Frame.IDENTITY, new PathRates(2, 10, 400, 1000), OrientationControl.VAR, EXACT);
    int cycles = ride.toTheEnd();

    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakSpeed(axis)).isLessThan(ROBOT.maxSpeed(axis) * 1.00001);
      assertThat(ride.peakAcceleration(axis)).isLessThan(ROBOT.maxAcceleration(axis) * 1.3);
    }
    assertThat(ride.peakSpeed(3)).isGreaterThan(ROBOT.maxSpeed(3) * 0.5);
    double unlimited = 2 * Math.sqrt(angle(from, to) / 1000);
    assertThat(cycles * Interpolator.CYCLE).isGreaterThan(1.2 * unlimited);
    for (Frame flange : ride.flanges()) {
      double part = Math.min(1, angle(from, flange) / angle(from, to));
      assertThat(angle(flange, interpolate(from, to, part))).isLessThan(0.001);
    }
  }

  @Test
  void goesStraightThroughTheSingularityOfTheWrist() throws MotionRefusedException {
    Axis start = new Axis(0, -90, 90, 0, 30, 0);
    Ride ride = new Ride(start);
    Frame to = ROBOT.forward(new Axis(0, -90, 90, 0, -30, 0));
    ride.lin(to);
    ride.toTheEnd();

    assertThat(ride.system.axes().largestDifference(new Axis(0, -90, 90, 0, -30, 0)))
        .isLessThan(1e-6);
  }

  @Test
  void takesACycleToGoNowhere() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame here = product(ROBOT.forward(START), TOOL);
    ride.lin(here, TOOL, Ride.PATH, OrientationControl.VAR, new ApproximationZone.Distance(3));
    ride.lin(here, TOOL, Ride.PATH, OrientationControl.VAR, new ApproximationZone.Distance(3));

    assertThat(ride.toTheEnd()).isEqualTo(2);
    assertThat(ride.system.axes().largestDifference(START)).isLessThan(1e-6);
  }

  @Test
  void measuresWhatIsLeftAlongThePath() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame from = ROBOT.forward(START);
    ride.lin(moved(from, 0, 200, 0, 0, 0, 0));
    ride.cycles(20);

    double done = ride.system.flange().distance(from);
    assertThat(ride.system.distanceToEnd()).isCloseTo(200 - done, within(1e-3));
    assertThat(ride.system.pathVelocity()).isCloseTo(ride.flangeSpeeds().get(19), within(1e-9));
  }

  @Test
  void refusesRatesThatAreNotAboveZero() {
    assertThatThrownBy(() -> new PathRates(0, 1, 1, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("velocity must be above 0 and finite, is 0.0");
    assertThatThrownBy(() -> new PathRates(1, 1, Double.POSITIVE_INFINITY, 1))
        .hasMessage("turn velocity must be above 0 and finite, is Infinity");
  }

  private static Frame endOfCircle(Frame auxiliary, Frame target, double angle)
      throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.circ(auxiliary, target, OptionalDouble.of(angle), OrientationControl.VAR);
    ride.toTheEnd();
    return ride.system.flange();
  }

  private static Frame moved(
      Frame from, double x, double y, double z, double a, double b, double c) {
    return new Frame(
        from.x() + x, from.y() + y, from.z() + z, from.a() + a, from.b() + b, from.c() + c);
  }
}
