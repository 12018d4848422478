package no.hials.crosscom.simulator.internal.motion;

import static no.hials.crosscom.kinematics.Frames.interpolate;
import static no.hials.crosscom.kinematics.Frames.product;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Faulted;
import no.hials.crosscom.simulator.internal.motion.MotionEvent.Started;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.AxisLimit;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.OutOfReach;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.Singularity;
import org.junit.jupiter.api.Test;

class FaultedMotionTest {
  private static final RobotModel ROBOT = Ride.ROBOT;
  private static final Axis START = new Axis(0, -90, 90, 0, 60, 0);
  private static final Frame FROM = ROBOT.forward(START);

  @Test
  void standsWhereALineLeavesTheReachOfTheRobot() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame to = moved(FROM, 600, 0, 0);
    MotionCommand motion = ride.lin(to);
    ride.ptp(START);
    ride.toTheEnd();

    Faulted fault = (Faulted) ride.events.get(1);
    assertThat(ride.events).hasSize(2).startsWith(new Started(motion));
    assertThat(fault.motion()).isEqualTo(motion);
    assertThat(fault.problem()).isInstanceOf(OutOfReach.class);
    assertThat(fault.problem().message()).isNotBlank();
    assertThat(fault.axes()).isEqualTo(ride.system.axes());
    assertStandsOnTheLine(ride, to);
    assertThat(ride.system.flange().x()).isGreaterThan(FROM.x() + 100);
    assertThat(ride.system.planned()).isZero();
    assertThat(ride.system.plannedEnd().robot()).isEqualTo(ride.system.axes());
  }

  @Test
  void standsWhereAnAxisOfALineIsAtItsLimit() throws MotionRefusedException {
    Ride ride = new Ride(ROBOT.withLimits(limits(-1, 20), limits(1, 20)), START);
    Frame to = moved(FROM, 0, 300, 0);
    ride.lin(to);
    ride.toTheEnd();

    Faulted fault = (Faulted) ride.events.get(1);
    AxisLimit problem = (AxisLimit) fault.problem();
    assertThat(problem.axis()).isZero();
    assertThat(problem.limit()).isEqualTo(-20);
    double asked = -Math.toDegrees(Math.atan2(300, FROM.x()));
    assertThat(problem.value()).isLessThan(-25).isGreaterThan(asked - 15);
    assertThat(problem.message()).startsWith("A1 must be at least -20.000 degrees, would be -");
    assertThat(ride.system.axes().a1()).isBetween(-20.0, -19.999);
    assertStandsOnTheLine(ride, to);
  }

  @Test
  void standsWhereAnAxisOfACircleIsAtItsLimit() throws MotionRefusedException {
    Ride ride = new Ride(ROBOT.withLimits(limits(-1, 5), limits(1, 170)), START);
    ride.circ(
        moved(FROM, -100, 100, 0),
        moved(FROM, -200, 0, 0),
        OptionalDouble.empty(),
        OrientationControl.VAR);
    ride.toTheEnd();

    assertThat(((Faulted) ride.events.get(1)).problem()).isInstanceOf(AxisLimit.class);
    assertThat(ride.system.axes().a1()).isCloseTo(-5, within(0.001));
    assertThat(ride.system.flange().distance(moved(FROM, -100, 0, 0))).isCloseTo(100, within(0.01));
  }

  @Test
  void standsBeforeAnAxisWouldHaveToJump() throws MotionRefusedException {
    // A little off the axis of A1, so that A1 would have to make half a turn in no time.
    Axis start = new Axis(0, -130, 130, 0, 90, 0);
    Frame from = ROBOT.forward(start);
    Ride ride = new Ride(start);
    Frame wrist = product(from, new Frame(0, 0, -80, 0, 0, 0));
    ride.lin(moved(from, -2 * wrist.x(), 0.0024, 0));
    ride.toTheEnd();

    assertThat(ride.events).hasSize(2);
    MotionProblem problem = ((Faulted) ride.events.get(1)).problem();
    assertThat(problem).isInstanceOf(Singularity.class);
    assertThat(problem.message()).matches("A\\d would have to jump by .* degrees in a singularity");
    assertThat(product(ride.system.flange(), new Frame(0, 0, -80, 0, 0, 0)).x())
        .isCloseTo(0, within(0.01));
  }

  @Test
  void goesAsFarAsItCanWithTheWristAxesTurningEvenly() throws MotionRefusedException {
    Ride ride = new Ride(START);
    Frame to = moved(FROM, 600, 0, 0);
    ride.lin(
        to, Frame.IDENTITY, Ride.PATH, OrientationControl.JOINT, new ApproximationZone.Exact());
    ride.toTheEnd();

    assertThat(((Faulted) ride.events.get(1)).problem()).isInstanceOf(OutOfReach.class);
    assertStandsOnTheLine(ride, to);
  }

  @Test
  void doesNotReachWithTheWristAxesTurningEvenly() throws MotionRefusedException {
    // Both ends can be reached, but not what lies between them with the tool turned away.
    Axis start = new Axis(-80, -5, 10, 0, 0, 0);
    Frame tool = new Frame(300, 0, 100, 0, 0, 0);
    Ride ride = new Ride(start);
    Frame to = product(ROBOT.forward(start.with(0, 80).with(5, 180)), tool);
    ride.lin(to, tool, Ride.PATH, OrientationControl.JOINT, new ApproximationZone.Exact());
    ride.toTheEnd();

    assertThat(ride.events).hasSize(2);
    assertThat(ride.events.get(1)).isInstanceOf(Faulted.class);
    assertThat(ride.system.standing()).isTrue();
  }

  @Test
  void doesNotBlendOutOfAMotionThatCannotEnd() throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.lin(moved(FROM, 600, 0, 0), new ApproximationZone.Distance(50));
    ride.lin(FROM);
    ride.toTheEnd();

    assertThat(ride.events).hasSize(2);
    assertThat(ride.system.finished()).isTrue();
  }

  @Test
  void movesOnFromWhereItStands() throws MotionRefusedException {
    Ride ride = new Ride(START);
    ride.lin(moved(FROM, 600, 0, 0));
    ride.toTheEnd();
    ride.ptp(START);
    ride.toTheEnd();

    assertThat(ride.system.axes()).isEqualTo(START);
  }

  private static Axis limits(int sign, double first) {
    return new Axis(
        sign * first,
        sign < 0 ? -190 : 45,
        sign < 0 ? -120 : 156,
        sign * 185,
        sign * 120,
        sign * 350);
  }

  private static void assertStandsOnTheLine(Ride ride, Frame to) {
    for (Frame flange : ride.flanges()) {
      double part = Math.min(1, FROM.distance(flange) / FROM.distance(to));
      assertThat(flange.distance(interpolate(FROM, to, part))).isLessThan(0.01);
    }
    assertThat(ride.peakPathAcceleration()).isLessThan(2.3 * 1.05);
    assertThat(ride.system.standing()).isTrue();
    assertThat(ride.system.finished()).isTrue();
  }

  private static Frame moved(Frame from, double x, double y, double z) {
    return new Frame(from.x() + x, from.y() + y, from.z() + z, from.a(), from.b(), from.c());
  }
}
