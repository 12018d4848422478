package no.hials.crosscom.simulator.internal.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Passed;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.AxisLimit;
import org.junit.jupiter.api.Test;

class PointToPointTest {
  private static final RobotModel ROBOT = Ride.ROBOT;
  private static final Axis HOME = ROBOT.home();
  private static final ApproximationZone EXACT = new ApproximationZone.Exact();

  @Test
  void takesTheTimeOfATrapezoid() throws MotionRefusedException {
    Ride ride = new Ride(HOME);
    ride.ptp(HOME.with(0, 120));
    double speed = ROBOT.maxSpeed(0);
    double time = 120 / speed + speed / ROBOT.maxAcceleration(0);

    assertThat(ride.toTheEnd()).isEqualTo((int) Math.ceil(time / Interpolator.CYCLE));
    assertThat(ride.system.axes()).isEqualTo(HOME.with(0, 120));
  }

  @Test
  void takesTheTimeOfATriangleWhenItCannotReachItsSpeed() throws MotionRefusedException {
    Ride ride = new Ride(HOME);
    ride.ptp(HOME.with(0, 20));
    double time = 2 * Math.sqrt(20 / ROBOT.maxAcceleration(0));

    assertThat(ride.toTheEnd()).isEqualTo((int) Math.ceil(time / Interpolator.CYCLE));
  }

  @Test
  void scalesWithTheRatesOfTheAxes() throws MotionRefusedException {
    Ride ride = new Ride(HOME);
    ride.ptp(HOME.with(0, 120), AxisRates.of(10, 50), EXACT);
    double speed = ROBOT.maxSpeed(0) * 0.1;
    double acceleration = ROBOT.maxAcceleration(0) * 0.5;

    assertThat(ride.toTheEnd())
        .isEqualTo((int) Math.ceil((120 / speed + speed / acceleration) / Interpolator.CYCLE));
    assertThat(ride.peakSpeed(0)).isCloseTo(speed, within(1e-6));
    assertThat(ride.peakAcceleration(0)).isBetween(acceleration * 0.99, acceleration * 1.0001);
  }

  @Test
  void startsAndEndsAllAxesTogether() throws MotionRefusedException {
    Ride ride = new Ride(HOME);
    Axis target = new Axis(60, -60, 100, -45, 30, 90);
    ride.ptp(target);
    ride.toTheEnd();

    for (Axis position : ride.positions) {
      double part = (position.a1() - HOME.a1()) / (target.a1() - HOME.a1());
      for (int axis = 1; axis < 6; axis++) {
        double way = target.get(axis) - HOME.get(axis);
        assertThat(position.get(axis)).isCloseTo(HOME.get(axis) + part * way, within(1e-9));
      }
    }
    assertThat(ride.system.axes()).isEqualTo(target);
  }

  @Test
  void keepsEveryAxisWithinItsSpeedAndAcceleration() throws MotionRefusedException {
    Ride ride = new Ride(new Axis(-150, -180, 150, -180, -110, -340));
    ride.ptp(new Axis(150, 30, -110, 180, 110, 340));
    ride.toTheEnd();

    boolean oneIsAtItsLimit = false;
    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakSpeed(axis)).isLessThan(ROBOT.maxSpeed(axis) * 1.000001);
      assertThat(ride.peakAcceleration(axis)).isLessThan(ROBOT.maxAcceleration(axis) * 1.000001);
      oneIsAtItsLimit |= ride.peakSpeed(axis) > ROBOT.maxSpeed(axis) * 0.999;
    }
    assertThat(oneIsAtItsLimit).isTrue();
  }

  @Test
  void tellsWhenItStartsAndWhenItHasEnded() throws MotionRefusedException {
    Ride ride = new Ride(HOME);
    MotionCommand first = ride.ptp(HOME.with(0, 5));
    MotionCommand second = ride.ptp(HOME);

    assertThat(ride.system.planned()).isEqualTo(2);
    assertThat(ride.system.current()).isEmpty();
    ride.cycle();
    assertThat(ride.events).containsExactly(new Started(first));
    assertThat(ride.system.planned()).isEqualTo(1);
    assertThat(ride.system.current()).contains(first);
    assertThat(ride.system.standing()).isFalse();
    assertThat(ride.system.currentStart().robot()).isEqualTo(HOME);
    assertThat(ride.system.currentEnd().robot()).isEqualTo(HOME.with(0, 5));
    ride.toTheEnd();
    assertThat(ride.events)
        .containsExactly(
            new Started(first), new Passed(first), new Started(second), new Passed(second));
    assertThat(ride.system.current()).isEmpty();
    assertThat(ride.system.standing()).isTrue();
    assertThat(ride.system.axisVelocity()).isEqualTo(Axis.ZERO);
    assertThat(ride.system.currentEnd().robot()).isEqualTo(HOME);
    assertThat(ride.system.currentStart().robot()).isEqualTo(HOME);
    assertThat(ride.system.distanceToEnd()).isZero();
  }

  @Test
  void takesACycleToGoNowhere() throws MotionRefusedException {
    Ride ride = new Ride(HOME);
    ride.override = 0.1;
    for (int i = 0; i < 3; i++) {
      ride.ptp(HOME, Ride.FULL, new ApproximationZone.AxisDistance(50));
    }

    assertThat(ride.toTheEnd()).isEqualTo(3);
    assertThat(ride.events).hasSize(6);
    assertThat(ride.positions).containsOnly(HOME);
  }

  @Test
  void doesNotStartAtOverrideZero() throws MotionRefusedException {
    Ride ride = new Ride(HOME);
    ride.override = 0;
    ride.ptp(HOME.with(0, 1));
    ride.cycles(3);

    assertThat(ride.events).isEmpty();
    assertThat(ride.system.finished()).isFalse();
    assertThat(ride.system.axes()).isEqualTo(HOME);
  }

  @Test
  void measuresSpeedsOverTheLastCycle() throws MotionRefusedException {
    Ride ride = new Ride(HOME);
    ride.ptp(HOME.with(0, 120));
    ride.cycles(27);

    assertThat(ride.system.axisVelocity().a1()).isCloseTo(ROBOT.maxSpeed(0), within(1e-6));
    assertThat(ride.system.axisVelocity().a2()).isZero();
    double speed = Math.toRadians(ROBOT.maxSpeed(0)) * 0.525;
    assertThat(ride.system.pathVelocity()).isCloseTo(speed, within(0.001));
    assertThat(ride.system.flange()).isEqualTo(ROBOT.forward(ride.system.axes()));
    double left = ROBOT.forward(HOME.with(0, 120)).distance(ride.system.flange());
    assertThat(ride.system.distanceToEnd()).isCloseTo(left, within(1e-9));
  }

  @Test
  void refusesATargetBeyondALimit() {
    Ride ride = new Ride(HOME);

    assertThatThrownBy(() -> ride.ptp(HOME.with(2, 160)))
        .isInstanceOf(MotionRefusedException.class)
        .hasMessage("A3 must be at most 156.000 degrees, would be 160.000")
        .extracting(e -> ((MotionRefusedException) e).problem())
        .isEqualTo(new AxisLimit(2, 156, 160));
    assertThatThrownBy(() -> ride.ptp(HOME.with(1, -191)))
        .hasMessage("A2 must be at least -190.000 degrees, would be -191.000");
    assertThat(ride.system.planned()).isZero();
    assertThat(ride.system.plannedEnd().robot()).isEqualTo(HOME);
  }

  @Test
  void takesATargetAtALimitOfTheRobot() throws MotionRefusedException {
    RobotModel narrow =
        ROBOT.withLimits(new Axis(-10, -91, 80, -1, -1, -1), new Axis(10, -80, 100, 1, 1, 1));
    Ride ride = new Ride(narrow, HOME);
    ride.ptp(HOME.with(0, 10.00001));
    ride.toTheEnd();

    assertThat(ride.system.axes()).isEqualTo(HOME.with(0, 10));
  }

  @Test
  void refusesRatesOutsideOfTheirRange() {
    assertThatThrownBy(() -> AxisRates.of(0, 100))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("velocity of an axis must be above 0 to 100 %, is 0.0");
    assertThatThrownBy(() -> AxisRates.of(100, 100.5))
        .hasMessage("acceleration of an axis must be above 0 to 100 %, is 100.5");
  }
}
