package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Moves the robot by KRL programs, and looks at where it comes to. */
class ControllerMotionTest {
  private static final double MM = 0.01;
  private static final double DEGREES = 0.001;

  private Cell cell;
  private Controller controller;

  @BeforeEach
  void open() throws IOException {
    cell = new Cell();
    controller = cell.controller;
  }

  @AfterEach
  void close() {
    cell.close();
  }

  private double pos(String field) {
    return cell.component("$POS_ACT", field);
  }

  private void assertAt(double x, double y, double z) {
    assertThat(pos("X")).isCloseTo(x, within(MM));
    assertThat(pos("Y")).isCloseTo(y, within(MM));
    assertThat(pos("Z")).isCloseTo(z, within(MM));
  }

  // statements

  @Test
  void ptpGoesToAxesAndKeepsThoseThatAreNotGiven() throws Exception {
    cell.run("PTP {A1 10,A5 30}");
    assertThat(controller.axes()).isEqualTo(Axis.of(10, -90, 90, 0, 30, 0));
    assertThat(cell.get("$AXIS_ACT")).startsWith("{E6AXIS: A1 10.0000, A2 -90.0000,");
  }

  @Test
  void ptpGoesToAPositionWithItsStatusAndTurn() throws Exception {
    // a pose of the axes 30, -80, 100, 10, 60, -20 (docs/reference/kinematics.md#check-poses)
    cell.run("PTP {X 448.564,Y -272.871,Z 659.533,A 134.8594,B 12.2559,C -174.3395,S 2,T 34}");
    assertAt(448.564, -272.871, 659.533);
    assertThat(controller.axes().largestDifference(Axis.of(30, -80, 100, 10, 60, -20)))
        .isLessThan(0.01);
    assertThat(cell.get("$POS_ACT.S")).isEqualTo("2");
    assertThat(cell.get("$POS_ACT.T")).isEqualTo("34");
  }

  @Test
  void ptpWithAStatusButNoTurnTurnsTheAxesAsLittleAsPossible() throws Exception {
    cell.run("PTP {X 500,Y 100,Z 800,A 0,B 90,C 0,S 2}");
    assertAt(500, 100, 800);
    assertThat(controller.axes().a1()).isBetween(-30.0, 0.0);
    assertThat(cell.get("$POS_ACT.S")).isEqualTo("2");
  }

  @Test
  void linKeepsToTheLineAndToWhatIsNotGiven() throws Exception {
    double x = pos("X");
    double z = pos("Z");
    cell.start("LIN {Y 120}");
    while (controller.robot().state() == ProgramState.ACTIVE) {
      cell.cycles(1);
      assertThat(pos("X")).isCloseTo(x, within(MM));
      assertThat(pos("Z")).isCloseTo(z, within(MM));
    }
    assertAt(x, 120, z);
    assertThat(pos("B")).isCloseTo(45, within(DEGREES));
  }

  @Test
  void linCanGoToAxes() throws Exception {
    cell.run("LIN {A1 5}");
    assertThat(controller.axes().get(0)).isCloseTo(5, within(DEGREES));
  }

  @Test
  void circKeepsToTheCircle() throws Exception {
    double x = pos("X");
    double z = pos("Z");
    cell.start(circle(x, z, ""));
    while (controller.robot().state() == ProgramState.ACTIVE) {
      cell.cycles(1);
      assertThat(Math.hypot(pos("X") - (x - 40), pos("Y"))).isCloseTo(40, within(MM));
    }
    assertAt(x - 80, 0, z);
  }

  private static String circle(double x, double z, String angle) {
    String rest = ",Z " + z + ",A 180,B 45,C 180}";
    return "CIRC {X " + (x - 40) + ",Y 40" + rest + ",{X " + (x - 80) + ",Y 0" + rest + angle;
  }

  @Test
  void circGoesAsFarAsItsAngleSays() throws Exception {
    double x = pos("X");
    double z = pos("Z");
    cell.run(circle(x, z, ",CA 360"));
    assertAt(x, 0, z);
  }

  @Test
  void ptpRelAddsToAxesAndToThePosition() throws Exception {
    cell.run("PTP_REL {A1 10}\nPTP_REL {A1 -3,A6 5}");
    assertThat(controller.axes()).isEqualTo(Axis.of(7, -90, 90, 0, 45, 5));
    controller.place(Cell.START);
    double x = pos("X");
    double z = pos("Z");
    cell.run("PTP_REL {X -10,Z 5}");
    assertAt(x - 10, 0, z + 5);
  }

  @Test
  void linRelAddsInTheBaseOrInTheTool() throws Exception {
    double x = pos("X");
    double z = pos("Z");
    cell.run("LIN_REL {X -10} #BASE");
    assertAt(x - 10, 0, z);
    // the tool looks forward and down by 45 degrees
    cell.run("LIN_REL {Z 10} #TOOL");
    assertAt(x - 10 + 10 * Math.sqrt(0.5), 0, z - 10 * Math.sqrt(0.5));
  }

  @Test
  void refersToBaseAndTool() throws Exception {
    double x = pos("X");
    double z = pos("Z");
    cell.set("$BASE", "{X 100,Y 50,Z 20,A 90}");
    cell.set("$TOOL", "{Z 30}");
    double down = 30 * Math.sqrt(0.5);
    assertAt(-50, -(x + down - 100), z - down - 20);
    cell.run("LIN_REL {X 10}");
    cell.set("$BASE", "{X 0,Y 0,Z 0,A 0}");
    cell.set("$TOOL", "{Z 0}");
    assertAt(x, 10, z);
  }

  @Test
  void takesBaseAndToolOfThePlanningOfEachMotion() throws Exception {
    double x = pos("X");
    cell.run("$BASE={X 100}\nLIN {X 350}\n$BASE={X 0}\nLIN_REL {Y 10}");
    assertAt(450, 10, cell.component("$POS_ACT", "Z"));
    assertThat(x).isNotCloseTo(450, within(1.0));
  }

  // approximation

  private int standstills(String body) throws KrlFileException {
    cell.start(body);
    int[] count = {0};
    boolean[] stood = {true};
    cell.until(
        () -> {
          boolean stands = controller.standing();
          count[0] += stands && !stood[0] ? 1 : 0;
          stood[0] = stands;
          return controller.robot().state() != ProgramState.ACTIVE;
        });
    assertThat(controller.messages()).isEmpty();
    return count[0];
  }

  @Test
  void approximatesIfTheAdvanceRunIsAllowedTo() throws Exception {
    String path =
        "PTP {A1 20} C_PTP\nPTP {A1 20,A6 30} C_PTP\nLIN_REL {Z 20} C_DIS\nLIN_REL {Z 20}";
    assertThat(standstills(path)).isEqualTo(1);
    controller.place(Cell.START);
    assertThat(standstills("$ADVANCE=0\n" + path)).isEqualTo(4);
  }

  @Test
  void standsBetweenMotionsWithoutApproximation() throws Exception {
    assertThat(standstills("PTP {A1 20}\nPTP {A1 30}\nLIN_REL {Z 20}")).isEqualTo(3);
  }

  @Test
  void accessToAnOutputEndsTheAdvanceRun() throws Exception {
    assertThat(standstills("PTP {A1 20} C_PTP\n$OUT[1]=TRUE\nPTP {A1 30} C_PTP")).isEqualTo(2);
    controller.place(Cell.START);
    assertThat(standstills("PTP {A1 20} C_PTP\nCONTINUE\n$OUT[1]=FALSE\nPTP {A1 30} C_PTP"))
        .isEqualTo(1);
  }

  @Test
  void plansNoFurtherAheadThanAdvanceSays() throws Exception {
    cell.start("$ADVANCE=2\nFOR MYINT=1 TO 9\nPTP_REL {A1 5}\nENDFOR");
    cell.cycles(3);
    assertThat(cell.get("MYINT")).isEqualTo("4"); // one under way, two ahead, one that waits
    assertThat(cell.get("$ACT_ADVANCE")).isEqualTo("2");
  }

  // speed

  @ParameterizedTest
  @ValueSource(strings = {"LIN_REL {X 1}", "SLIN_REL {X 1}"})
  void movesAsSlowlyAsTheProgramSays(String motion) throws Exception {
    double before = cell.component("$POS_ACT", "X");
    cell.start("$VEL.CP=1E-5\n" + motion);
    cell.seconds(50);
    assertThat(cell.component("$POS_ACT", "X") - before).isCloseTo(0.5, within(MM));
    cell.seconds(51);
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "$VEL.CP=1E-38\nLIN_REL {X 100}",
        "$ACC.CP=1E-38\nLIN_REL {X 100}",
        "$VEL.CP=1E-38\n$ACC.CP=1E-38\nCIRC_REL {X 20,Y 20},{X 40}",
        "$VEL.ORI1=1E-38\n$ACC.ORI1=1E-38\nLIN_REL {A 10}",
        "$VEL.CP=1E-38\nSLIN_REL {X 100}",
        "$ACC.CP=1E-38\nSPLINE\nSPL_REL {X 100}\nSPL_REL {Y 100}\nENDSPLINE"
      })
  void hardlyMovesAtTheSmallestRates(String body) throws Exception {
    double before = cell.component("$POS_ACT", "X");
    cell.start(body);
    cell.seconds(10);
    assertThat(controller.messages()).isEmpty();
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    assertThat(cell.component("$POS_ACT", "X")).isCloseTo(before, within(MM));
  }

  @ParameterizedTest
  @CsvSource({"100,0.25", "50,0.125"})
  void keepsToThePathSpeedTimesTheOverride(String override, double speed) throws Exception {
    cell.set("$OV_PRO", override);
    cell.start("$VEL.CP=0.25\nLIN_REL {X -100}");
    double most = 0;
    while (controller.robot().state() == ProgramState.ACTIVE) {
      cell.cycles(1);
      most = Math.max(most, cell.real("$VEL_ACT"));
    }
    assertThat(most).isCloseTo(speed, within(0.001));
  }

  @Test
  void followsTheOverrideAtRunTime() throws Exception {
    controller.place(Axis.of(-160, -90, 90, 0, 45, 0));
    cell.start("PTP {A1 160}");
    cell.cycles(55);
    assertThat(cell.real("$VEL_AXIS_ACT[1]")).isCloseTo(100, within(0.5));
    cell.set("$OV_PRO", "0");
    cell.untilStanding();
    double stood = controller.axes().get(0);
    cell.seconds(2);
    assertThat(controller.axes().get(0)).isEqualTo(stood).isLessThan(160);
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
    cell.set("$OV_PRO", "30");
    cell.cycles(20);
    assertThat(cell.real("$VEL_AXIS_ACT[1]")).isCloseTo(30, within(0.5));
    cell.runToTheEnd();
  }

  @Test
  void aProgramCanReduceTheSpeedOfAxes() throws Exception {
    cell.start("BAS(#VEL_PTP,20)\nPTP {A1 60}");
    double most = 0;
    while (controller.robot().state() == ProgramState.ACTIVE) {
      cell.cycles(1);
      most = Math.max(most, cell.real("$VEL_AXIS_ACT[1]"));
    }
    assertThat(most).isCloseTo(20, within(0.1));
  }

  // what cannot be

  private void assertStops(String body, int number, String text) throws KrlFileException {
    Axis before = controller.axes();
    cell.start("MYINT=1\n" + body + "\nMYINT=2");
    cell.until(() -> controller.robot().state() != ProgramState.ACTIVE);
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(cell.message()).startsWith(number + " test.src:3:").contains(text);
    assertThat(cell.get("$PRO_STATE1")).isEqualTo("#P_STOP");
    assertThat(cell.get("$ERR.NUMBER")).isEqualTo(String.valueOf(number));
    assertThat(cell.get("$STOPMESS")).isEqualTo("TRUE");
    assertThat(controller.axes()).isEqualTo(before);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "PTP {A1 171}|1211|A1 must be at most 170.000 degrees, would be 171.000",
        "PTP_REL {A2 -101}|1211|A2 must be at least -190.000 degrees",
        "PTP {X 2000}|9101|reach",
        "PTP {X 1E38,Y 1E38}|9101|",
        "CIRC {Z 900},{Z 950}|1456|circle",
        "LIN_REL {A1 1}|1446|LIN_REL needs a Cartesian increment, was given axes"
      })
  void stopsAtATargetThatCannotBe(String body, int number, String text) throws Exception {
    assertStops(body, number, text == null ? "" : text);
  }

  @Test
  void goesOnWithTheSameStatementWhenItsTargetCanBeReached() throws Exception {
    cell.set("MYAXIS", "{A1 300}");
    cell.start("PTP MYAXIS\nMYINT=1");
    cell.cycles(2);
    cell.set("MYAXIS", "{A1 30,A2 -90,A3 90}");
    controller.confirmAll();
    controller.robot().start();
    cell.until(() -> controller.robot().state() == ProgramState.END);
    assertThat(controller.axes().get(0)).isEqualTo(30);
  }

  @Test
  void stopsOnAPathThatLeavesTheReachAndGoesOnBehindIt() throws Exception {
    cell.start("LIN_REL {X 600}\nMYINT=5\nPTP {A1 10}");
    cell.until(() -> controller.robot().state() != ProgramState.ACTIVE);
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(cell.message()).contains("test.src:2:");
    assertThat(cell.get("$ROB_STOPPED")).isEqualTo("TRUE");
    double reached = pos("X");
    assertThat(reached).isGreaterThan(550);
    controller.confirmAll();
    controller.robot().start();
    cell.until(() -> controller.robot().state() == ProgramState.END);
    assertThat(controller.axes().get(0)).isEqualTo(10);
    assertThat(controller.messages()).hasSize(1);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "$BASE={X 1E30,Y 1E30,Z 1E30,A 1E30,B 1E30,C 1E30}\nLIN {X 1E30}",
        "$TOOL={X 1E38,Y 1E38,Z 1E38}\nLIN {X 1E38,Y 1E38}",
        "$VEL.CP=-1.0\nLIN_REL {X 1E20}",
        "CIRC {X 1E20},{Y 1E20}",
        "PTP {A1 1E38}"
      })
  void stopsAtNumbersWithWhichNothingCanBeComputed(String body) throws Exception {
    cell.start(body);
    cell.until(() -> controller.robot().state() != ProgramState.ACTIVE);
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(controller.messages()).hasSize(1);
    assertThat(controller.messages().get(0).number()).isIn(9101, 1211, 9103, 9106, 1456);
  }

  // software limits

  private static final String LIMITS =
      """
      DEFDAT $MACHINE PUBLIC
      REAL $SOFTP_END[12]
      $SOFTP_END[1]=20.0
      $SOFTP_END[2]=45.0
      $SOFTP_END[3]=156.0
      $SOFTP_END[4]=185.0
      $SOFTP_END[5]=120.0
      $SOFTP_END[6]=350.0
      ENDDAT
      """;

  @Test
  void takesTheSoftwareLimitsOfADataListThatWasLoadedBefore() throws Exception {
    VariableTable variables = VariableTable.krc4();
    variables.load("$machine.dat", LIMITS);
    try (Controller other = Cell.stepped(variables)) {
      assertThat(other.model().maximum(0)).isEqualTo(20);
    }
  }

  @Test
  void takesTheSoftwareLimitsOfADataListThatIsLoadedLater() throws Exception {
    controller.load("$machine.dat", LIMITS);
    assertThat(controller.model().maximum(0)).isEqualTo(20);
    assertStops("PTP {A1 21}", 1211, "A1 must be at most 20.000 degrees, would be 21.000");
  }

  @Test
  void newSoftwareLimitsHoldForMotionsPlannedFromThenOn() throws Exception {
    cell.start("$ADVANCE=0\nPTP {A1 60}\nPTP {A1 50}");
    cell.cycles(20);
    cell.set("$SOFTP_END[1]", "20");
    List<Double> way = new ArrayList<>();
    cell.until(
        () -> {
          way.add(controller.axes().get(0));
          return controller.robot().state() != ProgramState.ACTIVE;
        });
    assertThat(controller.axes().get(0)).isEqualTo(60);
    assertThat(way).isSorted();
    assertThat(cell.message()).startsWith("1211 test.src:4:");
  }

  @Test
  void keepsTheLimitsWhileAMinimumIsAboveItsMaximum() throws Exception {
    cell.set("$SOFTN_END[1]", "200");
    cell.run("PTP {A1 10}");
    assertThat(controller.model().minimum(0)).isEqualTo(-170);
  }

  // by hand

  @Test
  void placesTheRobotAtOnce() {
    controller.place(Axis.of(10, -80, 80, 0, 30, 0));
    assertThat(cell.component("$AXIS_ACT", "A1")).isEqualTo(10);
    assertThat(cell.component("$AXIS_FOR", "A1")).isEqualTo(10);
    assertThat(cell.component("$AXIS_BACK", "A1")).isEqualTo(10);
    assertThat(controller.standing()).isTrue();
  }

  @Test
  void placesTheRobotWithinItsLimitsOnly() {
    assertThatThrownBy(() -> controller.place(Axis.of(0, 46, 0, 0, 0, 0)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("place: A2 must be within its software limits, would be 46.0");
    assertThat(controller.axes()).isEqualTo(Cell.START);
  }

  @Test
  void aProgramThatWasStoppedOnAMotionGoesOnBehindItAfterPlacing() throws Exception {
    cell.start("PTP {A1 90}\nPTP_REL {A6 5}");
    cell.cycles(20);
    controller.robot().stop();
    cell.untilStanding();
    controller.place(Cell.START);
    controller.robot().start();
    cell.until(() -> controller.robot().state() == ProgramState.END);
    assertThat(controller.axes().get(0)).isLessThanOrEqualTo(90);
    assertThat(controller.messages()).isEmpty();
  }

  @Test
  void resetBrakesTheRobotAndForgetsItsMotions() throws Exception {
    cell.start("MYINT=MYINT+1\nPTP {A1 90}\nPTP {A1 0}");
    cell.cycles(20);
    controller.robot().reset();
    assertThat(controller.standing()).isFalse();
    controller.robot().start(); // while it still slows down
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("2");
    assertThat(controller.axes().get(0)).isZero();
  }

  @Test
  void cancelBrakesTheRobotAndForgetsItsMotions() throws Exception {
    cell.start("PTP {A1 90}");
    cell.cycles(20);
    controller.robot().cancel();
    cell.untilStanding();
    Axis stood = controller.axes();
    cell.run("WAIT SEC 1");
    assertThat(controller.axes()).isEqualTo(stood);
    cell.run("PTP {A1 0}");
  }

  @Test
  void anotherProgramBeginsWhereTheFirstWasLeft() throws Exception {
    cell.start("PTP {A1 90}");
    cell.cycles(20);
    controller.robot().stop();
    cell.load(Cell.module("OTHER", "PTP_REL {A1 10}"));
    controller.robot().select("OTHER");
    cell.untilStanding();
    double stood = controller.axes().get(0);
    controller.robot().start();
    cell.runToTheEnd();
    assertThat(controller.axes().get(0)).isCloseTo(stood + 10, within(1e-9));
  }

  @Test
  void aBaseThatIsTooFarAwayIsRefused() throws Exception {
    try (Cell cell = new Cell()) {
      cell.start("$BASE.X=1E30\nLIN_REL {Z -10}");
      cell.until(() -> cell.controller.robot().state() == ProgramState.STOP);

      assertThat(cell.message())
          .isEqualTo("9106 test.src:3:1: $BASE.X must be within 1e+09 mm, is 1.0e+30");
    }
  }

  @Test
  void circlesOfInlineFormsSetTheirMode() throws Exception {
    try (Cell cell = new Cell()) {
      cell.run(
          "DECL LDAT L\nL={VEL 2.0,CB {AUX_PT {ORI #CONSIDER},TARGET_PT {ORI #INTERPOLATE}}}\n"
              + "$CIRC_MODE=SCIRC_M(L)");

      assertThat(cell.get("$CIRC_MODE.AUX_PT.ORI")).isEqualTo("#CONSIDER");
      assertThat(cell.controller.variables().describe("$CIRC_MODE").orElseThrow().type())
          .isEqualTo("CIRC_MODE");
    }
  }
}
