package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.protocol.value.KrlReal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Spline motions as programs write them, sampled after every cycle. */
class SplineProgramTest {
  private static final double CYCLE = 0.012;
  private static final Frame START = RobotModel.kr6r900sixx().forward(Cell.START);

  private final Cell cell = new Cell();
  private final List<Frame> flanges = new ArrayList<>();
  private final List<Boolean> outputs = new ArrayList<>();

  @AfterEach
  void close() {
    cell.close();
  }

  private void sample() {
    flanges.add(RobotModel.kr6r900sixx().forward(cell.controller.axes()));
    outputs.add(cell.get("$OUT[1]").equals("TRUE"));
  }

  private void ride(BooleanSupplier until) {
    sample();
    while (!until.getAsBoolean()) {
      cell.cycles(1);
      sample();
    }
  }

  /** Runs statements to their end, at a slow path speed. */
  private void ride(String body) throws KrlFileException {
    cell.start("$VEL.CP=0.1\n$APO.CDIS=20\n$ADVANCE=3\n" + body);
    ride(() -> cell.controller.robot().state() != ProgramState.ACTIVE);
    assertThat(cell.controller.messages()).isEmpty();
    assertThat(cell.controller.robot().state()).isEqualTo(ProgramState.END);
  }

  private static String point(double x, double y, double z) {
    return "{X " + (START.x() + x) + ",Y " + (START.y() + y) + ",Z " + (START.z() + z) + "}";
  }

  private Frame relative(int sample) {
    Frame at = flanges.get(sample);
    return new Frame(
        at.x() - START.x(), at.y() - START.y(), at.z() - START.z(), at.a(), at.b(), at.c());
  }

  private Frame end() {
    return relative(flanges.size() - 1);
  }

  private double speed(int sample) {
    return flanges.get(sample).distance(flanges.get(sample - 1)) / CYCLE / 1000;
  }

  private double nearest(double x, double y, double z) {
    Frame point = new Frame(START.x() + x, START.y() + y, START.z() + z, 0, 0, 0);
    return flanges.stream().mapToDouble(point::distance).min().orElseThrow();
  }

  /** Returns the length of the path to a sample, mm. */
  private double length(int sample) {
    double length = 0;
    for (int i = 1; i <= sample; i++) {
      length += flanges.get(i).distance(flanges.get(i - 1));
    }
    return length;
  }

  private int firedAt() {
    assertThat(outputs).contains(true);
    return outputs.indexOf(true);
  }

  private int standsAt() {
    int last = flanges.size() - 1;
    while (flanges.get(last - 1).distance(flanges.get(last)) < 1e-6) {
      last--;
    }
    return last;
  }

  // single motions

  @Test
  void singleMotionsEndWhereThoseOfTheOldKindDo() throws Exception {
    ride(
        "SLIN "
            + point(0, 50, 0)
            + "\nSLIN_REL {Z -30}\nSCIRC "
            + point(-20, 70, -30)
            + ","
            + point(0, 90, -30)
            + "\nSCIRC_REL {X 20,Y 20},{Y 40}\nSPTP_REL {A1 0}\nSPTP "
            + point(10, 100, 0));

    assertThat(end().x()).isCloseTo(10, within(1e-3));
    assertThat(end().y()).isCloseTo(100, within(1e-3));
    assertThat(end().z()).isCloseTo(0, within(1e-3));
    assertThat(nearest(0, 130, -30)).isLessThan(0.01);
    assertThat(nearest(-20, 70, -30)).isLessThan(0.7);
  }

  @Test
  void withHoldsForItsMotionOnly() throws Exception {
    ride(
        "SLIN "
            + point(0, 50, 0)
            + " WITH $VEL.CP=0.03, $TOOL={X 0,Y 0,Z 0,A 0,B 0,C 0}\n"
            + "SLIN "
            + point(0, 100, 0));

    double fast = 0;
    double slow = 0;
    for (int i = 1; i < flanges.size(); i++) {
      if (relative(i).y() < 49.9) {
        slow = Math.max(slow, speed(i));
      }
      fast = Math.max(fast, speed(i));
    }
    assertThat(slow).isCloseTo(0.03, within(0.001));
    assertThat(fast).isCloseTo(0.1, within(0.001));
    assertThat(cell.component("$VEL", "CP")).isCloseTo(0.1, within(1e-6));
  }

  @Test
  void withCallsFunctionsWhoseEffectsOnTheSpeedEndToo() throws Exception {
    cell.load(
        """
        DEF TEST()
          $VEL_AXIS[1]=50
          $VEL_AXIS[2]=50
          SPTP {A1 20} WITH $VEL_AXIS[1]=SLOWLY(10)
          SPTP {A1 0}
        END
        DEFFCT REAL SLOWLY(P:IN)
          REAL P
          $VEL_AXIS[2]=P
          RETURN P
        ENDFCT
        """);
    cell.controller.robot().select("TEST");
    cell.controller.robot().start();
    cell.runToTheEnd();

    assertThat(cell.get("$VEL_AXIS[1]")).isEqualTo("50");
    assertThat(cell.get("$VEL_AXIS[2]")).isEqualTo("50");
  }

  @Test
  void settingsOfAFailedMotionDoNotStay() throws Exception {
    cell.start("$VEL.CP=0.1\nSLIN {X 99999} WITH $VEL.CP=0.03");
    cell.until(() -> cell.controller.robot().state() != ProgramState.ACTIVE);

    assertThat(cell.component("$VEL", "CP")).isCloseTo(0.1, within(1e-6));
  }

  @Test
  void approximatesAtTheDistanceAndAtMostAtHalf() throws Exception {
    ride(
        "SLIN "
            + point(0, 100, 0)
            + " C_SPL\nSLIN "
            + point(-100, 100, 0)
            + " WITH $APO.CDIS=500 C_SPL\nSLIN "
            + point(-100, 60, 0));

    for (int i = 0; i < flanges.size(); i++) {
      Frame at = relative(i);
      if (at.y() < 80 - 1e-6 && at.x() > -50) {
        assertThat(at.x()).isCloseTo(0, within(1e-6));
      }
      if (at.x() < -20 - 1e-6 && at.x() > -50 + 1e-6) {
        assertThat(at.y()).isCloseTo(100, within(1e-6));
      }
    }
    assertThat(nearest(0, 100, 0)).isBetween(5.0, 8.0);
    // half of 100 mm and half of 40 mm: a quarter of the way from the corner to the middle
    assertThat(nearest(-100, 100, 0)).isBetween(9.0, 14.0);
    for (int i = 6; i < standsAt() - 6; i++) {
      assertThat(speed(i)).isGreaterThan(0.05);
    }
  }

  @Test
  void approximatesSptpByItsDistance() throws Exception {
    ride("SPTP " + point(0, 100, 0) + " C_SPL\nSPTP " + point(-100, 100, 0));

    assertThat(nearest(0, 100, 0)).isBetween(2.0, 10.0);
    assertThat(nearest(0, 100, 0) + nearest(-100, 100, 0)).isLessThan(10);
  }

  @Test
  void motionsOfTheTwoKindsDoNotApproximateEachOther() throws Exception {
    cell.start("$APO.CDIS=20\nSLIN " + point(0, 50, 0) + " C_SPL\nLIN " + point(-50, 50, 0));
    ride(() -> cell.controller.robot().state() != ProgramState.ACTIVE);

    assertThat(nearest(0, 50, 0)).isLessThan(1e-6);
    assertThat(cell.message())
        .isEqualTo("1442 test.src:3:1: a motion and a spline motion cannot be approximated");
  }

  // blocks

  private static String block(String... lines) {
    return "SPLINE\n" + String.join("\n", lines) + "\nENDSPLINE\n";
  }

  @Test
  void aBlockIsOneMotionOfTheAdvanceRun() throws Exception {
    cell.start(
        "$ADVANCE=1\n"
            + block(
                "SPL " + point(0, 40, 0), "SPL " + point(-20, 70, 0), "SPL " + point(0, 100, 20))
            + "LIN_REL {Z 10}\n$FLAG[1]=TRUE\nWAIT SEC 0");
    cell.cycles(5);

    assertThat(cell.controller.standing()).isFalse();
    assertThat(cell.get("$FLAG[1]")).isEqualTo("TRUE");
  }

  @Test
  void segmentsCanHaveTheirOwnSpeed() throws Exception {
    ride(
        "SPLINE WITH $VEL.CP=0.05\nSLIN "
            + point(0, 60, 0)
            + "\nSPL "
            + point(-30, 120, 0)
            + " WITH $VEL.CP=0.02\nENDSPLINE");

    double first = 0;
    double second = 0;
    for (int i = 1; i < flanges.size(); i++) {
      if (relative(i).y() < 60) {
        first = Math.max(first, speed(i));
      } else if (relative(i - 1).y() > 60) {
        second = Math.max(second, speed(i));
      }
    }
    assertThat(first).isCloseTo(0.05, within(0.0005));
    assertThat(second).isCloseTo(0.02, within(0.0005));
    assertThat(cell.component("$VEL", "CP")).isCloseTo(0.1, within(1e-6));
  }

  @Test
  void pointsAreInTheBaseOfTheirSegmentAndRelativeToTheLastPoint() throws Exception {
    ride(
        block(
            "SPL " + point(0, 40, 0) + " WITH $BASE={X 0,Y 0,Z 30,A 0,B 0,C 0}",
            "SLIN_REL {Y 30}",
            "SPL_REL {X -20,Y 20,Z 10}",
            "SLIN_REL {Z 25} #TOOL"));

    assertThat(nearest(0, 40, 30)).isLessThan(1);
    assertThat(nearest(0, 70, 30)).isLessThan(1);
    assertThat(nearest(-20, 90, 40)).isLessThan(1);
    Frame from = new Frame(START.x() - 20, START.y() + 90, START.z() + 40, 0, 0, 0);
    assertThat(flanges.get(flanges.size() - 1).distance(from)).isCloseTo(25, within(1e-3));
  }

  @Test
  void identicalPointsAreReported() throws Exception {
    cell.start(
        block("SPL " + point(0, 40, 0), "SPL " + point(0, 40, 0), "SPL " + point(-20, 80, 0)));
    ride(() -> cell.controller.robot().state() != ProgramState.ACTIVE);

    assertThat(cell.message())
        .isEqualTo("3171 test.src:4:1: two points of the block are identical");
    assertThat(cell.controller.messages().get(0).kind()).isEqualTo(Message.Kind.NOTIFICATION);
    assertThat(nearest(-20, 80, 0)).isLessThan(1e-6);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "SPLINE | SPL %1$s; SLIN %2$s; SPL %2$s; SCIRC %3$s, %4$s | 40 60 60 90",
        "PTP_SPLINE | SPTP %1$s; SPTP %2$s; SPTP %2$s; SPTP %4$s | 40 60 60 90",
        "SPLINE | SPL %5$s; SPL %5$s | 0 0",
      })
  void theTargetsOfABlockAreItsPoints(String block, String segments, String y) throws Exception {
    String path =
        segments.formatted(
            point(0, 40, 0), point(0, 60, 9), point(0, 80, 20), point(9, 90, 20), point(0, 0, 0));
    cell.start("$VEL.CP=0.1\n" + block + "\n" + path.replace(";", "\n") + "\nENDSPLINE");
    List<Double> targets = new ArrayList<>();
    cell.until(
        () -> {
          for (MotionTarget target : cell.controller.startedMotions()) {
            KrlReal at = (KrlReal) target.position().get("Y").orElseThrow();
            targets.add((double) Math.round(at.value() - START.y()));
          }
          return cell.controller.robot().state() != ProgramState.ACTIVE;
        });

    assertThat(targets)
        .containsExactlyElementsOf(Stream.of(y.split(" ")).map(Double::valueOf).toList());
  }

  @Test
  void halfTheOverrideChangesNoPointOfThePath() throws Exception {
    String path =
        block(
            "SPL " + point(0, 40, 10),
            "SLIN " + point(-20, 80, 20),
            "SPL " + point(-60, 90, 0),
            "SCIRC " + point(-80, 60, 0) + "," + point(-60, 30, 0));
    ride(path);
    List<Frame> whole = List.copyOf(flanges);
    flanges.clear();
    cell.controller.place(Cell.START);
    cell.set("$OV_PRO", "50");
    ride(path);

    assertThat(flanges).hasSizeGreaterThan(whole.size() * 18 / 10);
    for (Frame point : whole) {
      double nearest = Double.MAX_VALUE;
      for (int i = 1; i < flanges.size(); i++) {
        double to = point.distance(flanges.get(i - 1)) + point.distance(flanges.get(i));
        nearest = Math.min(nearest, to - flanges.get(i - 1).distance(flanges.get(i)));
      }
      // on the straight way between two cycles, but for its bend
      assertThat(nearest).isLessThan(0.005);
    }
  }

  // triggers

  @Test
  void aTriggerInABlockCountsFromItsPoint() throws Exception {
    ride(
        block(
            "SLIN " + point(0, 60, 0),
            "TRIGGER WHEN PATH=-15 DELAY=0 DO $OUT[1]=TRUE",
            "SPL " + point(-30, 120, 0),
            "SPL " + point(0, 180, 0)));

    int corner = 0;
    while (flanges
            .get(corner)
            .distance(new Frame(START.x() - 30, START.y() + 120, START.z(), 0, 0, 0))
        > 0.7) {
      corner++;
    }
    assertThat(length(corner) - length(firedAt())).isBetween(12.5, 15.5);
  }

  @Test
  void aTriggerOnStartCountsFromTheLastPoint() throws Exception {
    ride(
        block(
            "SLIN " + point(0, 60, 0),
            "TRIGGER WHEN PATH=10 ONSTART DELAY=0 DO $OUT[1]=TRUE",
            "SPL " + point(-30, 120, 0)));

    assertThat(length(firedAt())).isBetween(70.0, 71.3);
    assertThat(length(firedAt() - 1)).isLessThan(70);
  }

  @Test
  void aTriggerOfABlockCannotCountByDistance() throws Exception {
    cell.start(block("TRIGGER WHEN DISTANCE=1 DELAY=0 DO $OUT[1]=TRUE", "SPL " + point(0, 50, 0)));
    cell.until(() -> cell.controller.robot().state() != ProgramState.ACTIVE);

    assertThat(cell.message())
        .isEqualTo("2363 test.src:3:1: TRIGGER WHEN DISTANCE is not allowed in a spline block");
  }

  @Test
  void aNegativeDelayIsKeptWhileTheRobotBrakes() throws Exception {
    ride("$VEL.CP=1\nTRIGGER WHEN DISTANCE=1 DELAY=-100 DO $OUT[1]=TRUE\nLIN " + point(0, 200, 0));

    // a triangle of 0.2 m at 2.3 m/s², from the last cycle in which the robot stood
    double duration = 2 * Math.sqrt(0.2 / 2.3);
    int begin = 0;
    while (flanges.get(begin + 1).distance(flanges.get(0)) == 0) {
      begin++;
    }
    assertThat(duration - (firedAt() - begin) * CYCLE).isBetween(0.088, 0.1);
  }

  @Test
  void aNegativeDelayIsKeptAtHalfTheOverride() throws Exception {
    cell.set("$OV_PRO", "50");
    ride("TRIGGER WHEN PATH=-20 DELAY=-120 DO $OUT[1]=TRUE\nLIN " + point(0, 100, 0));

    // 120 ms at 0.05 m/s are 6 mm
    assertThat(relative(firedAt()).y()).isBetween(74.0, 74.6 + 0.01);
  }

  @Test
  void aNegativeDelayIsKeptWhereAPtpIsApproximated() throws Exception {
    int[] fired = new int[2];
    for (int i = 0; i < 2; i++) {
      cell.controller.place(Cell.START);
      cell.set("$OUT[1]", "FALSE");
      flanges.clear();
      outputs.clear();
      ride(
          "TRIGGER WHEN DISTANCE=1 DELAY="
              + (i == 0 ? 0 : -60)
              + " DO $OUT[1]=TRUE\nPTP {A1 60} C_PTP\nPTP {A2 -60}");
      fired[i] = firedAt();
    }

    assertThat(fired[0] - fired[1]).isEqualTo(5);
  }

  @Test
  void aTriggerWithoutDelayFiresInTheCycleOfItsPlace() throws Exception {
    ride(
        "TRIGGER WHEN PATH=-20 DELAY=0 DO $OUT[1]=TRUE\nLIN "
            + point(0, 100, 0)
            + "\n$OUT[1]=FALSE\n");
    assertThat(relative(firedAt()).y()).isBetween(80.0, 81.2);

    outputs.clear();
    flanges.clear();
    cell.controller.place(Cell.START);
    ride("TRIGGER WHEN DISTANCE=1 DELAY=0 DO $OUT[1]=TRUE\nLIN " + point(0, 100, 0));
    assertThat(firedAt()).isEqualTo(standsAt());
  }

  @ParameterizedTest
  @ValueSource(ints = {-60, -43, -41, -39, -30, -20, -10})
  void aTriggerFiresWhereItIsInACorner(int mm) throws Exception {
    ride(
        "$VEL.CP=0.1\n$APO.CDIS=40\nTRIGGER WHEN PATH="
            + mm
            + " DELAY=0 DO $OUT[1]=TRUE\nLIN "
            + point(0, 100, 0)
            + " C_DIS\nLIN "
            + point(0, 100, -100)
            + "\n$OUT[1]=FALSE\n");

    double place = inTheCorner(mm);
    assertThat(relative(firedAt()).y()).isBetween(place - 0.1, place + 1.3);
  }

  /**
   * Returns Y at a place before the end of 100 mm along Y, whose last 40 mm are a corner to -Z: the
   * first half of the parabola y = 60 + 40 t (2 - t), z = 40 t².
   */
  private static double inTheCorner(int mm) {
    if (mm <= -40) {
      return 100 + mm;
    }
    double length = 0;
    double[] lengths = new double[2001];
    for (int i = 1; i < lengths.length; i++) {
      double t = (i - 0.5) / 2000;
      length += Math.hypot(80 * (1 - t), 80 * t) / 2000;
      lengths[i] = length;
    }
    int i = 0;
    while (lengths[i] < length * (40 + mm) / 40 / 2) {
      i++;
    }
    return 60 + 40 * (i / 2000.0) * (2 - i / 2000.0);
  }

  // sections

  @Test
  void aTimeBlockTakesItsTime() throws Exception {
    ride(
        block(
            "SPL " + point(0, 40, 0),
            "TIME_BLOCK START",
            "SPL " + point(-20, 80, 0),
            "TIME_BLOCK PART=3",
            "SPL " + point(0, 120, 20),
            "TIME_BLOCK PART=1",
            "TIME_BLOCK END=4",
            "SPL " + point(0, 160, 20)));

    int[] samples = new int[3];
    double[][] points = {{0, 40, 0}, {-20, 80, 0}, {0, 120, 20}};
    for (int i = 0; i < 3; i++) {
      double nearest = nearest(points[i][0], points[i][1], points[i][2]);
      Frame point =
          new Frame(
              START.x() + points[i][0],
              START.y() + points[i][1],
              START.z() + points[i][2],
              0,
              0,
              0);
      while (flanges.get(samples[i]).distance(point) > nearest) {
        samples[i]++;
      }
    }
    assertThat((samples[1] - samples[0]) * CYCLE).isCloseTo(3, within(0.03));
    assertThat((samples[2] - samples[1]) * CYCLE).isCloseTo(1, within(0.03));
  }

  @Test
  void aSectionOfConstantSpeedHasNeitherRampNorDrop() throws Exception {
    ride(
        block(
            "CONST_VEL START=10 ONSTART",
            "SPL " + point(0, 40, 0),
            "SPL " + point(-20, 80, 0) + " WITH $VEL.CP=0.04",
            "CONST_VEL END=-5",
            "SPL " + point(0, 120, 20)));

    for (int i = 1; i < flanges.size(); i++) {
      if (length(i - 1) > 10.1 && relative(i).y() < 80) {
        assertThat(speed(i)).isCloseTo(0.04, within(0.0005));
      }
    }
  }

  @Test
  void refusesSectionsThatDoNotAlternate() throws Exception {
    cell.start(block("TIME_BLOCK START", "SPL " + point(0, 40, 0)));
    cell.until(() -> cell.controller.robot().state() != ProgramState.ACTIVE);

    assertThat(cell.message())
        .isEqualTo("9106 test.src:2:1: TIME_BLOCK START needs TIME_BLOCK END");
  }

  @Test
  void stopsOnThePathWhileItsConditionIsTrue() throws Exception {
    cell.controller.variables().set("$OUT[5]", "TRUE");
    cell.start(
        "$VEL.CP=0.1\n"
            + block(
                "SPL " + point(0, 40, 0),
                "STOP WHEN PATH=-10 IF $OUT[5]==TRUE",
                "SLIN " + point(0, 100, 0)));
    cell.cycles(400);

    assertThat(cell.controller.standing()).isTrue();
    assertThat(cell.controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    sample();
    assertThat(end().y()).isCloseTo(90, within(0.001));
    cell.set("$OUT[5]", "FALSE");
    cell.runToTheEnd();
    sample();
    assertThat(end().y()).isCloseTo(100, within(1e-3));
  }

  @ParameterizedTest
  @ValueSource(ints = {-43, -39, -30, -20, -10})
  void stopsInACornerAtItsPlace(int mm) throws Exception {
    cell.set("$OUT[5]", "TRUE");
    cell.start(
        "$VEL.CP=0.1\n$APO.CDIS=40\nSTOP WHEN PATH="
            + mm
            + " IF $OUT[5]==TRUE\nSLIN "
            + point(0, 100, 0)
            + " C_SPL\nSLIN "
            + point(0, 100, -100));
    cell.cycles(400);

    assertThat(cell.controller.standing()).isTrue();
    sample();
    assertThat(end().y()).isCloseTo(inTheCorner(mm), within(0.1));
    cell.set("$OUT[5]", "FALSE");
    cell.runToTheEnd();
  }

  @Test
  void passesAStopWithoutSlowingDownIfItsConditionIsFalse() throws Exception {
    ride("STOP WHEN PATH=-50 IF $OUT[5]==TRUE\nSLIN " + point(0, 100, 0));

    for (int i = 6; i < standsAt() - 6; i++) {
      assertThat(speed(i)).isCloseTo(0.1, within(0.001));
    }
  }

  @Test
  void aPtpSplinePassesItsPoints() throws Exception {
    ride("PTP_SPLINE\nSPTP {A1 10,A2 -80}\nSPTP {A1 20,A2 -95}\nSPTP_REL {A1 5}\nENDSPLINE");

    assertThat(cell.controller.axes().a1()).isCloseTo(25, within(1e-6));
    assertThat(cell.controller.axes().a2()).isCloseTo(-95, within(1e-6));
  }
}
