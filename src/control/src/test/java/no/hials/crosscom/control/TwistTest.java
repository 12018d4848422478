package no.hials.crosscom.control;

import static no.hials.crosscom.kinematics.Frames.angle;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Velocities of the tool, and the axis velocities for them. */
class TwistTest {
  private static final double TINY = 1e-6;
  private static final RobotModel ROBOT = RobotModel.kr6r900sixx();

  @ParameterizedTest
  @CsvSource({
    "1, 2, 3, 0, 0, 0",
    "0, 0, 0, 40, 0, 0",
    "0, 0, 0, 0, -40, 0",
    "0, 0, 0, 10, 20, -170",
    "5, 0, 0, 1e-7, 0, 0",
    "0, 0, 0, 0, 0, 179.9"
  })
  void whatMovesAFrameLeadsFromItToWhereItComes(
      double x, double y, double z, double aboutX, double aboutY, double aboutZ) {
    Twist twist = new Twist(x, y, z, aboutX, aboutY, aboutZ);
    for (Frame from :
        new Frame[] {
          Frame.IDENTITY, new Frame(9, 8, 7, 30, 90, 0), new Frame(0, 0, 0, 179, -20, -179)
        }) {
      Twist found = Twist.between(from, twist.move(from, 1));

      assertThat(found.plus(twist.times(-1)).speed()).isCloseTo(0, within(TINY));
      assertThat(found.plus(twist.times(-1)).rotationSpeed()).isCloseTo(0, within(TINY));
    }
  }

  @Test
  void aRotationIsAboutTheAxesOfTheBase() {
    Frame turned = new Twist(0, 0, 0, 0, 0, 10).move(new Frame(1, 2, 3, 5, 0, 90), 2);

    assertThat(turned.distance(new Frame(1, 2, 3, 0, 0, 0))).isZero();
    assertThat(angle(turned, new Frame(0, 0, 0, 25, 0, 90))).isCloseTo(0, within(TINY));
  }

  @Test
  void halfATurnIsFoundWhicheverAxisItIsAbout() {
    Twist found = Twist.between(Frame.IDENTITY, new Frame(0, 0, 0, 0, 180, 0));

    assertThat(found.rotationSpeed()).isCloseTo(180, within(TINY));
    assertThat(Math.abs(found.aboutY())).isCloseTo(180, within(TINY));
  }

  @Test
  void dampedLeastSquaresMovesTheFlangeAsWanted() {
    Axis axes = Axis.of(10, -80, 100, 20, 50, -30);
    Twist wanted = new Twist(30, -20, 10, 3, 2, -5);

    Axis velocity = new DampedLeastSquares(ROBOT, 0.01).velocity(axes, wanted);

    Axis moved = axes.plus(Axis.of(scaled(velocity, 1e-3)));
    Twist found = Twist.between(ROBOT.forward(axes), ROBOT.forward(moved)).times(1e3);
    assertThat(found.plus(wanted.times(-1)).speed()).isLessThan(0.05);
    assertThat(found.plus(wanted.times(-1)).rotationSpeed()).isLessThan(0.01);
  }

  private static double[] scaled(Axis axes, double factor) {
    return java.util.Arrays.stream(axes.toArray()).map(value -> value * factor).toArray();
  }

  @Test
  void dampedLeastSquaresKeepsTheAxesSlowInASingularity() {
    Axis singular = Axis.of(0, -90, 90, 0, 0, 0);
    Twist acrossIt = new Twist(0, 0, 0, 10, 0, 10);

    Axis damped = new DampedLeastSquares(ROBOT, 0.3).velocity(singular, acrossIt);

    assertThat(damped.largestDifference(Axis.ZERO)).isLessThan(40);
    assertThat(damped.largestDifference(Axis.ZERO)).isGreaterThan(1);
  }
}
