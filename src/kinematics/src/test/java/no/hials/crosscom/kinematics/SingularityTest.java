package no.hials.crosscom.kinematics;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Robots.INVENTED;
import static no.hials.crosscom.kinematics.Robots.KR6;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class SingularityTest {

  /** A5 = 0: only the sum of A4 and A6 determines the flange. */
  private static final Axis WRIST = Axis.of(20, -80, 100, 30, 0, 40);

  /** The wrist centre 800 mm above A2's level, on A1, and the flange 80 mm above it. */
  private static final Frame OVERHEAD = new Frame(0, 0, 1280, 0, 0, 0);

  @Test
  void theWristGetsA4AtZeroByStatusAndTurn() throws Exception {
    Axis found = KR6.inverse(KR6.forward(WRIST), 6, 2);

    assertThat(found.largestDifference(Axis.of(20, -80, 100, 0, 0, 70))).isLessThan(1e-6);
  }

  @Test
  void theWristKeepsA4OnAPath() throws Exception {
    Axis found = KR6.inverse(KR6.forward(WRIST), WRIST.with(5, 45));

    assertThat(found.largestDifference(WRIST)).isLessThan(1e-6);
  }

  @Test
  void theWristKeepsA4OnAPathWhen32BitsHaveLostTheZeroOfA5() throws Exception {
    Frame flange = KR6.forward(WRIST.with(4, 5e-5));

    Axis found = KR6.inverse(flange, WRIST);

    assertThat(found.a4()).isEqualTo(30, within(1e-9));
    assertThat(found.a5()).isZero();
    assertThat(angle(KR6.forward(found), flange)).isLessThan(1e-4);
  }

  @Test
  void aPathThroughTheWristSingularityLetsA5ChangeSides() throws Exception {
    Axis axes = WRIST.with(4, 10);
    for (int step = 99; step >= -100; step--) {
      Axis expected = WRIST.with(4, step / 10.0);
      axes = KR6.inverse(KR6.forward(expected), axes);
      assertThat(axes.largestDifference(expected)).isLessThan(1e-6);
    }
  }

  @Test
  void overheadGetsA1AtZeroByStatusAndTurn() throws Exception {
    Axis found = KR6.inverse(OVERHEAD, 2, 2);

    assertThat(found.a1()).isZero();
    assertThat(KR6.forward(found).distance(OVERHEAD)).isLessThan(1e-6);
  }

  @Test
  void overheadHasTheSameSolutionsInFrontAndBehind() {
    assertThat(KR6.inverse(OVERHEAD)).hasSize(4);
  }

  @Test
  void overheadKeepsA1OnAPathThroughIt() throws Exception {
    Axis axes = KR6.inverse(OVERHEAD, 2, 2).with(0, 30);
    Vector forward = Rotation.aboutZ(-30).rotate(new Vector(1, 0, 0));

    for (double way : new double[] {0, 5, 0, -5}) {
      Frame flange =
          new Frame(forward.x() * way, forward.y() * way, OVERHEAD.z(), OVERHEAD.a(), 0, 0);
      axes = KR6.inverse(flange, axes);
      assertThat(axes.a1()).isEqualTo(30, within(1e-9));
      assertThat(KR6.status(axes) & 1).isEqualTo(way < 0 ? 1 : 0);
    }
  }

  @Test
  void theStraightArmIsReachedFromItsOwnFrame() throws Exception {
    Axis straight = Axis.of(10, -40, Robots.STRAIGHT, 0, 30, 0);
    Frame flange = KR6.forward(straight);

    // With a straight arm the error of A3 is the square root of the rounding error.
    assertThat(KR6.inverse(flange, 2, 2).largestDifference(straight)).isLessThan(1e-4);
    assertThat(KR6.inverse(flange, straight).largestDifference(straight)).isLessThan(1e-4);
    assertThat(KR6.inverse(flange)).allSatisfy(axes -> assertBringsBack(axes, flange));
  }

  @Test
  void theStraightArmReachesWhatRoundingPutsBeyondIt() throws Exception {
    double reach = 25 + 455 + Math.hypot(420, 35);
    Frame flange = new Frame(reach + 0.0009 + 80, 0, 400, 0, 90, 0);

    assertBringsBack(KR6.inverse(flange, 2, 0), flange);
    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(
            () -> KR6.inverse(new Frame(reach + 0.0011 + 80, 0, 400, 0, 90, 0), KR6.home()));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 90, 180, -180, 1e-9, 1e300})
  void noPoseGivesANumberThatIsNone(double angle) {
    // Frame and Axis refuse NaN, so results are finite.
    for (int axis = 0; axis < 6; axis++) {
      Axis axes = Axis.ZERO.with(axis, angle);
      for (RobotModel robot : new RobotModel[] {KR6, INVENTED}) {
        Frame flange = robot.forward(axes);
        assertThat(robot.inverse(flange)).isNotEmpty();
        for (double[] row : robot.jacobian(axes)) {
          assertThat(row).doesNotContain(Double.NaN);
        }
      }
    }
  }

  @Test
  void aFlangeTurnedFullyBackHasSolutions() {
    // A5 = 180, outside the limits of every robot: only the difference of A4 and A6 matters.
    Frame flange = KR6.forward(Axis.of(20, -80, 100, 30, 180, 40));

    assertThat(KR6.inverse(flange)).hasSize(8).allSatisfy(axes -> assertBringsBack(axes, flange));
  }

  @Test
  void theLargestNumbersAreOutOfReach() {
    assertThat(KR6.inverse(new Frame(1e308, -1e308, 1e308, 1e308, 1e308, 1e308))).isEmpty();
  }

  private static void assertBringsBack(Axis axes, Frame flange) {
    assertThat(KR6.forward(axes).distance(flange)).isLessThan(0.01);
    assertThat(angle(KR6.forward(axes), flange)).isLessThan(0.001);
  }
}
