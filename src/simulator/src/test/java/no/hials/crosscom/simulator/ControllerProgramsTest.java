package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.KrlBool;
import no.hials.crosscom.protocol.value.KrlInt;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Selects, starts and stops programs, and does what the state does not allow. */
class ControllerProgramsTest {
  private static final String LOOP =
      Cell.module("TURN", "LOOP\nMYINT=MYINT+1\nWAIT SEC 0.012\nENDLOOP");

  private Cell cell;
  private ProgramControl robot;

  @BeforeEach
  void open() throws IOException {
    cell = new Cell();
    robot = cell.controller.robot();
  }

  @AfterEach
  void close() {
    cell.close();
  }

  private void assertRefused(Runnable action, String reason) {
    ProgramState before = robot.state();
    assertThatThrownBy(action::run).isInstanceOf(IllegalStateException.class).hasMessage(reason);
    assertThat(robot.state()).isEqualTo(before);
  }

  @Test
  void showsNoProgramAtFirst() {
    assertThat(robot.state()).isEqualTo(ProgramState.FREE);
    assertThat(robot.program()).isEmpty();
    assertThat(robot.line()).isZero();
    assertThat(cell.get("$PRO_STATE0")).isEqualTo("#P_FREE");
    assertThat(cell.get("$PRO_STATE1")).isEqualTo("#P_FREE");
    assertThat(cell.get("$PRO_NAME1[]")).isEqualTo("\" \"");
    assertThat(cell.controller).hasToString("AUT, no program");
  }

  @Test
  void showsTheSameWithoutAController() throws IOException {
    VariableTable variables = VariableTable.krc4();
    for (String name : List.of("$PRO_STATE", "$PRO_NAME", "$PRO_IP")) {
      for (String interpreter : List.of("", "0", "1")) {
        String variable = name + interpreter + (name.equals("$PRO_NAME") ? "[]" : "");
        String before = variables.get(variable);
        if (!name.equals("$PRO_IP")) {
          assertThat(cell.get(variable)).isEqualTo(before);
        } else {
          assertThat(before).contains("NAME[] \" \", SNR 0");
          assertThat(cell.get(variable)).contains("NAME[] \" \", SNR 0");
        }
      }
    }
  }

  @Test
  void runsThroughAllStates() throws Exception {
    cell.load(Cell.module("TEST", "MYINT=1\nWAIT FOR MYBOOL\nMYINT=2"));
    robot.select("test");
    assertThat(cell.get("$PRO_STATE1")).isEqualTo("#P_RESET");
    assertThat(cell.get("$PRO_NAME1[]")).isEqualTo("\"TEST\"");
    robot.start();
    assertThat(cell.get("$PRO_STATE1")).isEqualTo("#P_ACTIVE");
    cell.cycles(2);
    assertThat(robot.line()).isEqualTo(3);
    robot.stop();
    assertThat(cell.get("$PRO_STATE1")).isEqualTo("#P_STOP");
    robot.start();
    cell.set("MYBOOL", "TRUE");
    cell.cycles(1);
    assertThat(cell.get("$PRO_STATE1")).isEqualTo("#P_END");
    assertThat(cell.get("MYINT")).isEqualTo("2");
    robot.cancel();
    assertThat(cell.get("$PRO_STATE1")).isEqualTo("#P_FREE");
    assertThat(robot.program()).isEmpty();
  }

  @Test
  void executesNothingBeforeItsStartAndWhileStopped() throws Exception {
    cell.load(LOOP);
    robot.select("TURN");
    cell.cycles(5);
    assertThat(cell.get("MYINT")).isEqualTo("0");
    robot.start();
    cell.cycles(5);
    robot.stop();
    String count = cell.get("MYINT");
    assertThat(count).isNotEqualTo("0");
    cell.cycles(5);
    assertThat(cell.get("MYINT")).isEqualTo(count);
  }

  @Test
  void beginsAgainFromItsEnd() throws Exception {
    cell.run("MYINT=MYINT+1");
    robot.start();
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("2");
  }

  @Test
  void beginsAgainAfterAReset() throws Exception {
    cell.start("MYINT=MYINT+1\nWAIT FOR FALSE");
    cell.cycles(1);
    robot.reset();
    assertThat(robot.state()).isEqualTo(ProgramState.RESET);
    robot.start();
    cell.cycles(1);
    assertThat(cell.get("MYINT")).isEqualTo("2");
  }

  @Test
  void refusesWhatNeedsAProgram() {
    assertRefused(robot::start, "start: no program is selected");
    assertRefused(robot::reset, "reset: no program is selected");
    robot.stop();
    robot.cancel();
    assertThat(robot.state()).isEqualTo(ProgramState.FREE);
  }

  @Test
  void refusesWhatMustNotDisturbAnActiveProgram() throws Exception {
    cell.start("WAIT FOR FALSE");
    cell.load(LOOP);
    assertRefused(robot::start, "start: a program is active, stop it first");
    assertThatThrownBy(() -> robot.select("TURN"))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("select: a program is active, stop it first");
    assertRefused(
        () -> cell.controller.place(Cell.START), "place: a program is active, stop it first");
    assertThat(robot.program()).hasValue("TEST");
  }

  @Test
  void refusesAnUnknownProgramAndKeepsTheOther() throws Exception {
    cell.load(LOOP);
    robot.select("TURN");
    assertThatThrownBy(() -> robot.select("GHOST"))
        .isInstanceOf(KrlFileException.class)
        .hasMessageContaining("no module GHOST is loaded");
    assertThat(robot.program()).hasValue("TURN");
    assertThat(cell.controller.check("GHOST")).hasSize(1);
  }

  @Test
  void saysWhereAProgramIsWrong() throws Exception {
    cell.controller.load("bad.src", "DEF BAD()\n  NOBODY=1\nEND\n");
    assertThat(cell.controller.check("BAD"))
        .extracting(Object::toString)
        .containsExactly("bad.src:2:3: no variable NOBODY is declared");
    assertThatThrownBy(() -> robot.select("BAD"))
        .isInstanceOf(KrlFileException.class)
        .hasMessage("bad.src:2:3: no variable NOBODY is declared");
    assertThat(robot.state()).isEqualTo(ProgramState.FREE);
  }

  @Test
  void givesValuesToParameters() throws Exception {
    cell.load("DEF TEST(N:IN,B:IN)\nINT N\nBOOL B\nMYINT=N\nMYBOOL=B\nEND\n");
    robot.select("TEST", List.of(new KrlInt(7), new KrlBool(true)));
    robot.start();
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("7");
    assertThat(cell.get("MYBOOL")).isEqualTo("TRUE");
  }

  @Test
  void refusesValuesThatDoNotSuitTheParameters() throws Exception {
    cell.load("DEF TEST(N:IN)\nINT N\nMYINT=N\nEND\n");
    assertThatThrownBy(() -> robot.select("TEST", List.of(new KrlBool(true))))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("TEST: N: needs INT, was given TRUE");
    assertThatThrownBy(() -> robot.select("TEST", List.of(new KrlInt(1), new KrlInt(2))))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("TEST: TEST has 1 parameters, was given 2");
    assertThat(robot.state()).isEqualTo(ProgramState.FREE);
  }

  @Test
  void keepsTheOldModuleUntilItIsSelectedAgain() throws Exception {
    cell.load(Cell.module("TEST", "MYINT=1"));
    robot.select("TEST");
    cell.load(Cell.module("TEST", "MYINT=2"));
    robot.start();
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("1");
    robot.select("TEST");
    robot.start();
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("2");
  }

  // faults

  @Test
  void stopsAtAFaultAndGoesOnWithTheSameStatement() throws Exception {
    cell.start("MYREAL=1.0/MYINT\nMYBOOL=TRUE");
    cell.cycles(1);
    assertThat(robot.state()).isEqualTo(ProgramState.STOP);
    assertThat(cell.message()).startsWith("9005 test.src:2:").contains("must not be 0");
    assertThat(cell.get("$STOPMESS")).isEqualTo("TRUE");
    assertThat(cell.get("$ERR.NUMBER")).isEqualTo("9005");
    assertThat(cell.get("$ERR.LINE_NR")).isEqualTo("2");
    assertThat(cell.get("$ERR.MODULE[]")).isEqualTo("\"/R1/TEST.SRC\"");
    assertThat(cell.get("$ERR.UP_NAME[]")).isEqualTo("\"TEST\"");
    assertThat(cell.get("$ERR.INTERPRETER")).isEqualTo("#R_INT");
    assertRefused(robot::start, "start: a message has to be confirmed first");

    assertThat(cell.controller.confirmAll()).isEqualTo(1);
    assertThat(cell.get("$STOPMESS")).isEqualTo("FALSE");
    cell.set("MYINT", "2");
    robot.start();
    cell.cycles(1);
    assertThat(robot.state()).isEqualTo(ProgramState.END);
    assertThat(cell.get("MYREAL")).isEqualTo("0.500000");
    assertThat(cell.controller.confirmAll()).isZero();
  }

  @Test
  void haltStopsAfterTheMotionBeforeAndNeedsNoConfirmation() throws Exception {
    cell.start("PTP {A1 10}\nHALT\nMYINT=1");
    cell.until(() -> robot.state() == ProgramState.STOP);
    assertThat(cell.controller.axes().get(0)).isEqualTo(10);
    assertThat(cell.controller.messages()).isEmpty();
    cell.cycles(2);
    assertThat(cell.get("MYINT")).isEqualTo("0");
    robot.start();
    cell.runToTheEnd();
    assertThat(cell.get("MYINT")).isEqualTo("1");
  }

  // submit

  @Test
  void runsASubmitProgramBesideTheRobots() throws Exception {
    cell.submit("LOOP\nMYINTS[1]=MYINTS[1]+1\nWAIT SEC 0.012\nENDLOOP");
    cell.start("PTP {A1 20}");
    cell.runToTheEnd();
    assertThat(cell.controller.submit().state()).isEqualTo(ProgramState.ACTIVE);
    assertThat(cell.get("$PRO_STATE0")).isEqualTo("#P_ACTIVE");
    assertThat(cell.get("$PRO_NAME0[]")).isEqualTo("\"SPS\"");
    assertThat(cell.get("$PRO_IP0.NAME[]")).isEqualTo("\"/R1/SPS.SUB\"");
    assertThat(Integer.parseInt(cell.get("MYINTS[1]"))).isGreaterThan(20);
    assertThat(cell.controller.toString())
        .startsWith("AUT, TEST #P_END line ")
        .contains("submit SPS");
  }

  @Test
  void stopsASubmitProgramThatWantsToMoveTheRobot() throws Exception {
    cell.submit("MYINT=1\nPTP {A1 20}");
    cell.cycles(1);
    assertThat(cell.controller.submit().state()).isEqualTo(ProgramState.STOP);
    assertThat(cell.message()).startsWith("9010 sps.sub:3:");
    assertThat(cell.get("$ERR.INTERPRETER")).isEqualTo("#S_INT");
    assertThat(cell.get("$ERR.MODULE[]")).isEqualTo("\"/R1/SPS.SUB\"");
    assertThat(cell.get("$ERR.LINE_NR")).isEqualTo("3");
  }

  @Test
  void startsTheRobotAfterAnErrorOfTheSubmitProgram() throws Exception {
    cell.submit("MYINT=1\nPTP {A1 20}");
    cell.cycles(1);
    assertThat(cell.message()).startsWith("9010 sps.sub:3:");
    assertThat(cell.get("$STOPMESS")).isEqualTo("FALSE");

    cell.start("PTP {A1 20}");
    cell.until(() -> cell.controller.robot().state() == ProgramState.END);

    assertThat(cell.get("$AXIS_ACT.A1")).isEqualTo("20.0000");
    assertThat(cell.controller.submit().state()).isEqualTo(ProgramState.STOP);
  }

  @Test
  void doesNotNeedAModeOrAConfirmationForTheSubmitProgram() throws Exception {
    cell.controller.setMode(OperatingMode.EXT);
    cell.controller.emergencyStop(true);
    cell.submit("MYINT=1");
    cell.cycles(1);
    assertThat(cell.controller.submit().state()).isEqualTo(ProgramState.END);
    cell.controller.submit().reset();
    cell.controller.submit().cancel();
    assertThat(cell.controller.submit().program()).isEmpty();
  }

  @Test
  void sharesTheTimeOfACycleWithALoopThatNeverWaits() throws Exception {
    cell.submit("LOOP\nMYINTS[1]=1\nENDLOOP");
    cell.start("LOOP\nMYINT=MYINT+1\nENDLOOP");
    cell.cycles(3);
    int count = Integer.parseInt(cell.get("MYINT"));
    cell.cycles(1);
    assertThat(Integer.parseInt(cell.get("MYINT")) - count).isBetween(1, 1000);
    assertThat(cell.controller.time()).hasMillis(48);
  }

  @Test
  void theStateHasTheLineOfTheUsersModule() throws Exception {
    try (Cell cell = new Cell()) {
      cell.controller.load("sub.src", "DEF SUB()\n\n\nMSGQUIT(\"in the routine\")\nEND\n");
      cell.start(";\nMSGQUIT(\"wait\")\nSUB()");
      cell.until(() -> cell.get("$STOPMESS").equals("TRUE"));
      cell.cycles(3);
      assertThat(cell.controller.robot()).hasToString("TEST #P_ACTIVE line 3");

      cell.controller.confirmAll();
      cell.until(() -> cell.get("$STOPMESS").equals("TRUE"));
      cell.cycles(3);
      assertThat(cell.controller.robot()).hasToString("TEST #P_ACTIVE line 4 of SUB");
    }
  }
}
