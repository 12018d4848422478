package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Interrupts the robot on its way, and fires triggers. */
class ControllerInterruptTest {
  private Cell cell;
  private Controller controller;
  private ProgramControl robot;

  @BeforeEach
  void open() throws IOException {
    cell = new Cell();
    controller = cell.controller;
    robot = controller.robot();
  }

  @AfterEach
  void close() {
    cell.close();
  }

  /** Starts a program with routines for its interrupts, and lets the robot set off. */
  private void start(String body, String... routines) throws KrlFileException {
    StringBuilder text = new StringBuilder(Cell.module("TEST", body));
    for (int i = 0; i < routines.length; i++) {
      text.append(Cell.module("IR" + (i + 1), routines[i]));
    }
    cell.startModule("TEST", text.toString());
    cell.cycles(12);
    assertThat(controller.standing()).isFalse();
  }

  private static String on(int number) {
    return "INTERRUPT DECL "
        + number
        + " WHEN $FLAG["
        + number
        + "] DO IR"
        + number
        + "()\nINTERRUPT ON "
        + number
        + "\n";
  }

  private double a(int axis) {
    return controller.axes().get(axis - 1);
  }

  // interrupts

  @Test
  void runsARoutineWhileTheRobotGoesOn() throws Exception {
    start(on(1) + "PTP {A1 90}", "MYINT=1");
    cell.set("$FLAG[1]", "TRUE");
    cell.cycles(1);
    assertThat(cell.get("MYINT")).isEqualTo("1");
    assertThat(controller.standing()).isFalse();
    cell.runToTheEnd();
    assertThat(a(1)).isEqualTo(90);
  }

  @Test
  void brakesAndGoesOn() throws Exception {
    start(on(1) + "PTP {A1 90}", "BRAKE\nMYINT=1\nWAIT FOR MYBOOL");
    double raised = a(1);
    cell.set("$FLAG[1]", "TRUE");
    cell.cycles(1);
    assertThat(cell.component("$AXIS_INT", "A1")).isCloseTo(a(1), within(5.0));
    assertThat(cell.component("$AXIS_INT", "A1")).isGreaterThanOrEqualTo(raised);
    cell.untilStanding();
    cell.cycles(2);
    assertThat(cell.component("$AXIS_RET", "A1")).isCloseTo(a(1), within(1e-4));
    assertThat(a(1)).isGreaterThan(cell.component("$AXIS_INT", "A1")).isLessThan(89);
    cell.set("MYBOOL", "TRUE");
    cell.runToTheEnd();
    assertThat(a(1)).isEqualTo(90);
  }

  @Test
  void brakeFStopsSooner() throws Exception {
    start(on(1) + "$ACC_AXIS[1]=20\nPTP {A1 160}", "BRAKE\nWAIT FOR FALSE");
    cell.set("$FLAG[1]", "TRUE");
    cell.untilStanding();
    double soft = a(1);
    robot.cancel();
    cell.set("$FLAG[1]", "FALSE");
    controller.place(Cell.START);
    start(on(1) + "$ACC_AXIS[1]=20\nPTP {A1 160}", "BRAKE F\nWAIT FOR FALSE");
    cell.set("$FLAG[1]", "TRUE");
    cell.untilStanding();
    assertThat(a(1)).isLessThan(soft);
  }

  @Test
  void movesInTheRoutineAndComesBackToThePath() throws Exception {
    start(on(1) + "PTP {A1 90} C_PTP\nPTP {A6 10}", "BRAKE\nPTP_REL {A5 -20}\nMYINT=1");
    cell.set("$FLAG[1]", "TRUE");
    double[] least = {90};
    cell.until(
        () -> {
          least[0] = Math.min(least[0], a(5));
          return robot.state() != ProgramState.ACTIVE;
        });
    assertThat(controller.messages()).isEmpty();
    assertThat(least[0]).isEqualTo(25);
    assertThat(controller.axes()).isEqualTo(Axis.of(90, -90, 90, 0, 45, 10));
  }

  @Test
  void resumeRightAfterBrakeForgetsTheMotion() throws Exception {
    start(
        "INTERRUPT DECL 1 WHEN $FLAG[1] DO IR1()\nINTERRUPT ON 1\nIR2()\nMYINT=7\nPTP_REL {A6 5}",
        "BRAKE\nRESUME",
        "PTP {A1 90}\nPTP {A1 0}\nWAIT SEC 0\nMYBOOL=TRUE");
    cell.set("$FLAG[1]", "TRUE");
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("7");
    assertThat(cell.get("MYBOOL")).isEqualTo("FALSE");
    assertThat(a(1)).isBetween(1.0, 89.0);
    assertThat(a(6)).isEqualTo(5);
  }

  @Test
  void resumeWaitsForTheMotionsOfItsRoutine() throws Exception {
    start(
        "INTERRUPT DECL 1 WHEN $FLAG[1] DO IR1()\nINTERRUPT ON 1\nIR2()\nPTP_REL {A6 5}",
        "BRAKE\nPTP_REL {A5 -20}\nPTP_REL {A5 10}\nRESUME",
        "PTP {A1 90}\nWAIT SEC 0");
    cell.set("$FLAG[1]", "TRUE");
    cell.runToTheEnd();
    assertThat(a(1)).isBetween(1.0, 89.0);
    assertThat(a(5)).isEqualTo(35);
    assertThat(a(6)).isEqualTo(5);
  }

  @Test
  void resumeFollowsTheReturnToTheInterruptedPoint() throws Exception {
    start(
        "INTERRUPT DECL 1 WHEN $FLAG[1] DO IR1()\nINTERRUPT ON 1\nIR2()\nMYINT=7\nPTP_REL {A6 5}",
        "BRAKE\nPTP $AXIS_INT\nRESUME",
        "PTP {A1 90}\nWAIT SEC 0");
    cell.set("$FLAG[1]", "TRUE");
    cell.until(() -> cell.get("MYINT").equals("7"));
    assertThat(a(1))
        .isCloseTo(cell.component("$AXIS_INT", "A1"), within(1e-4))
        .isBetween(1.0, 89.0);
    cell.runToTheEnd();
    assertThat(a(6)).isEqualTo(5);
  }

  @Test
  void nestedInterruptsBrakeWhileTheRobotStillSlowsDown() throws Exception {
    start(
        on(2) + on(1) + "PTP {A1 90}",
        "BRAKE\nPTP_REL {A6 7}\nMYINT=1",
        "BRAKE\nPTP_REL {A5 -20}\nMYINTS[1]=1");
    cell.set("$FLAG[2]", "TRUE");
    cell.cycles(1);
    assertThat(controller.standing()).isFalse();
    cell.set("$FLAG[1]", "TRUE");
    double[] least = {90};
    double[] most = {0};
    cell.until(
        () -> {
          least[0] = Math.min(least[0], a(5));
          most[0] = Math.max(most[0], a(6));
          return robot.state() != ProgramState.ACTIVE;
        });
    assertThat(controller.messages()).isEmpty();
    assertThat(cell.get("MYINT")).isEqualTo("1");
    assertThat(cell.get("MYINTS[1]")).isEqualTo("1");
    assertThat(least[0]).isEqualTo(25);
    assertThat(most[0]).isEqualTo(7);
    assertThat(controller.axes()).isEqualTo(Axis.of(90, -90, 90, 0, 45, 0));
  }

  @Test
  void resumeInANestedInterruptKeepsThePlanOfTheOuterOne() throws Exception {
    start(
        on(2) + "PTP {A1 90}",
        "BRAKE\nRESUME",
        "INTERRUPT DECL 1 WHEN $FLAG[1] DO IR1()\nINTERRUPT ON 1\nBRAKE\nIR3()",
        "PTP_REL {A5 -40}\nWAIT SEC 0\nMYBOOL=TRUE");
    cell.set("$FLAG[2]", "TRUE");
    cell.untilStanding();
    cell.until(() -> a(5) < 40);
    cell.set("$FLAG[1]", "TRUE");
    cell.runToTheEnd();
    assertThat(cell.get("MYBOOL")).isEqualTo("FALSE");
    assertThat(controller.axes()).isEqualTo(Axis.of(90, -90, 90, 0, 45, 0));
  }

  @Test
  void comesBackToThePathAfterAFaultInTheRoutine() throws Exception {
    start(on(1) + "PTP {A1 60}", "BRAKE\nLIN_REL {X 600}\nMYINT=1");
    cell.set("$FLAG[1]", "TRUE");
    cell.until(() -> robot.state() == ProgramState.STOP);
    assertThat(controller.messages()).hasSize(1);
    controller.confirmAll();
    robot.start();
    cell.until(() -> robot.state() != ProgramState.ACTIVE);
    assertThat(robot.state()).isEqualTo(ProgramState.END);
    assertThat(cell.get("MYINT")).isEqualTo("1");
    assertThat(controller.axes()).isEqualTo(Axis.of(60, -90, 90, 0, 45, 0));
  }

  @Test
  void endsTheRoutineWhereTheRobotWasPlacedInTheMeantime() throws Exception {
    start(on(1) + "PTP {A1 60}\nPTP_REL {A6 5}", "BRAKE\nHALT\nMYINT=1");
    cell.set("$FLAG[1]", "TRUE");
    cell.until(() -> robot.state() == ProgramState.STOP);
    controller.place(Cell.START);
    robot.start();
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("1");
  }

  @Test
  void comesBackToAPathThatNewSoftwareLimitsWouldForbid() throws Exception {
    start(on(1) + "PTP {A1 60}", "BRAKE\nPTP {A1 0}\nHALT");
    cell.set("$FLAG[1]", "TRUE");
    cell.until(() -> robot.state() == ProgramState.STOP);
    cell.set("$SOFTP_END[1]", "1");
    robot.start();
    cell.runToTheEnd();
    assertThat(a(1)).isEqualTo(60);
  }

  @Test
  void aHaltInARoutineBrakesTheRobotAtOnce() throws Exception {
    start(on(1) + "PTP {A1 90}", "HALT\nMYINT=1");
    cell.set("$FLAG[1]", "TRUE");
    cell.until(() -> robot.state() == ProgramState.STOP);
    cell.untilStanding();
    assertThat(a(1)).isLessThan(89);
    robot.start();
    cell.runToTheEnd();
    assertThat(a(1)).isEqualTo(90);
  }

  @Test
  void stoppedInARoutineItGoesOnThere() throws Exception {
    start(on(1) + "PTP {A1 90}", "BRAKE\nPTP_REL {A5 -20}\nMYINT=1");
    cell.set("$FLAG[1]", "TRUE");
    cell.until(() -> a(5) < 40);
    assertThat(cell.get("$PRO_IP1.SI01.INT_FLAG")).isEqualTo("TRUE");
    assertThat(cell.get("$PRO_IP1.SI02.INT_FLAG")).isEqualTo("FALSE");
    controller.setMode(OperatingMode.T2);
    cell.seconds(1);
    assertThat(a(5)).isBetween(25.1, 39.9);
    robot.start();
    cell.until(() -> robot.state() == ProgramState.END);
    assertThat(controller.axes()).isEqualTo(Axis.of(90, -90, 90, 0, 45, 0));
  }

  // triggers

  /** Returns where A1 is when an output comes on. */
  private double firedAt(String trigger) throws KrlFileException {
    controller.place(Cell.START);
    cell.set("$OUT[1]", "FALSE");
    cell.start(trigger + " DO $OUT[1]=TRUE\nPTP {A1 60}\nWAIT SEC 1");
    cell.until(() -> cell.get("$OUT[1]").equals("TRUE"));
    double place = a(1);
    cell.runToTheEnd();
    return place;
  }

  @Test
  void firesAtStartAndEndOfAMotion() throws Exception {
    double start = firedAt("TRIGGER WHEN DISTANCE=0 DELAY=0");
    double later = firedAt("TRIGGER WHEN DISTANCE=0 DELAY=120");
    double early = firedAt("TRIGGER WHEN DISTANCE=1 DELAY=-60");
    double end = firedAt("TRIGGER WHEN DISTANCE=1 DELAY=0");
    assertThat(start).isLessThan(1);
    assertThat(later).isGreaterThan(start + 1).isLessThan(early);
    assertThat(early).isLessThan(60);
    assertThat(end).isEqualTo(60);
  }

  @Test
  void firesAtADistanceFromTheEnd() throws Exception {
    double x = cell.component("$POS_ACT", "X");
    cell.start("TRIGGER WHEN PATH=-40 DELAY=0 DO $OUT[1]=TRUE\nLIN_REL {X -100}\nWAIT SEC 1");
    cell.until(() -> cell.get("$OUT[1]").equals("TRUE"));
    assertThat(x - cell.component("$POS_ACT", "X")).isBetween(60.0, 75.0);
    cell.runToTheEnd();
  }

  @Test
  void firesBehindTheEndOfAMotionThatIsBlended() throws Exception {
    double x = cell.component("$POS_ACT", "X");
    cell.start(
        "$VEL.CP=0.2\nTRIGGER WHEN PATH=30 DELAY=0 DO $OUT[1]=TRUE\n"
            + "LIN_REL {X -50} C_DIS\nLIN_REL {X -80}\nWAIT SEC 1");
    cell.until(() -> cell.get("$OUT[1]").equals("TRUE"));
    assertThat(x - cell.component("$POS_ACT", "X")).isBetween(75.0, 90.0);
    cell.runToTheEnd();
  }

  @Test
  void callsASubprogramByATrigger() throws Exception {
    cell.startModule(
        "TEST",
        Cell.module(
                "TEST", "TRIGGER WHEN DISTANCE=1 DELAY=0 DO IR1() PRIO=-1\nPTP {A1 20}\nWAIT SEC 1")
            + Cell.module("IR1", "MYINT=MYINT+1"));
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("1");
  }

  @Test
  void forgetsTheTriggersOfMotionsThatAreReset() throws Exception {
    cell.start("TRIGGER WHEN DISTANCE=1 DELAY=0 DO $OUT[1]=TRUE\nPTP {A1 60}");
    cell.cycles(20);
    robot.cancel();
    cell.run("PTP {A1 50}\nPTP {A1 60}");
    assertThat(cell.get("$OUT[1]")).isEqualTo("FALSE");
  }

  @Test
  void keepsTheTriggerOfAMotionThatAnInterruptPutsAside() throws Exception {
    start(
        on(2) + "TRIGGER WHEN DISTANCE=1 DELAY=0 DO $OUT[1]=TRUE\nPTP {A1 90}\nWAIT SEC 1",
        "BRAKE\nRESUME",
        "INTERRUPT DECL 1 WHEN $FLAG[1] DO IR1()\nINTERRUPT ON 1\nBRAKE\nIR3()",
        "PTP_REL {A5 -40}\nWAIT SEC 0");
    cell.set("$FLAG[2]", "TRUE");
    cell.until(() -> a(5) < 40);
    cell.set("$FLAG[1]", "TRUE");
    cell.runToTheEnd();
    assertThat(cell.get("$OUT[1]")).isEqualTo("TRUE");
  }
}
