package no.hials.crosscom.kinematics;

import static no.hials.crosscom.kinematics.Frames.angle;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvFileSource;

final class ForwardKinematicsTest {
  private static final RobotModel ROBOT = Robots.KR6;

  @ParameterizedTest
  @CsvFileSource(
      resources = "/no/hials/crosscom/kinematics/check-poses.csv",
      useHeadersInDisplayName = true)
  void reachesTheCheckPosesOfTheReference(ArgumentsAccessor row) {
    Frame flange = ROBOT.forward(Checks.axes(row, 0));
    Frame expected = Checks.frame(row, 6);

    Offset<Double> hundredth = within(0.01);
    assertThat(flange.x()).isCloseTo(expected.x(), hundredth);
    assertThat(flange.y()).isCloseTo(expected.y(), hundredth);
    assertThat(flange.z()).isCloseTo(expected.z(), hundredth);
    assertThat(angle(flange, expected)).isLessThan(0.001);
    assertThat(Checks.turnBetween(flange.a(), expected.a())).isLessThan(0.001);
    assertThat(Checks.turnBetween(flange.b(), expected.b())).isLessThan(0.001);
    assertThat(Checks.turnBetween(flange.c(), expected.c())).isLessThan(0.001);
  }

  @Test
  void turnsClockwiseSeenFromAboveIfA1IsPositive() {
    Frame flange = ROBOT.forward(ROBOT.home().with(0, 90));

    assertThat(flange.distance(new Frame(0, -525, 890, 0, 0, 0))).isLessThan(1e-9);
  }

  @Test
  void showsTheTurnOfA1InAWhenTheFlangePointsForward() {
    // B = 90: A and C are one angle, and C = 0 is chosen.
    Frame flange = ROBOT.forward(ROBOT.home().with(0, 30));

    assertThat(flange.a()).isCloseTo(-30, within(1e-9));
    assertThat(flange.b()).isEqualTo(90);
    assertThat(flange.c()).isZero();
  }

  @Test
  void hasItsHighestSpeedsAndLimitsFromTheReference() {
    assertThat(ROBOT.name()).isEqualTo("KR 6 R900 sixx");
    assertThat(ROBOT.home()).isEqualTo(Axis.of(0, -90, 90, 0, 0, 0));
    assertThat(ROBOT.minimum(1)).isEqualTo(-190);
    assertThat(ROBOT.maximum(2)).isEqualTo(156);
    assertThat(ROBOT.maxSpeed(5)).isEqualTo(615);
    assertThat(ROBOT.maxAcceleration(0)).isEqualTo(360 / 0.3, within(1e-9));
  }
}
