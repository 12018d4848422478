package no.hials.crosscom.kinematics;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.interpolate;
import static no.hials.crosscom.kinematics.Robots.KR6;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import no.hials.crosscom.kinematics.UnreachableException.Reason;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

final class InverseKinematicsTest {
  private static final Axis BENT = Axis.of(20, -80, 100, 30, 60, 40);

  @ParameterizedTest
  @CsvSource({
    // Each bit on both sides of its change.
    "0, -90, 4.77, 0, 10, 0, 2",
    "0, -90, 4.76, 0, 10, 0, 0",
    "0, -90, 90, 0, 0.1, 0, 2",
    "0, -90, 90, 0, 0, 0, 2",
    "0, -90, 90, 0, -0.1, 0, 6",
    "0, -130, 90, 0, 10, 0, 2",
    "0, -150, 90, 0, 10, 0, 3",
    "0, -150, 90, 0, -10, 0, 7"
  })
  void hasTheStatusOfTheReference(
      double a1, double a2, double a3, double a4, double a5, double a6, int status) {
    assertThat(KR6.status(new Axis(a1, a2, a3, a4, a5, a6))).isEqualTo(status);
  }

  @ParameterizedTest
  @CsvSource({
    "0, -90, 90, 0, 0, 0, 2",
    "1, -1, 1, 1, 1, -1, 34",
    "-1, -1, -1, -1, -1, -1, 63",
  })
  void hasABitOfTheTurnForEachNegativeAxis(
      double a1, double a2, double a3, double a4, double a5, double a6, int turn) {
    assertThat(KR6.turn(new Axis(a1, a2, a3, a4, a5, a6))).isEqualTo(turn);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-10, 350, -350, 10, 179.5, -180.5, 180, -180})
  void theTurnTellsApartTheTwoRevolutionsOfA6(double a6) throws Exception {
    Axis axes = BENT.with(5, a6);

    Axis found = KR6.inverse(KR6.forward(axes), KR6.status(axes), KR6.turn(axes));

    assertThat(found.largestDifference(axes)).isLessThan(1e-9);
  }

  @Test
  void theTurnTakesA2BeyondMinus180() throws Exception {
    Axis axes = Axis.of(0, -185, 20, 0, 40, 0);

    Axis found = KR6.inverse(KR6.forward(axes), KR6.status(axes), KR6.turn(axes));

    assertThat(found.largestDifference(axes)).isLessThan(1e-9);
  }

  @Test
  void aRevolutionOutsideTheLimitsIsRefused() {
    Frame flange = KR6.forward(BENT.with(5, -5));

    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(flange, KR6.status(BENT), 0b000010))
        .withMessage("axis limit A6 350.0 exceeded, would be 355.0000 degrees")
        .satisfies(e -> assertThat(e.reason()).isEqualTo(Reason.AXIS_LIMIT));
  }

  @Test
  void anAxisAtZeroFitsEitherBitOfTheTurn() throws Exception {
    // The rounding of a REAL can make 0 negative, but must not turn the axis by a full revolution.
    Frame flange = KR6.forward(BENT.with(5, -0.009));

    assertThat(KR6.inverse(flange, KR6.status(BENT), 0b000010).a6())
        .isEqualTo(-0.009, within(1e-9));
    assertThat(KR6.inverse(flange, KR6.status(BENT), 0b100010).a6())
        .isEqualTo(-0.009, within(1e-9));
  }

  @Test
  void anAxisThatRoundingPutsBeyondItsLimitIsAtTheLimit() throws Exception {
    Axis beyond = BENT.with(0, 170.00009);
    Axis farBeyond = BENT.with(0, 170.00011);

    assertThat(KR6.inverse(KR6.forward(beyond), BENT).a1()).isEqualTo(170);
    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(KR6.forward(farBeyond), BENT))
        .withMessage("axis limit A1 170.0 exceeded, would be 170.0001 degrees");
  }

  @ParameterizedTest
  @CsvSource({
    "0, -90, 90, 0, 45, 0",
    "170, 45, 40, 185, 120, 350",
    "-170, -190, 156, -185, -120, -350",
    "0, -90, 4.8, 90, 90, 180"
  })
  void aFrameOf32BitNumbersLeadsBackToTheAxes(
      double a1, double a2, double a3, double a4, double a5, double a6) throws Exception {
    Axis axes = new Axis(a1, a2, a3, a4, a5, a6);
    Frame read = asReals(KR6.forward(axes));

    Axis found = KR6.inverse(read, KR6.status(axes), KR6.turn(axes));

    // At A3 = 4.8 the arm is almost straight, and small errors of the frame are large for the
    // elbow.
    assertThat(found.largestDifference(axes)).isLessThan(a3 > 5 ? 1e-4 : 0.05);
  }

  @Test
  void namesTheAxisThatWouldPassItsLimit() {
    Axis axes = Axis.of(0, 50, 40, 0, 30, 0);
    Frame flange = KR6.forward(axes);

    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(flange, 2, 0))
        .withMessage("axis limit A2 45.0 exceeded, would be 50.0000 degrees");
    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(flange, KR6.home()))
        .withMessage("axis limit A2 45.0 exceeded, would be 50.0000 degrees");
  }

  @Test
  void saysByHowMuchAFrameIsBeyondReach() {
    // The wrist centre is at the height of A2, 10 mm beyond the length of the arm.
    double reach = 25 + 455 + Math.hypot(420, 35);
    Frame flange = new Frame(reach + 10 + 80, 0, 400, 0, 90, 0);

    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(flange, 2, 2))
        .withMessage("the wrist centre is 10.000 mm beyond reach, which is 876.456 mm from A2")
        .satisfies(e -> assertThat(e.reason()).isEqualTo(Reason.REACH));
    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(flange, KR6.home()))
        .withMessageStartingWith("the wrist centre is 10.000 mm beyond reach");
    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(flange, 3, 2))
        .withMessageStartingWith("the wrist centre is 60.000 mm beyond reach")
        .withMessageEndingWith(", with the wrist centre behind A1 (bit 0 of the Status)");
    assertThat(KR6.inverse(flange)).isEmpty();
  }

  @Test
  void saysByHowMuchAFrameIsTooNearToA2() {
    Frame flange = new Frame(25 + 80 + 13.456, 0, 400, 0, 90, 0);

    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(flange, 2, 2))
        .withMessage(
            "the wrist centre is 20.088 mm too close to A2, its minimum distance is 33.544 mm");
  }

  @Test
  void saysByHowMuchAFrameIsTooNearToALateralOffset() {
    Frame flange = new Frame(0, 5, 1000, 0, 0, 0);

    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> Robots.INVENTED.inverse(flange, 2, 0))
        .withMessage(
            "the wrist centre is 10.000 mm too close to A1, its minimum distance is 15.000 mm");
  }

  @ParameterizedTest
  @CsvSource({
    "8, 2, 'Status has only the bits 10111, is 8'",
    "-1, 2, 'Status has only the bits 10111, is -1'",
    "2, 64, 'Turn has only the bits 111111, is 64'"
  })
  void refusesAStatusOrTurnThatIsNone(int status, int turn, String message) {
    Frame flange = KR6.forward(KR6.home());

    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(flange, status, turn))
        .withMessage(message)
        .satisfies(e -> assertThat(e.reason()).isEqualTo(Reason.STATUS_OR_TURN));
  }

  @Test
  void ignoresTheStatusBitOfAnAbsolutelyAccurateRobot() throws Exception {
    // A sample has S 18 (docs/reference/kinematics.md#status-and-turn).
    Frame flange = KR6.forward(BENT);

    assertThat(KR6.inverse(flange, 18, KR6.turn(BENT)))
        .isEqualTo(KR6.inverse(flange, 2, KR6.turn(BENT)));
  }

  @Test
  void followsAStraightLineWithoutAJump() throws Exception {
    Axis start = Axis.of(-50, -60, 70, -20, 50, 200);
    Frame from = KR6.forward(start);
    Frame to = new Frame(from.x() - 30, -from.y(), from.z() + 200, 40, 35, from.c() - 30);
    int steps = 500;

    Axis axes = start;
    for (int step = 1; step <= steps; step++) {
      Frame flange = interpolate(from, to, (double) step / steps);
      Axis next = KR6.inverse(flange, axes);
      assertThat(next.largestDifference(axes)).isLessThan(1);
      assertThat(KR6.forward(next).distance(flange)).isLessThan(1e-9);
      assertThat(angle(KR6.forward(next), flange)).isLessThan(1e-9);
      axes = next;
    }
    assertThat(KR6.status(axes)).isEqualTo(KR6.status(start));
  }

  @Test
  void aPathGoesOnBeyond180DegreesAndEndsAtTheLimit() throws Exception {
    Axis axes = BENT.with(5, 178);
    for (double a6 = 180; a6 <= 350; a6 += 2) {
      axes = KR6.inverse(KR6.forward(BENT.with(5, a6)), axes);
      assertThat(axes.a6()).isEqualTo(a6, within(1e-9));
    }

    Axis end = axes;
    assertThatExceptionOfType(UnreachableException.class)
        .isThrownBy(() -> KR6.inverse(KR6.forward(BENT.with(5, 352)), end))
        .withMessage("axis limit A6 350.0 exceeded, would be 352.0000 degrees");
  }

  @Test
  void aPathNeverChangesTheElbow() throws Exception {
    // The solution with the other elbow is near.
    Axis start = Axis.of(0, -60, Robots.STRAIGHT + 8, 0, 50, 0);
    Axis other = Axis.of(0, -52, Robots.STRAIGHT - 8, 0, 58, 0);

    Axis found = KR6.inverse(KR6.forward(other), start);

    assertThat(found.a3()).isEqualTo(Robots.STRAIGHT + 8, within(1e-9));
  }

  private static Frame asReals(Frame frame) {
    return new Frame(
        (float) frame.x(),
        (float) frame.y(),
        (float) frame.z(),
        (float) frame.a(),
        (float) frame.b(),
        (float) frame.c());
  }
}
