package no.hials.crosscom.simulator.internal.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.AxisDistance;
import no.hials.crosscom.simulator.internal.motion.ApproximationZone.Distance;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Passed;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import org.junit.jupiter.api.Test;

class InterruptTest {
  private static final RobotModel ROBOT = Ride.ROBOT;
  private static final Axis START = new Axis(0, -90, 90, 0, 60, 0);
  private static final Frame FROM = ROBOT.forward(START);
  private static final Axis ASIDE = new Axis(-40, -80, 80, 10, 40, 20);
  private static final AxisRates BACK = AxisRates.of(50, 50);

  @Test
  void goesBackToThePathAndOn() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame to = moved(FROM, 0, 300, 0);
    MotionCommand first = ride.lin(to);
    MotionCommand second = ride.ptp(START);
    SuspendedPlan suspended = interruptAfter(20, ride);
    Axis left = ride.system.axes();
    assertThat(suspended.axes().robot()).isEqualTo(left);
    assertThat(ride.system.finished()).isTrue();
    assertThat(ride.system.plannedEnd().robot()).isEqualTo(left);

    MotionCommand aside = ride.ptp(ASIDE);
    ride.toTheEnd();
    assertThat(ride.system.axes()).isEqualTo(ASIDE);
    int begin = ride.positions.size();
    ride.system.resume(suspended, BACK);
    assertThat(ride.system.current()).contains(first);
    assertThat(ride.system.planned()).isEqualTo(1);
    assertThat(ride.system.plannedEnd().robot()).isEqualTo(START);
    ride.toTheEnd();

    assertThat(ride.events)
        .containsExactly(
            new Started(first),
            new Started(aside),
            new Passed(aside),
            new Passed(first),
            new Started(second),
            new Passed(second));
    int back = ride.positions.subList(begin, ride.positions.size()).indexOf(left);
    assertThat(back).isPositive();
    int end = begin + back;
    while (ROBOT.forward(ride.positions.get(end)).distance(to) > 1e-6) {
      Frame flange = ROBOT.forward(ride.positions.get(end));
      assertThat(flange.x()).isBetween(FROM.x() - 0.001, FROM.x() + 0.001);
      end++;
    }
    assertThat(ride.system.axes()).isEqualTo(START);
    for (int axis = 0; axis < 6; axis++) {
      assertThat(ride.peakAcceleration(axis)).isLessThan(ROBOT.maxAcceleration(axis) * 1.021);
    }
  }

  @Test
  void goesOnAtOnceIfItHasNotMoved() throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.lin(moved(FROM, 0, 300, 0));
    SuspendedPlan suspended = interruptAfter(20, ride);
    ride.cycles(3);
    ride.system.resume(suspended, BACK);
    ride.toTheEnd();

    assertThat(ride.flanges()).allMatch(flange -> Math.abs(flange.x() - FROM.x()) < 0.001);
    assertThat(ride.events).hasSize(2);
  }

  @Test
  void goesBackToTheMiddleOfABlend() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Axis corner = START.with(0, 40);
    ride.ptp(corner, Ride.FULL, new AxisDistance(50));
    ride.ptp(corner.with(1, -60), Ride.FULL, new AxisDistance(50));
    ride.ptp(START);
    while (ride.system.planned() == 2) {
      ride.cycle();
    }
    SuspendedPlan suspended = interruptAfter(1, ride);
    ride.ptp(ASIDE);
    ride.toTheEnd();
    ride.system.resume(suspended, BACK);
    ride.toTheEnd();

    assertThat(ride.system.axes()).isEqualTo(START);
    assertThat(ride.events).hasSize(8);
    assertThat(ride.positions).doesNotContain(corner);
  }

  @Test
  void canBeInterruptedOnTheWayBack() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame to = moved(FROM, 0, 300, 0);
    MotionCommand first = ride.lin(to);
    ride.lin(FROM);
    SuspendedPlan outer = interruptAfter(20, ride);
    ride.ptp(ASIDE);
    ride.toTheEnd();
    ride.system.resume(outer, BACK);
    SuspendedPlan inner = interruptAfter(10, ride);
    ride.ptp(ASIDE);
    ride.toTheEnd();
    int begin = ride.positions.size();
    ride.system.resume(inner, BACK);
    ride.cycle();
    assertThat(ride.system.finished()).isFalse();
    ride.toTheEnd();

    assertThat(ride.positions.subList(begin, ride.positions.size()))
        .contains(inner.axes().robot(), outer.axes().robot());
    assertThat(ride.events).contains(new Passed(first));
    assertThat(ride.system.flange().distance(FROM)).isLessThan(1e-6);
  }

  @Test
  void takesMotionsOnTheWayBack() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame to = moved(FROM, 0, 300, 0);
    ride.lin(to, new Distance(20));
    SuspendedPlan suspended = interruptAfter(20, ride);
    ride.ptp(ASIDE);
    ride.toTheEnd();
    ride.system.resume(suspended, BACK);
    ride.cycle();
    ride.lin(moved(to, -100, 0, 0));
    ride.toTheEnd();

    assertThat(ride.system.flange().distance(moved(to, -100, 0, 0))).isLessThan(1e-6);
    assertThat(ride.flanges()).noneMatch(flange -> flange.distance(to) < 0.5);
  }

  @Test
  void refusesToPutAsideAPlanWhileItMoves() throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.ptp(ASIDE);
    ride.cycles(5);

    assertThatThrownBy(ride.system::suspend)
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("the robot must stand still before its plan is suspended");
  }

  @Test
  void refusesToTakeUpAPlanWhileAnotherIsUnderWay() throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.ptp(ASIDE);
    SuspendedPlan suspended = interruptAfter(5, ride);
    ride.ptp(ASIDE);

    assertThatThrownBy(() -> ride.system.resume(suspended, BACK))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("cannot resume a plan while another one runs");
  }

  private static SuspendedPlan interruptAfter(int cycles, Ride ride) {
    ride.cycles(cycles);
    ride.system.brake(false);
    ride.toStanding();
    return ride.system.suspend();
  }

  private static Frame moved(Frame from, double x, double y, double z) {
    return new Frame(from.x() + x, from.y() + y, from.z() + z, from.a(), from.b(), from.c());
  }
}
