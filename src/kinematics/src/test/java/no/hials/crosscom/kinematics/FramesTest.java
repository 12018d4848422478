package no.hials.crosscom.kinematics;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.interpolate;
import static no.hials.crosscom.kinematics.Frames.inverse;
import static no.hials.crosscom.kinematics.Frames.product;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class FramesTest {
  private static final Frame SOME = new Frame(100, -200, 300, 30, -40, 50);

  @Test
  void theProductTakesAPointThroughTheRotation() {
    Frame table = new Frame(10, 20, 30, 90, 0, 0);

    Frame point = product(table, new Frame(1, 0, 5, 0, 0, 0));

    assertSame(point, new Frame(10, 21, 35, 90, 0, 0));
  }

  @ParameterizedTest
  @CsvSource({
    // Each about one axis, by the right-hand rule.
    "90, 0, 0, 0, 1, 0",
    "0, 90, 0, 0, 0, -1",
    "0, 0, 90, 1, 0, 0",
    "90, 90, 0, 0, 0, -1"
  })
  void theAnglesTurnTheXAxisAboutZThenNewYThenNewX(
      double a, double b, double c, double x, double y, double z) {
    Frame onX = product(new Frame(0, 0, 0, a, b, c), new Frame(1, 0, 0, 0, 0, 0));

    assertThat(onX.distance(new Frame(x, y, z, 0, 0, 0))).isLessThan(1e-12);
  }

  @Test
  void theOrderOfAProductMatters() {
    Frame shift = new Frame(1, 0, 0, 0, 0, 0);
    Frame turn = new Frame(0, 0, 0, 90, 0, 0);

    assertSame(product(shift, turn), new Frame(1, 0, 0, 90, 0, 0));
    assertSame(product(turn, shift), new Frame(0, 1, 0, 90, 0, 0));
  }

  @Test
  void aFrameAndItsInverseMakeTheIdentity() {
    Samples.forAll(
        FramesTest::anyFrame,
        frame -> {
          assertSame(product(frame, inverse(frame)), Frame.IDENTITY);
          assertSame(product(inverse(frame), frame), Frame.IDENTITY);
        });
  }

  @Test
  void theAnglesOfAProductAreNormalisedAndSayTheSame() {
    Samples.forAll(
        FramesTest::anyFrame,
        frame -> {
          Frame same = product(frame, Frame.IDENTITY);

          assertSame(same, frame);
          assertThat(same.a()).isGreaterThan(-180).isLessThanOrEqualTo(180);
          assertThat(same.b()).isBetween(-90.0, 90.0);
          assertThat(same.c()).isGreaterThan(-180).isLessThanOrEqualTo(180);
        });
  }

  @ParameterizedTest
  @CsvSource({
    "190, 0, 0, -170, 0, 0",
    "-180, 0, 0, 180, 0, 0",
    "0, 100, 0, 180, 80, 180",
    // B = 90: only C - A matters; C = 0
    "10, 90, 30, -20, 90, 0",
    "10, -90, 30, 40, -90, 0"
  })
  void anglesAreNormalised(double a, double b, double c, double a2, double b2, double c2) {
    Frame frame = product(new Frame(0, 0, 0, a, b, c), Frame.IDENTITY);

    assertThat(frame.a()).isEqualTo(a2, within(1e-12));
    assertThat(frame.b()).isEqualTo(b2, within(1e-12));
    assertThat(frame.c()).isEqualTo(c2, within(1e-12));
  }

  @Test
  void theInterpolationGoesEvenlyFromOneToTheOther() {
    Samples.forAll(
        random -> List.of(anyFrame(random), anyFrame(random)),
        frames -> {
          Frame from = frames.get(0);
          Frame to = frames.get(1);
          assertSame(interpolate(from, to, 0), from);
          assertSame(interpolate(from, to, 1), to);
          Frame between = interpolate(from, to, 0.25);
          assertThat(between.distance(from)).isEqualTo(from.distance(to) / 4, within(1e-9));
          assertThat(angle(between, from)).isEqualTo(angle(from, to) / 4, within(1e-6));
          assertThat(angle(between, to)).isEqualTo(angle(from, to) * 3 / 4, within(1e-6));
        });
  }

  @Test
  void theInterpolationTakesTheShorterWayRound() {
    Frame from = new Frame(0, 0, 0, 170, 0, 0);
    Frame to = new Frame(0, 0, 0, -160, 0, 0);

    assertThat(interpolate(from, to, 0.5).a()).isEqualTo(-175, within(1e-9));
  }

  @Test
  void theInterpolationBetweenOppositesIsAlwaysTheSameWay() {
    Frame opposite = new Frame(0, 0, 0, 180, 0, 0);

    Frame half = interpolate(Frame.IDENTITY, opposite, 0.5);

    assertThat(angle(half, Frame.IDENTITY)).isEqualTo(90, within(1e-9));
    assertThat(interpolate(Frame.IDENTITY, opposite, 0.5)).isEqualTo(half);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1e-9, 1.000001, Double.NaN})
  void refusesAPartOutsideTheWay(double s) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> interpolate(Frame.IDENTITY, SOME, s))
        .withMessage("s must be 0 to 1, is " + s);
  }

  @ParameterizedTest
  @CsvSource({"1e-7", "0.5", "179.9999", "180"})
  void measuresSmallAndLargeAngles(double angle) {
    assertThat(angle(SOME, product(SOME, new Frame(1, 2, 3, 0, 0, angle))))
        .isEqualTo(angle, within(1e-12));
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void refusesWhatIsNotFinite(double value) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Frame(0, value, 0, 0, 0, 0))
        .withMessage("Y must be finite, is " + value);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Frame(0, 0, 0, 0, 0, value))
        .withMessage("C must be finite, is " + value);
  }

  private static Frame anyFrame(Random random) {
    return new Frame(
        mm(random), mm(random), mm(random), degrees(random), degrees(random), degrees(random));
  }

  private static double mm(Random random) {
    return Samples.between(random, -2000, 2000);
  }

  private static double degrees(Random random) {
    return Samples.between(random, -360, 360);
  }

  private static void assertSame(Frame actual, Frame expected) {
    assertThat(actual.distance(expected)).isLessThan(1e-9);
    // The choice of A and C near B = 90 may lose this much.
    assertThat(angle(actual, expected)).isLessThan(1e-6);
  }
}
