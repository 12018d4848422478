package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Optional;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.KrlStruct;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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

  // machine data in data lists

  private static final String MACHINE =
      """
      DEFDAT $MACHINE PUBLIC
      CHAR $TRAFONAME[32]
      $TRAFONAME[]="#KR210R2700_2 C4 FLR"
      DECL FRAME $TIRORO={X 0.0,Y 0.0,Z 645.0,A 0.0,B 0.0,C 0.0}
      REAL $LENGTH_A=330.0
      REAL $LENGTH_B=1150.0
      DECL FRAME $TX3P3={X 1220.0,Y 0.0,Z 115.0,A 0.0,B 90.0,C 0.0}
      DECL FRAME $TFLWP={X 0.0,Y 0.0,Z 215.0,A 0.0,B 0.0,C 0.0}
      REAL $SOFTN_END[12]
      $SOFTN_END[1]=-185.0
      $SOFTN_END[2]=-140.0
      $SOFTN_END[3]=-120.0
      $SOFTN_END[4]=-350.0
      $SOFTN_END[5]=-125.0
      $SOFTN_END[6]=-350.0
      REAL $SOFTP_END[12]
      $SOFTP_END[1]=185.0
      $SOFTP_END[2]=-5.0
      $SOFTP_END[3]=168.0
      $SOFTP_END[4]=350.0
      $SOFTP_END[5]=125.0
      $SOFTP_END[6]=350.0
      REAL $VEL_AXIS_MA[12]=5000.0
      DECL FRA $RAT_MOT_AX[12]={N 300,D 1}
      $RAT_MOT_AX[1]={N -1798,D 7}
      DECL E6AXIS $AXIS_HOME[5]
      $AXIS_HOME[1]={A1 10.0,A2 -100.0,A3 110.0,A4 0.0,A5 30.0,A6 0.0}
      ENDDAT
      """;

  private static final String CONFIG =
      """
      DEFDAT $CONFIG PUBLIC
      DECL E6AXIS XHOME={A1 20.0,A2 -80.0,A3 80.0,A4 0.0,A5 40.0,A6 0.0,E1 0.0}
      ENDDAT
      """;

  private static final Axis AXIS_HOME = Axis.of(10, -100, 110, 0, 30, 0);
  private static final Axis XHOME = Axis.of(20, -80, 80, 0, 40, 0);

  @Test
  void theRobotOfLoadedMachineDataReplacesTheDefault() throws Exception {
    try (Cell cell = new Cell(Cell.stepped(VariableTable.krc4()))) {
      cell.controller.load("$machine.dat", MACHINE);

      assertThat(cell.controller.model().name()).isEqualTo("#KR210R2700_2 C4 FLR");
      assertThat(cell.get("$MODEL_NAME[]")).isEqualTo("\"#KR210R2700_2 C4 FLR\"");
      assertThat(cell.controller.model().maxSpeed(0)).isEqualTo(116.796, within(0.001));
      assertThat(cell.controller.axes()).isEqualTo(AXIS_HOME);
      assertThat(cell.component("$POS_ACT", "X"))
          .isEqualTo(KR210.forward(AXIS_HOME).x(), within(0.001));
      cell.run("PTP {A1 180}");
      assertThat(cell.get("$AXIS_ACT.A1")).isEqualTo("180.000");
      assertThat(cell.controller.messages()).isEmpty();
    }
  }

  @Test
  void theRobotStartsAtXhomeWhateverIsLoadedFirst() throws Exception {
    try (Controller one = Cell.stepped(VariableTable.krc4());
        Controller other = Cell.stepped(VariableTable.krc4())) {
      one.load("$config.dat", CONFIG);
      one.load("$machine.dat", MACHINE);
      other.load("$machine.dat", MACHINE);
      other.load("$config.dat", CONFIG);

      assertThat(one.axes()).isEqualTo(XHOME);
      assertThat(other.axes()).isEqualTo(XHOME);
    }
  }

  @Test
  void machineDataInTheTableCountMoreThanTheModel() throws Exception {
    VariableTable table = VariableTable.krc4();
    table.load("$machine.dat", MACHINE);
    table.load("$config.dat", CONFIG);
    try (Controller controller = Cell.stepped(table.copy())) {
      assertThat(controller.model().name()).isEqualTo("#KR210R2700_2 C4 FLR");
      assertThat(controller.axes()).isEqualTo(XHOME);
    }
  }

  @Test
  void aSavedStateHasTheRobotAndItsPosition() throws Exception {
    String state;
    try (Cell cell = new Cell(Cell.stepped(VariableTable.krc4()))) {
      cell.controller.load("$machine.dat", MACHINE);
      cell.run("PTP {A1 180,A2 -70}");
      state = cell.controller.variables().toDataList("$STATE");
    }
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      controller.load("$state.dat", state);
      assertThat(controller.model().maxSpeed(0)).isEqualTo(116.796, within(0.001));
    }
    VariableTable table = VariableTable.krc4();
    table.load("$state.dat", state);
    try (Controller controller = Cell.stepped(table)) {
      assertThat(controller.axes()).isEqualTo(AXIS_HOME.with(0, 180).with(1, -70));
    }
  }

  @Test
  void aRobotThatHasMovedStaysWhereItIs() throws Exception {
    try (Cell cell = new Cell()) {
      cell.controller.load("$machine.dat", MACHINE);
      cell.controller.load("$config.dat", CONFIG);

      assertThat(cell.controller.axes()).isEqualTo(Cell.START);
      assertThat(cell.controller.model().maximum(0)).isEqualTo(185);
    }
  }

  @Test
  void anArmOfAnotherKindLeavesTheRobotAndAMessage() throws Exception {
    try (Cell cell = new Cell()) {
      cell.controller.load(
          "$machine.dat",
          MACHINE.replace(
              "ENDDAT", "DECL DHART $DH_5={DHART_A 265.0,DHART_D 0.0,DHART_ALPHA -90.0}\nENDDAT"));

      assertThat(cell.message())
          .isEqualTo(
              "9108 the robot stays a KR 6 R900 sixx, its new data are not used:"
                  + " $DH_5.DHART_A: expected 0, found 265");
      assertThat(cell.controller.model().maxSpeed(0)).isEqualTo(360);
      cell.start("PTP {A1 10}");
    }
  }

  /** The machine data of a gantry, with a root, external axes and limits in mm. */
  private static final String GANTRY =
      MACHINE
          .replace(
              "ENDDAT",
              """
              DECL MAIN_AXIS $MAIN_AXIS=#SS
              FRAME $ROBROOT={X 0.0,Y 0.0,Z 500.0,A 0.0,B 0.0,C 0.0}
              FRAME $ERSYSROOT={X 100.0,Y 0.0,Z 500.0,A 0.0,B 0.0,C 0.0}
              INT $EX_AX_NUM=1
              DECL CP $VEL_MA={CP 9.0,ORI1 400.0,ORI2 400.0}
              $AXIS_TYPE[7]=1
              INT $RAISE_TIME[12]=77
              DECL EX_KIN $EX_KIN={ET1 #ERSYS,ET2 #NONE,ET3 #NONE,ET4 #NONE,ET5 #NONE,ET6 #NONE}
              SIGNAL $MOVE_ENABLE $IN[1025]
              ENDDAT\
              """)
          .replace("$SOFTN_END[2]=-140.0", "$SOFTN_END[2]=0.0")
          .replace("$SOFTP_END[2]=-5.0", "$SOFTP_END[2]=4000.0");

  private static final String FAR_HOME =
      "DEFDAT $CONFIG PUBLIC\nDECL E6AXIS XHOME={A1 500.0,A2 1000.0,A3 200.0}\nENDDAT\n";

  /** Checks that a robot stands where it did, and has the variables of a new table. */
  private static void assertIsTheDefault(Controller controller) {
    VariableTable table = VariableTable.krc4();
    for (String name :
        new String[] {
          "$TRAFONAME[]",
          "$MODEL_NAME[]",
          "$SOFTN_END[]",
          "$SOFTP_END[]",
          "$MAIN_AXIS",
          "$VEL_AXIS_MA[]",
          "$RAT_MOT_AX[1].D",
          "$VEL_MA",
          "$LENGTH_A",
          "$TX3P3",
          "$ROBROOT",
          "$ROBROOT_C",
          "$EX_AX_NUM",
          "$AXIS_HOME[1]",
          "XHOME"
        }) {
      assertThat(controller.variables().get(name)).as(name).isEqualTo(table.get(name));
    }
    assertThat(controller.variables().names()).doesNotContain("$RAISE_TIME");
    assertThat(controller.axes()).isEqualTo(RobotModel.kr6r900sixx().home());
    assertThat(controller.model().maximum(1)).isEqualTo(45);
  }

  @Test
  void aRobotThatStaysKeepsAllOfItsMachineData() throws Exception {
    try (Cell cell = new Cell(Cell.stepped(VariableTable.krc4()))) {
      LoadReport report = cell.controller.load("$machine.dat", GANTRY, LoadingMode.LENIENT);

      assertIsTheDefault(cell.controller);
      assertThat(report.problems())
          .extracting(KrlError::toString)
          .containsExactly(
              "$machine.dat:"
                  + line(GANTRY, "$MAIN_AXIS")
                  + ":1: the robot stays a KR 6 R900 sixx, its new data are not used: $MAIN_AXIS:"
                  + " expected #NR, found #SS");
      cell.start("PTP {A1 10,A2 -80}");
      assertThat(
              cell.controller.stepUntil(
                  () -> cell.get("$AXIS_ACT.A2").equals("-80.0000"), Duration.ofSeconds(10)))
          .isTrue();
    }
  }

  private static int line(String text, String part) {
    return (int) text.substring(0, text.indexOf(part)).lines().count();
  }

  @Test
  void aHomeOfAnotherRobotIsNotUsed() throws Exception {
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      controller.load("$config.dat", FAR_HOME, LoadingMode.LENIENT);
      LoadReport report = controller.load("$machine.dat", GANTRY, LoadingMode.LENIENT);

      assertIsTheDefault(controller);
      assertThat(report.problems())
          .extracting(KrlError::message)
          .contains("XHOME is not used: it is outside the limits of the KR 6 R900 sixx");
    }
    VariableTable table = VariableTable.krc4();
    table.load("$machine.dat", GANTRY);
    table.load("$config.dat", FAR_HOME);
    try (Controller controller = Cell.stepped(table.copy())) {
      assertIsTheDefault(controller);
    }
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      controller.load("$machine.dat", GANTRY, LoadingMode.LENIENT);
      LoadReport report = controller.load("$config.dat", FAR_HOME, LoadingMode.LENIENT);
      assertIsTheDefault(controller);
      assertThat(report.problems())
          .extracting(KrlError::toString)
          .containsExactly(
              "$config.dat:2:1: XHOME is not used: it is outside the limits of the KR 6 R900"
                  + " sixx");
    }
  }

  @Test
  void aHomeWithinTheLimitsIsUsedByTheRobotThatStays() throws Exception {
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      controller.load("$config.dat", CONFIG);
      controller.load("$machine.dat", GANTRY);

      assertThat(controller.axes()).isEqualTo(XHOME);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "$SOFTN_END[2]=-140.0 | $SOFTN_END[2]=-1.0 | $SOFTN_END[2]: expected less than",
        "{N -1798,D 7} | {N -1798,D 0} | $RAT_MOT_AX[1].D: expected a number other than 0",
        "D 1} | D 0} | $RAT_MOT_AX[2].D: expected a number other than 0"
      })
  void aWrongValueIsReportedAtItsPlace(String right, String wrong, String reason) {
    String text = MACHINE.replace(right, wrong);
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      LoadReport report = controller.load("$machine.dat", text, LoadingMode.LENIENT);

      assertThat(report.problems()).hasSize(1);
      KrlError problem = report.problems().get(0);
      assertThat(problem.message()).contains("are not used: " + reason);
      assertThat(text.lines().toList().get(problem.position().line() - 1)).contains(wrong);
      assertIsTheDefault(controller);
    }
  }

  @Test
  void theMachineDataOfTheControllerAreNotThoseOfARobot() throws Exception {
    try (Controller controller = Cell.stepped(VariableTable.krc4())) {
      controller.load("$machine.dat", "DEFDAT $MACHINE PUBLIC\nINT $RED_T1=9\nENDDAT\n");

      assertThat(controller.model().maxSpeed(3)).isEqualTo(381);
    }
  }
}
