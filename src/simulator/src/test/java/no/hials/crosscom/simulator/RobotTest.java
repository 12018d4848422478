package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;

/** The robot that the controller moves. */
final class RobotTest {
  private static final RobotModel KR210 = RobotModel.named("KR 210 R2700-2");

  @Test
  void theTableOfAnotherRobotHasItsMachineData() throws Exception {
    VariableTable table = VariableTable.krc4(KR210);

    assertThat(table.get("$TRAFONAME[]")).isEqualTo("\"#KR210R2700_2 C4 FLR\"");
    assertThat(table.get("$MODEL_NAME[]")).isEqualTo("\"#KR210R2700_2 C4 FLR\"");
    assertThat(table.get("$SOFTP_END[]"))
        .isEqualTo("185.000 -5.00000 168.000 350.000 125.000 350.000 0.0 0.0 0.0 0.0 0.0 0.0 ");
    assertThat(table.get("$LENGTH_B")).isEqualTo("1150.00");
    assertThat(table.get("$TX3P3.Z")).isEqualTo("115.000");
    assertThat(table.get("$AXIS_DIR[5]")).isEqualTo("-1");
    // the wrist centre is c2 + a2 up, and c3 forward
    assertThat(table.get("$POS_ACT.X")).isEqualTo("1765.00");
    assertThat(table.get("$POS_ACT.Z")).isEqualTo("1910.00");
    assertThat(table.get("$POS_FOR.T")).isEqualTo("2");
    RobotModel again = RobotModel.fromMachineData(name -> value(table, name));
    assertThat(again.forward(Axis.of(1, -80, 85, 4, 5, 6)))
        .isEqualTo(KR210.forward(Axis.of(1, -80, 85, 4, 5, 6)));
  }

  private static Optional<KrlValue> value(VariableTable table, String name) {
    try {
      return Optional.of(table.readValue(name));
    } catch (RefusedException e) {
      return Optional.empty();
    }
  }

  @Test
  void theTableOfTheDefaultRobotKeepsTheMachineDataOfTheRealOne() {
    assertThat(VariableTable.krc4(RobotModel.kr6r900sixx()).toDataList("A"))
        .isEqualTo(VariableTable.krc4().toDataList("A"));
  }

  @Test
  void theProgramMovesTheRobotOfTheTable() throws Exception {
    try (Controller controller =
        new Controller(
            VariableTable.krc4(KR210), SimulationClock.stepped(), KR210, "simulator-test-clock")) {
      Cell cell = new Cell(controller);
      assertThat(controller.axes()).isEqualTo(KR210.home());
      cell.run("PTP {A1 180,A2 -100,A3 160,A4 0,A5 45,A6 0}\nLIN_REL {Z 100}");

      assertThat(controller.axes().a1()).isEqualTo(180, within(1e-6));
      KrlStruct position = (KrlStruct) controller.variables().value("$POS_ACT");
      double z = KR210.forward(Axis.of(180, -100, 160, 0, 45, 0)).z() + 100;
      assertThat(position.get("Z").orElseThrow().asDouble()).isEqualTo(z, within(0.01));
    }
  }

  @Test
  void anAxisOfAnotherRobotIsAsFastAsItsTable() throws Exception {
    try (Controller controller =
        new Controller(
            VariableTable.krc4(KR210), SimulationClock.stepped(), KR210, "simulator-test-clock")) {
      Cell cell = new Cell(controller);
      cell.start("PTP {A1 100}");
      cell.cycles(60);
      double before = controller.axes().a1();
      cell.cycles(10);

      assertThat(controller.axes().a1() - before).isEqualTo(116.8 * 0.12, within(0.001));
    }
  }
}
