package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.value.Axis;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Turns the key switch, presses the emergency stop and confirms messages. */
class ControllerModesTest {
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

  @Test
  void isInT1AtFirst() throws IOException {
    try (Controller other = Cell.stepped(VariableTable.krc4())) {
      assertThat(other.mode()).isEqualTo(OperatingMode.T1);
      assertThat(other.variables().get("$MODE_OP")).isEqualTo("#T1");
      assertThat(other.variables().get("$PERI_RDY")).isEqualTo("FALSE");
      assertThat(other.variables().get("$BRAKE_SIG")).isEqualTo("0");
    }
  }

  @ParameterizedTest
  @CsvSource({"T1,#T1,$T1", "T2,#T2,$T2", "AUT,#AUT,$AUT", "EXT,#EX,$EXT"})
  void showsTheMode(OperatingMode mode, String constant, String signal) {
    controller.setMode(mode);
    assertThat(cell.get("$MODE_OP")).isEqualTo(constant);
    for (String other : new String[] {"$T1", "$T2", "$AUT", "$EXT"}) {
      assertThat(cell.get(other)).isEqualTo(other.equals(signal) ? "TRUE" : "FALSE");
    }
  }

  @ParameterizedTest
  @EnumSource(names = "EXT", mode = EnumSource.Mode.EXCLUDE)
  void startsAtThePendantInEveryModeButExt(OperatingMode mode) throws Exception {
    controller.setMode(mode);
    cell.load(Cell.module("TEST", "MYINT=1"));
    controller.robot().select("TEST");
    assertThatThrownBy(controller::externalStart)
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("start: the external start works in EXT only, the mode is " + mode);
    controller.robot().start();
    cell.runToTheEnd();
  }

  @Test
  void startsFromOutsideInExt() throws Exception {
    controller.setMode(OperatingMode.EXT);
    cell.load(Cell.module("TEST", "MYINT=1"));
    assertThatThrownBy(controller::externalStart).hasMessage("start: no program is selected");
    controller.robot().select("TEST");
    assertThatThrownBy(() -> controller.robot().start())
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("start: in EXT only the external start works");
    controller.externalStart();
    cell.runToTheEnd();
  }

  @Test
  void aChangeOfTheModeStopsTheRobotOnItsPath() throws Exception {
    cell.start("PTP {A1 90}");
    cell.cycles(20);
    assertThat(controller.standing()).isFalse();
    controller.setMode(OperatingMode.AUT); // no change
    assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);

    controller.setMode(OperatingMode.T1);

    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    assertThat(cell.message()).startsWith("1362").contains("from AUT to T1");
    cell.untilStanding();
    assertThat(controller.axes().get(0)).isBetween(1.0, 89.0);
    controller.robot().start(); // a notification needs no confirmation
    cell.until(() -> controller.robot().state() == ProgramState.END);
    assertThat(controller.axes().get(0)).isEqualTo(90);
  }

  private double fastest(String variable, String body) throws KrlFileException {
    cell.start(body);
    double[] most = {0};
    cell.until(
        () -> {
          most[0] = Math.max(most[0], Math.abs(cell.real(variable)));
          return controller.robot().state() != ProgramState.ACTIVE;
        });
    assertThat(controller.messages()).isEmpty();
    return most[0];
  }

  @Test
  void movesAxesAtRedT1InT1() throws Exception {
    controller.setMode(OperatingMode.T1);
    assertThat(fastest("$VEL_AXIS_ACT[6]", "PTP {A6 350}")).isEqualTo(7, within(0.1));
  }

  @Test
  void speedsUpInT1AsFastAsInOtherModes() throws Exception {
    controller.setMode(OperatingMode.T1);
    cell.start("PTP {A6 350}");
    cell.cycles(5); // the full speed takes 0.3 s, 7 % of it 0.021 s
    assertThat(cell.real("$VEL_AXIS_ACT[6]")).isEqualTo(7, within(0.01));
  }

  @Test
  void movesTheToolInT1AtTheOverride() throws Exception {
    controller.setMode(OperatingMode.T1);
    cell.set("$OV_PRO", "10");
    assertThat(fastest("$VEL_ACT", "LIN_REL {Z 30}")).isEqualTo(0.01, within(1e-4));
  }

  @Test
  void staysSlowIfAMotionOfAnotherModeGoesOnInT1() throws Exception {
    cell.start("PTP {A6 350}");
    cell.cycles(20);
    controller.setMode(OperatingMode.T1);
    cell.cycles(50);
    controller.robot().start();
    cell.cycles(40);
    assertThat(cell.real("$VEL_AXIS_ACT[6]")).isEqualTo(7, within(0.01));
  }

  @Test
  void keepsTheToolBelowTheTeachLimitInT1() throws Exception {
    controller.place(Axis.of(0, -10, 10, 0, 45, 0));
    controller.setMode(OperatingMode.T1);
    // 7 % of 360 degrees/s would be about 0.4 m/s at this reach
    assertThat(fastest("$VEL_ACT", "PTP {A1 60}")).isBetween(0.21, 0.2205);
  }

  @Test
  void movesTheToolAtVelCpT1InT1() throws Exception {
    controller.setMode(OperatingMode.T1);
    assertThat(fastest("$VEL_ACT", "LIN_REL {Z 60}")).isEqualTo(0.1, within(0.001));
  }

  @Test
  void movesAtProgrammedSpeedInT2() throws Exception {
    controller.setMode(OperatingMode.T2);
    cell.set("$OV_PRO", "100");
    assertThat(fastest("$VEL_AXIS_ACT[1]", "PTP {A1 120}")).isEqualTo(100, within(0.5));
  }

  @Test
  void reducesTheOverrideOnEntryToT2() {
    controller.setMode(OperatingMode.T2);
    assertThat(cell.get("$OV_PRO")).isEqualTo("10");
    cell.set("$OV_PRO", "5");
    controller.setMode(OperatingMode.AUT);
    controller.setMode(OperatingMode.T2);
    assertThat(cell.get("$OV_PRO")).isEqualTo("5");
    cell.set("$OV_PRO", "80");
    controller.setMode(OperatingMode.T2); // no entry
    assertThat(cell.get("$OV_PRO")).isEqualTo("80");
    cell.set("$T2_OV_REDUCE", "FALSE");
    controller.setMode(OperatingMode.AUT);
    controller.setMode(OperatingMode.T2);
    assertThat(cell.get("$OV_PRO")).isEqualTo("80");
  }

  @Test
  void theEmergencyStopStopsAndHasToBeReleasedAndConfirmed() throws Exception {
    cell.start("PTP {A1 90}");
    cell.cycles(20);
    controller.emergencyStop(true);
    controller.emergencyStop(true); // pressed already

    assertThat(controller.messages())
        .extracting(Message::toString)
        .containsExactly("1200 emergency stop", "1 the emergency stop is pressed");
    assertThat(cell.get("$ALARM_STOP")).isEqualTo("FALSE");
    assertThat(cell.get("$PERI_RDY")).isEqualTo("FALSE");
    assertThat(cell.get("$STOPMESS")).isEqualTo("TRUE");
    assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    cell.untilStanding();
    assertThat(controller.axes().get(0)).isBetween(1.0, 89.0);
    assertThatThrownBy(() -> controller.robot().start())
        .hasMessage("start: the emergency stop is pressed");

    controller.emergencyStop(false);
    assertThat(cell.message()).isEqualTo("1200 emergency stop");
    assertThat(cell.get("$ALARM_STOP")).isEqualTo("TRUE");
    assertThatThrownBy(() -> controller.robot().start())
        .hasMessage("start: a message has to be confirmed first");

    assertThat(controller.confirmAll()).isEqualTo(1);
    controller.robot().start();
    cell.until(() -> controller.robot().state() == ProgramState.END);
    assertThat(controller.axes().get(0)).isEqualTo(90);
  }

  @Test
  void theInterruptOfIniDoesNotDisturbTheProgram() throws Exception {
    cell.start(
        """
        GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )
        INTERRUPT ON 3
        BAS (#INITMOV,0)
        MYREAL=1.0/MYINT
        MYBOOL=TRUE\
        """);
    cell.cycles(2);
    assertThat(controller.robot().line()).isEqualTo(5);
    controller.confirmAll();
    cell.set("MYINT", "1");
    controller.robot().start();
    cell.cycles(2);
    assertThat(controller.robot().state()).isEqualTo(ProgramState.END);
  }

  @Test
  void keepsTheLastThousandMessages() {
    for (int i = 0; i < 1001; i++) {
      controller.emergencyStop(true);
      controller.emergencyStop(false);
    }
    assertThat(controller.messages()).hasSize(1000);
    assertThat(controller.confirmAll()).isEqualTo(1001);
  }

  @Test
  void showsDrivesAndBrakes() throws Exception {
    assertThat(cell.get("$PERI_RDY")).isEqualTo("TRUE");
    controller.setMode(OperatingMode.T1);
    assertThat(cell.get("$PERI_RDY")).isEqualTo("FALSE");
    assertThat(cell.get("$BRAKE_SIG")).isEqualTo("0");
    cell.start("WAIT FOR FALSE");
    assertThat(cell.get("$PERI_RDY")).isEqualTo("TRUE");
    assertThat(cell.get("$BRAKE_SIG")).isEqualTo("63");
  }
}
