package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.time.Duration;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Reads the system variables while programs run, and lets clients write those that may be. */
class ControllerVariablesTest {
  private Cell cell;
  private Controller controller;

  @BeforeEach
  void open() throws Exception {
    cell = new Cell();
    controller = cell.controller;
  }

  @AfterEach
  void close() throws Exception {
    cell.close();
  }

  private String read(String name) throws RefusedException {
    return controller.variables().read(name);
  }

  private void write(String name, String value) throws RefusedException {
    controller.variables().write(name, value, 0);
  }

  // programs

  @Test
  void aProgramSetsTheHomesAndTolerances() throws Exception {
    cell.run(
        """
        $AXIS_HOME[2]={A1 5.0,A2 -90.0,A3 90.0,A4 0.0,A5 0.0,A6 0.0}
        $H_POS_TOL.A1=1.5
        $H_AXIS_TOL[2].A1=1.5
        $APO_DIS_PTP[1]=45
        $SINGUL_STRATEGY=1
        $SINGUL_POS[3]=1
        $DEACTIVATE_ABS_ACCUR=TRUE
        """);

    assertThat(read("$AXIS_HOME[2].A1")).isEqualTo("5.00000");
    assertThat(read("$H_POS_TOL.A1")).isEqualTo("1.50000");
    assertThat(read("$DEACTIVATE_ABS_ACCUR")).isEqualTo("TRUE");
  }

  @Test
  void thePointerFollowsTheLines() throws Exception {
    cell.startModule(
        "TEST", Cell.module("TEST", "MYINT=1\nSUB1()") + Cell.module("SUB1", "WAIT FOR FALSE"));
    cell.cycles(2);
    assertThat(read("$PRO_IP1.NAME[]")).isEqualTo("\"/R1/TEST.SRC\"");
    assertThat(read("$PRO_IP1.SNR")).isEqualTo("6");
    assertThat(read("$PRO_IP1.SI01.SNR")).isEqualTo("6");
    assertThat(read("$PRO_IP1.SI02.SNR")).isEqualTo("3");
    assertThat(read("$PRO_IP.SNR_C")).isEqualTo("6");
    assertThat(read("$PRO_NAME[]")).isEqualTo("\"TEST\"");
    assertThat(read("$PRO_STATE")).isEqualTo("#P_ACTIVE");
    assertThat(read("$PRO_ACT")).isEqualTo("TRUE");
    assertThat(read("$PRO_MOVE")).isEqualTo("FALSE");
  }

  // the robot

  @Test
  void showsTheMotionUnderWay() throws Exception {
    cell.start("PTP {A1 60}\nPTP {A1 50}");
    cell.cycles(25);
    assertThat(read("$ROB_STOPPED")).isEqualTo("FALSE");
    assertThat(read("$OUT[1023]")).isEqualTo("FALSE");
    assertThat(read("$PRO_MOVE")).isEqualTo("TRUE");
    assertThat(cell.component("$AXIS_FOR", "A1")).isEqualTo(60);
    assertThat(cell.component("$AXIS_BACK", "A1")).isZero();
    assertThat(cell.component("$POS_FOR", "Y")).isLessThan(cell.component("$POS_ACT", "Y"));
    assertThat(cell.component("$POS_BACK", "Y")).isEqualTo(0, within(1e-3));
    assertThat(cell.real("$DIST_NEXT")).isNegative();
    assertThat(cell.real("$VEL_ACT")).isPositive();
    cell.until(() -> cell.component("$AXIS_FOR", "A1") == 50);
    assertThat(cell.component("$AXIS_BACK", "A1")).isEqualTo(60);
    cell.runToTheEnd();
    assertThat(read("$ROB_STOPPED")).isEqualTo("TRUE");
    assertThat(read("$PRO_MOVE")).isEqualTo("FALSE");
    assertThat(read("$VEL_ACT")).isEqualTo("0.0");
    assertThat(read("$VEL_AXIS_ACT[1]")).isEqualTo("0.0");
    assertThat(read("$DIST_NEXT").replace("-", "")).isEqualTo("0.0");
  }

  @ParameterizedTest
  @CsvSource({"C_PTP,PTP", "C_DIS,LIN"})
  void showsTheNextMotionFromTheMiddleOfABlend(String approximation, String kind) throws Exception {
    cell.start(
        "$APO.CPTP=50\n$APO.CDIS=20\n"
            + (kind + " {X 400,Y 0,Z 700} " + approximation + "\n")
            + (kind + " {X 400,Y 200,Z 700}\n"));
    cell.until(() -> cell.component("$POS_ACT", "Y") > 20);

    assertThat(cell.component("$POS_BACK", "X")).isEqualTo(400, within(1e-3));
    assertThat(cell.component("$POS_BACK", "Y")).isEqualTo(0, within(1e-3));
    assertThat(cell.component("$POS_FOR", "Y")).isEqualTo(200, within(1e-3));
  }

  @Test
  void distNextGrowsToZero() throws Exception {
    cell.start("LIN_REL {X -80}");
    double last = -80.01;
    cell.cycles(1);
    while (!controller.standing()) {
      double next = cell.real("$DIST_NEXT");
      assertThat(next).isGreaterThanOrEqualTo(last).isLessThanOrEqualTo(0);
      last = next;
      cell.cycles(1);
    }
  }

  @Test
  void knowsTheHomePosition() {
    cell.set("$H_POS", "{A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0}");
    controller.place(Axis.of(2, -88, 90, 0, 43, 0));
    assertThat(cell.get("$IN_HOME")).isEqualTo("TRUE");
    controller.place(Axis.of(2.01, -88, 90, 0, 43, 0));
    assertThat(cell.get("$IN_HOME")).isEqualTo("FALSE");
  }

  @Test
  void aSignalThatTheUserHasNotWiredDoesNoHarm() throws Exception {
    controller.load("$machine.dat", "DEFDAT $MACHINE PUBLIC\nSIGNAL $PRO_ACT FALSE\nENDDAT\n");
    cell.run("PTP {A1 10}");
    assertThat(cell.get("$PRO_ACT")).isEqualTo("FALSE");
  }

  @Test
  void doesWithoutVariablesThatTheUserHasRemoved() throws Exception {
    for (String name :
        new String[] {
          "$OV_PRO",
          "$ADVANCE",
          "$BASE",
          "$TOOL",
          "$VEL",
          "$APO",
          "$ORI_TYPE",
          "$H_POS",
          "$POS_ACT",
          "$TIMER",
          "$ROB_STOPPED",
          "$VEL_AXIS",
          "$ERR",
          "$SOFTN_END"
        }) {
      controller.variables().remove(name);
    }
    cell.run("PTP {A1 10}\nLIN_REL {Y 10} C_DIS\nLIN_REL {Y -10}");
    assertThat(controller.axes().get(0)).isCloseTo(10, within(1e-3));
  }

  @Test
  void putsAnOutputRightThatSomebodyElseHasChanged() {
    cell.set("$OUT[1023]", "FALSE");
    cell.cycles(1);
    assertThat(cell.get("$ROB_STOPPED")).isEqualTo("TRUE");
  }

  // time

  @Test
  void timersCountSimulatedTime() throws Exception {
    write("$TIMER[3]", "-24");
    write("$TIMER_STOP[3]", "FALSE");
    cell.cycles(2);
    assertThat(read("$TIMER[3]")).isEqualTo("0");
    assertThat(read("$TIMER_FLAG[3]")).isEqualTo("FALSE");
    cell.cycles(1);
    assertThat(read("$TIMER[3]")).isEqualTo("12");
    assertThat(read("$TIMER_FLAG[3]")).isEqualTo("TRUE");
    write("$TIMER_STOP[3]", "TRUE");
    cell.cycles(5);
    assertThat(read("$TIMER[3]")).isEqualTo("12");
    assertThat(read("$TIMER[4]")).isEqualTo("0");
  }

  @Test
  void aTimerStaysAtTheEndOfItsRange() {
    cell.set("$TIMER[1]", "2147483640");
    cell.set("$TIMER_STOP[1]", "FALSE");
    cell.cycles(3);
    assertThat(cell.get("$TIMER[1]")).isEqualTo("2147483647");
  }

  @Test
  void theClockOfTheControllerGoesOn() throws Exception {
    assertThat(read("$DATE"))
        .isEqualTo("{DATE: CSEC 0, SEC 30, MIN 15, HOUR 10, DAY 14, MONTH 3, YEAR 2014}");
    int before = Integer.parseInt(read("$ROB_TIMER"));
    cell.seconds(45);
    assertThat(read("$DATE.SEC")).isEqualTo("15");
    assertThat(read("$DATE.MIN")).isEqualTo("16");
    assertThat(Integer.parseInt(read("$ROB_TIMER")) - before).isEqualTo(45_000);
  }

  @Test
  void waitSecTakesSimulatedTime() throws Exception {
    long before = controller.time().toMillis();
    cell.run("WAIT SEC 1.5");
    assertThat(controller.time().toMillis() - before).isBetween(1500L, 1524L);
  }

  // inputs and outputs

  @Test
  void pulseSwitchesAnOutputForATime() throws Exception {
    cell.run("PULSE($OUT[5],TRUE,0.12)");
    assertThat(read("$OUT[5]")).isEqualTo("TRUE");
    cell.cycles(8);
    assertThat(read("$OUT[5]")).isEqualTo("TRUE");
    cell.cycles(2);
    assertThat(read("$OUT[5]")).isEqualTo("FALSE");
  }

  @Test
  void aPulseThatIsLongerThanAllTimeDoesNotEnd() throws Exception {
    cell.run("PULSE($OUT[5],TRUE,1E30)");
    cell.cycles(10);
    assertThat(cell.get("$OUT[5]")).isEqualTo("TRUE");
  }

  @Test
  void aNewPulseTakesThePlaceOfTheOldOne() throws Exception {
    cell.run("PULSE($OUT[5],TRUE,0.12)\nPULSE($OUT[5],TRUE,0.24)");
    cell.cycles(15);
    assertThat(read("$OUT[5]")).isEqualTo("TRUE");
    cell.cycles(6);
    assertThat(read("$OUT[5]")).isEqualTo("FALSE");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "PULSE($OUT[4097],TRUE,1)|1444 test.src:2:1: there is no $OUT[4097]",
        "PULSE($OUT[1],TRUE,0)|1422 test.src:2:1: a pulse takes more than 0 s, was given 0.0",
        "PULSE($OUT[1],TRUE,-1)|1422 test.src:2:1: a pulse takes more than 0 s, was given -1.0"
      })
  void refusesAPulseThatCannotBe(String statement, String message) throws Exception {
    cell.start(statement);
    cell.cycles(1);
    assertThat(cell.message()).isEqualTo(message);
    assertThat(cell.get("$OUT[1]")).isEqualTo("FALSE");
  }

  @Test
  void waitsForAnInputThatJavaSets() throws Exception {
    cell.start("WAIT FOR $IN[3]\n$OUT[7]=TRUE");
    cell.cycles(5);
    assertThat(read("$OUT[7]")).isEqualTo("FALSE");
    cell.set("$IN[3]", "TRUE");
    cell.cycles(1);
    assertThat(read("$OUT[7]")).isEqualTo("TRUE");
  }

  @Test
  void waitsForAVariableThatAClientSets() throws Exception {
    cell.start("WAIT FOR $FLAG[3] AND (MYINT==5)\nMYREAL=MYINT*2");
    write("$FLAG[3]", "TRUE");
    cell.cycles(3);
    assertThat(cell.get("$PRO_STATE1")).isEqualTo("#P_ACTIVE");
    write("MYINT", "5");
    cell.cycles(1);
    assertThat(read("MYREAL")).isEqualTo("10.0000");
  }

  // ranges

  @ParameterizedTest
  @CsvSource({
    "$OV_PRO,500,100",
    "$OV_PRO,-1,100",
    "$ADVANCE,6,3",
    "$VEL_AXIS[1],0,100",
    "$VEL_AXIS[1],101,100",
    "$ANOUT[1],1.1,0.0"
  })
  void refusesAClientAValueOutOfRange(String name, String value, String kept) throws Exception {
    assertThatThrownBy(() -> write(name, value)).isInstanceOf(RefusedException.class);
    assertThat(read(name)).isEqualTo(kept);
  }

  @Test
  void takesTheBoundsOfARange() throws Exception {
    write("$OV_PRO", "0");
    write("$OV_PRO", "100");
    write("$ADVANCE", "5");
    write("$VEL_AXIS[12]", "1");
    write("$ANOUT[32]", "-1");
  }

  @Test
  void keepsTheRangesWithoutAControllerAndInACopy() throws Exception {
    assertThat(catchThrowable(() -> VariableTable.krc4().write("$OV_PRO", "101", 0)))
        .isInstanceOf(RefusedException.class);
    assertThat(catchThrowable(() -> VariableTable.krc4().copy().write("$OV_PRO", "101", 0)))
        .hasMessage("must be 0 to 100, was given 101");
  }

  @Test
  void stopsAProgramThatWritesAValueOutOfRange() throws Exception {
    cell.start("$OV_PRO=101");
    cell.cycles(1);
    assertThat(cell.message())
        .startsWith("1422 test.src:2:")
        .contains("must be 0 to 100, was given 101");
    cell.set("$OV_PRO", "50");
    controller.confirmAll();
    cell.start("$VEL_AXIS[]=0");
    cell.cycles(1);
    assertThat(controller.messages().get(1).number()).isEqualTo(1422);
  }

  // saved

  @Test
  void goesOnWithTheStateOfAnotherServer(@TempDir Path folder) throws Exception {
    cell.start("PTP {A1 90}\nWAIT FOR FALSE");
    cell.cycles(20);
    Path file = folder.resolve("state.dat");
    controller.variables().save(file);
    Axis saved = controller.axes();
    String outputs = cell.get("$ROB_STOPPED");
    assertThat(outputs).isEqualTo("FALSE");
    VariableTable variables = VariableTable.krc4();
    variables.load(file);
    try (Controller other = Cell.stepped(variables)) {
      assertThat(other.axes().largestDifference(saved)).isLessThan(1e-4);
      assertThat(other.variables().get("$ROB_STOPPED")).isEqualTo("TRUE");
      assertThat(other.variables().get("$MODE_OP")).isEqualTo("#T1");
      assertThat(other.variables().get("$PRO_STATE1")).isEqualTo("#P_FREE");
      other.setMode(OperatingMode.AUT);
      other.load("test.src", Cell.module("TEST", "PTP {A1 10}"));
      other.robot().select("TEST");
      other.robot().start();
      other.step(Duration.ofSeconds(10));
      assertThat(other.axes().get(0)).isEqualTo(10);
    }
  }

  @Test
  void followsTheRobotAfterAStateWasLoaded(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("state.dat");
    controller.variables().save(file);
    cell.start("PTP {A1 90}\nWAIT FOR FALSE");
    cell.cycles(20);
    controller.load(file);
    cell.cycles(20);
    assertThat(cell.component("$AXIS_ACT", "A1")).isCloseTo(controller.axes().get(0), within(1e-4));
    assertThat(cell.get("$MODE_OP")).isEqualTo("#AUT");
    assertThat(cell.get("$ROB_STOPPED")).isEqualTo("FALSE");
    cell.seconds(3);
    assertThat(controller.axes().get(0)).isEqualTo(90);
  }
}
