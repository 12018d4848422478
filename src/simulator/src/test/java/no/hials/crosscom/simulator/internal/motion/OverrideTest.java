package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.interpolate;
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
import org.junit.jupiter.api.Test;

class OverrideTest {
  private static final RobotModel ROBOT = Ride.ROBOT;
  private static final Axis HOME = ROBOT.home();
  private static final Axis START = new Axis(0, -90, 90, 0, 60, 0);
  private static final Frame FROM = ROBOT.forward(START);
  private static final Axis FAR = new Axis(120, -30, 60, 80, -50, 100);

  /** The tolerance of the system itself. */
  private static final double TOLERANCE = 1.021;

  @Test
  void takesTwiceAsLongAtHalfTheOverride() throws MotionRefusedException {
    Ride whole = Ride.fromHome();
    whole.ptp(FAR);
    Ride half = Ride.fromHome();
    half.override = 0.5;
    half.ptp(FAR);

    int cycles = 2 * whole.toTheEnd();
    assertThat(half.toTheEnd()).isBetween(cycles - 2, cycles + 2);
  }

  @Test
  void keepsTheLimitsAndThePathWhenTheOverrideJumps() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(FAR);
    for (double override : new double[] {1, 0.1, 1, 0.02, 0.7, 0, 1}) {
      ride.override = override;
      ride.cycles(9);
    }
    ride.toTheEnd();

    assertThat(ride.system.axes()).isEqualTo(FAR);
    assertKeepsLimits(ride, TOLERANCE);
    assertIsStraight(ride.positions);
  }

  @Test
  void keepsTheLimitsOfThePathWhenTheOverrideJumps() throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.lin(moved(FROM, 0, 300, -100));
    for (double override : new double[] {1, 0.1, 1, 0.02, 0.7, 0, 1}) {
      ride.override = override;
      ride.cycles(12);
    }
    ride.toTheEnd();

    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * TOLERANCE);
    assertIsLine(ride, moved(FROM, 0, 300, -100));
  }

  @Test
  void holdsOnThePathAndGoesOn() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame to = moved(FROM, 0, 300, 0);
    ride.lin(to);
    ride.cycles(20);
    ride.released = false;
    int cycles = ride.toStanding();

    assertThat(cycles).isGreaterThan(3);
    assertThat(ride.system.finished()).isFalse();
    assertThat(ride.system.pathVelocity()).isZero();
    Axis held = ride.system.axes();
    ride.cycles(10);
    assertThat(ride.system.axes()).isEqualTo(held);
    ride.released = true;
    ride.toTheEnd();

    assertIsLine(ride, to);
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * TOLERANCE);
    assertThat(ride.events).hasSize(2);
  }

  @Test
  void stopsAtHalfOfTheProgrammedAccelerationInTwiceTheTime() throws MotionRefusedException {
    assertThat(cyclesToStop(AxisRates.of(50, 50)))
        .isCloseTo(2 * cyclesToStop(AxisRates.of(50, 100)), within(2));
  }

  @Test
  void holdsWithinAChainOfBlends() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    for (int i = 1; i <= 20; i++) {
      ride.ptp(HOME.with(0, i * 0.5), Ride.FULL, new AxisDistance(50));
    }
    ride.cycles(10);
    ride.released = false;

    assertThat(ride.toStanding()).isLessThanOrEqualTo(5);
    assertThat(ride.system.planned()).isPositive();
    ride.released = true;
    ride.toTheEnd();
    assertThat(ride.system.axes()).isEqualTo(HOME.with(0, 10));
    assertKeepsLimits(ride, TOLERANCE);
  }

  @Test
  void holdsWithinAChainOfPathBlends() throws MotionRefusedException {
    Ride ride = new Ride(START);
    for (int i = 1; i <= 20; i++) {
      ride.lin(moved(FROM, 0, 2 * i, 0), new Distance(3));
    }
    ride.cycles(10);
    ride.released = false;
    double speed = ride.system.pathVelocity();

    assertThat(ride.toStanding()).isLessThanOrEqualTo((int) (speed / 2.3 / Interpolator.CYCLE) + 2);
    ride.released = true;
    ride.toTheEnd();
    assertThat(ride.system.flange().distance(moved(FROM, 0, 40, 0))).isLessThan(1e-6);
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * TOLERANCE);
  }

  @Test
  void holdsWhileItOnlyTurns() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame to = product(FROM, new Frame(0, 0, 0, 60, 0, 0));
    ride.lin(to);
    ride.cycles(50);
    ride.released = false;

    assertThat(ride.toStanding()).isGreaterThan(10);
    ride.released = true;
    ride.toTheEnd();
    assertThat(angle(ride.system.flange(), to)).isLessThan(1e-5);
  }

  @Test
  void brakesUntilItIsToldToGoOn() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(FAR);
    ride.cycles(20);
    ride.system.brake(false);
    ride.toStanding();
    Axis held = ride.system.axes();
    ride.cycles(5);

    assertThat(ride.system.axes()).isEqualTo(held);
    ride.system.goOn();
    ride.toTheEnd();
    assertThat(ride.system.axes()).isEqualTo(FAR);
    assertIsStraight(ride.positions);
  }

  @Test
  void brakesAsFastAsTheAxesCan() throws MotionRefusedException {
    AxisRates slow = AxisRates.of(50, 10);
    Ride programmed = Ride.fromHome();
    programmed.ptp(FAR, slow, new ApproximationZone.Exact());
    programmed.cycles(100);
    programmed.system.brake(false);
    Ride maximum = Ride.fromHome();
    maximum.ptp(FAR, slow, new ApproximationZone.Exact());
    maximum.cycles(100);
    maximum.system.brake(true);

    assertThat(maximum.toStanding()).isLessThan(programmed.toStanding() / 5);
    assertKeepsLimits(maximum, TOLERANCE);
    assertIsStraight(maximum.positions);
  }

  @Test
  void brakesAPathAsFastAsTheAxesCan() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame to = moved(FROM, 0, 300, 0);
    ride.lin(to);
    ride.cycles(30);
    ride.system.brake(true);

    assertThat(ride.toStanding()).isLessThan(20);
    assertKeepsLimits(ride, TOLERANCE);
    ride.system.goOn();
    ride.toTheEnd();
    assertIsLine(ride, to);
  }

  @Test
  void cancelsWhatIsPlannedWhenItStands() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(FAR);
    ride.ptp(HOME);
    ride.cycles(20);
    ride.system.cancel();

    assertThat(ride.system.finished()).isFalse();
    assertThatThrownBy(() -> ride.ptp(HOME))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("no motion can be added while the robot brakes to cancel");
    ride.toStanding();
    assertThat(ride.system.finished()).isTrue();
    assertThat(ride.system.plannedEnd().robot()).isEqualTo(ride.system.axes());
    ride.ptp(HOME);
    ride.toTheEnd();
    assertThat(ride.system.axes()).isEqualTo(HOME);
    assertKeepsLimits(ride, TOLERANCE);
  }

  @Test
  void cancelsAtOnceWhenItStands() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(FAR);
    ride.system.cancel();

    assertThat(ride.system.finished()).isTrue();
    assertThat(ride.system.plannedEnd().robot()).isEqualTo(HOME);
    assertThat(ride.system.current()).isEmpty();
  }

  @Test
  void givesTheSameTrajectoryEveryTime() throws MotionRefusedException {
    assertThat(mixed().positions).isEqualTo(mixed().positions);
    assertThat(mixed().events).isEqualTo(mixed().events);
  }

  @Test
  void refusesAnOverrideOutsideOfItsRange() {
    Interpolator system = new Interpolator(ROBOT, HOME);

    assertThatThrownBy(() -> system.cycle(1.01, true))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("the override must be 0 to 1, is 1.01");
    assertThatThrownBy(() -> system.cycle(-0.01, true)).hasMessageContaining("-0.01");
    assertThatThrownBy(() -> system.cycle(Double.NaN, true)).hasMessageContaining("NaN");
  }

  private static Ride mixed() throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(START, Ride.FULL, new AxisDistance(50));
    ride.lin(moved(FROM, 0, 200, -50), new Distance(20));
    ride.lin(moved(FROM, -100, 100, 0), new Distance(20));
    ride.ptp(FAR);
    for (double override : new double[] {1, 0.3, 0, 0.9, 1}) {
      ride.override = override;
      ride.cycles(17);
    }
    ride.toTheEnd();
    return ride;
  }

  private static int cyclesToStop(AxisRates rates) throws MotionRefusedException {
    Ride ride = Ride.fromHome();
    ride.ptp(HOME.with(0, 160), rates, new ApproximationZone.Exact());
    ride.cycles(40);
    ride.released = false;
    return ride.toStanding();
  }

  private static void assertKeepsLimits(Ride ride, double tolerance) {
    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakSpeed(axis)).isLessThan(ROBOT.maxSpeed(axis) * tolerance);
      assertThat(ride.peakAcceleration(axis)).isLessThan(ROBOT.maxAcceleration(axis) * tolerance);
    }
  }

  /** Asserts that all axes have moved by the same part of their distance. */
  private static void assertIsStraight(List<Axis> positions) {
    for (Axis position : positions) {
      double part = (position.a1() - HOME.a1()) / (FAR.a1() - HOME.a1());
      Axis way = FAR.minus(HOME);
      for (int axis = 1; axis < 6; axis++) {
        assertThat(position.get(axis))
            .isCloseTo(HOME.get(axis) + part * way.get(axis), within(1e-9));
      }
    }
  }

  private static void assertIsLine(Ride ride, Frame to) {
    for (Frame flange : ride.flanges()) {
      double part = Math.min(1, FROM.distance(flange) / FROM.distance(to));
      assertThat(flange.distance(interpolate(FROM, to, part))).isLessThan(0.001);
    }
    assertThat(ride.system.flange().distance(to)).isLessThan(1e-6);
  }

  private static Frame moved(Frame from, double x, double y, double z) {
    return new Frame(from.x() + x, from.y() + y, from.z() + z, from.a(), from.b(), from.c());
  }
}
