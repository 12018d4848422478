package no.hials.crosscom.kinematics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

final class MachineDataTest {
  /** Speeds in machine data are exact, and rounded to 0.1 or 1 degrees/s in the table. */
  private static final double ROUNDED = 0.6;

  /** The machine data of both robots, as far as they are the same. */
  private static Map<String, KrlValue> arm(String trafoName) {
    Map<String, KrlValue> data = new HashMap<>();
    put(data, "$TRAFONAME[]", "\"" + trafoName + "\"");
    array(data, "$AXIS_DIR", "-1 1 1 -1 -1 -1");
    put(data, "$NUM_AX", "6");
    put(data, "$MAIN_AXIS", "#NR");
    put(data, "$WRIST_AXIS", "#ZEH");
    put(data, "$DH_4", "{DHART: DHART_A 0.0,DHART_D 0.0,DHART_ALPHA 90.0}");
    put(data, "$DH_5", "{DHART: DHART_A 0.0,DHART_D 0.0,DHART_ALPHA -90.0}");
    array(data, "$AXIS_TYPE", "3 3 3 3 3 3");
    return data;
  }

  private static Map<String, KrlValue> kr6() {
    Map<String, KrlValue> data = arm("#KR6R900 C4SR FLR 230");
    put(data, "$TIRORO", "{X 0.0,Y 0.0,Z 400.0,A 0.0,B 0.0,C 0.0}");
    put(data, "$LENGTH_A", "25.0");
    put(data, "$LENGTH_B", "455.0");
    put(data, "$TX3P3", "{X 420.0,Y 0.0,Z 35.0,A 0.0,B 90.0,C 0.0}");
    put(data, "$TFLWP", "{X 0.0,Y 0.0,Z 80.0,A 0.0,B 0.0,C 0.0}");
    array(data, "$SOFTN_END", "-170.0 -190.0 -120.0 -185.0 -120.0 -350.0");
    array(data, "$SOFTP_END", "170.0 45.0 156.0 185.0 120.0 350.0");
    array(data, "$VEL_AXIS_MA", "6000.0 6000.0 6000.0 6000.0 6000.0 6000.0");
    ratios(data, "-100/1 -120/1 -100/1 850/9 66096/713 520960/8901");
    return data;
  }

  private static Map<String, KrlValue> kr210() {
    Map<String, KrlValue> data = arm("#KR210R2700_2 C4 FLR");
    put(data, "$TIRORO", "{X 0.0,Y 0.0,Z 645.0,A 0.0,B 0.0,C 0.0}");
    put(data, "$LENGTH_A", "330.0");
    put(data, "$LENGTH_B", "1150.0");
    put(data, "$TX3P3", "{X 1220.0,Y 0.0,Z 115.0,A 0.0,B 90.0,C 0.0}");
    put(data, "$TFLWP", "{X 0.0,Y 0.0,Z 215.0,A 0.0,B 0.0,C 0.0}");
    array(data, "$SOFTN_END", "-185.0 -140.0 -120.0 -350.0 -125.0 -350.0");
    array(data, "$SOFTP_END", "185.0 -5.0 168.0 350.0 125.0 350.0");
    array(data, "$VEL_AXIS_MA", "5000.0 5570.0 5600.0 5370.0 4300.0 5500.0");
    // A1 is that of a real robot; the others have the speeds of the table
    ratios(data, "-1798/7 300/1 300/1 -180/1 -150/1 150/1");
    return data;
  }

  private static void put(Map<String, KrlValue> data, String name, String value) {
    data.put(name, KrlValue.parse(value));
  }

  private static void array(Map<String, KrlValue> data, String name, String values) {
    String[] six = values.split(" ", -1);
    for (int i = 0; i < six.length; i++) {
      put(data, name + "[" + (i + 1) + "]", six[i]);
    }
  }

  private static void ratios(Map<String, KrlValue> data, String ratios) {
    String[] six = ratios.split(" ", -1);
    for (int i = 0; i < six.length; i++) {
      put(data, "$RAT_MOT_AX[" + (i + 1) + "]", "{N " + six[i].replace("/", ",D ") + "}");
    }
  }

  private static RobotModel model(Map<String, KrlValue> data) throws MachineDataException {
    return RobotModel.fromMachineData(name -> Optional.ofNullable(data.get(name)));
  }

  @Test
  void machineDataOfAKr6R900AreTheKr6R900() throws Exception {
    assertSame(model(kr6()), RobotModel.kr6r900sixx(), "#KR6R900 C4SR FLR 230");
  }

  @Test
  void machineDataOfAKr210AreTheOneOfTheTable() throws Exception {
    assertSame(model(kr210()), RobotModel.named("KR 210 R2700-2"), "#KR210R2700_2 C4 FLR");
  }

  private static void assertSame(RobotModel found, RobotModel table, String name) {
    assertThat(found.name()).isEqualTo(name);
    for (Axis axes :
        new Axis[] {
          Axis.of(0, -90, 0, 0, 0, 0),
          Axis.of(30, -80, 100, 10, 60, -20),
          Axis.of(-20, -60, 70, -35, 40, 100)
        }) {
      assertThat(found.forward(axes)).isEqualTo(table.forward(axes));
      assertThat(found.status(axes)).isEqualTo(table.status(axes));
    }
    assertThat(found.home()).isEqualTo(table.home());
    for (int axis = 0; axis < Axis.COUNT; axis++) {
      assertThat(found.minimum(axis)).isEqualTo(table.minimum(axis));
      assertThat(found.maximum(axis)).isEqualTo(table.maximum(axis));
      assertThat(found.maxSpeed(axis)).isEqualTo(table.maxSpeed(axis), within(ROUNDED));
    }
  }

  @ParameterizedTest
  @MethodSource("names")
  void machineDataCreateTheSameRobotAgain(String name) throws Exception {
    RobotModel robot = RobotModel.named(name);
    Map<String, KrlValue> data = arm("replaced");
    data.putAll(robot.machineData());

    RobotModel again = model(data);

    assertSame(again, robot, data.get("$TRAFONAME[]").asString());
    for (int axis = 0; axis < Axis.COUNT; axis++) {
      assertThat(again.maxSpeed(axis)).isEqualTo(robot.maxSpeed(axis), within(1e-3));
    }
  }

  static List<String> names() {
    return RobotModel.names();
  }

  @Test
  void theNameInMachineDataIsThatOfTheRealArmWhereItIsKnown() {
    assertThat(List.of("KR 6 R900 sixx", "KR 210 R2700-2"))
        .extracting(name -> RobotModel.named(name).machineData().get("$TRAFONAME[]").asString())
        .containsExactly("#KR6R900 C4SR FLR 230", "#KR210R2700_2 C4 FLR");
  }

  @Test
  void aRobotWithOtherOffsetsHasMachineDataWithoutLengths() {
    assertThat(Robots.INVENTED.machineData())
        .containsEntry("$TRAFONAME[]", KrlValue.parse("\"#INVENTEDR700 C4 FLR\""))
        .containsKeys("$SOFTN_END[1]", "$RAT_MOT_AX[6]")
        .doesNotContainKeys("$LENGTH_A", "$AXIS_DIR[1]");
  }

  @Test
  void theOffsetOfTheForearmOfAKr210PrimeIsForward() throws Exception {
    Map<String, KrlValue> data = kr210();
    put(data, "$TX3P3", "{X 1220.0,Y 0.0,Z -41.0,A 0.0,B 90.0,C 0.0}");

    assertThat(model(data).forward(Axis.of(0, -90, 0, 0, 0, 0)).x())
        .isEqualTo(330 + 41, within(1e-9));
  }

  @Test
  void theSpeedIsRpmTimesSixByTheRatio() throws Exception {
    assertThat(model(kr6()).maxSpeed(0)).isEqualTo(360);
    assertThat(model(kr6()).maxSpeed(3)).isEqualTo(6000 * 6 * 9 / 850.0);
    assertThat(model(kr210()).maxSpeed(0)).isEqualTo(116.8, within(0.01));
  }

  @Test
  void theAccelerationIsAssumedUnlessTheRaiseTimeIsThere() throws Exception {
    Map<String, KrlValue> data = kr6();
    put(data, "$RAISE_TIME[2]", "250.0");
    RobotModel robot = model(data);

    assertThat(robot.maxAcceleration(0)).isEqualTo(360 / 0.3);
    assertThat(robot.maxAcceleration(1)).isEqualTo(300 / 0.25);
  }

  @Test
  void theDirectionsOfTheAxesAreThoseOfTheMachineData() throws Exception {
    Map<String, KrlValue> data = kr6();
    array(data, "$AXIS_DIR", "1 -1 1 1 1 1");
    Axis axes = Axis.of(30, 20, 100, 10, 60, -20);
    // A2 counts from -90
    Axis mirrored = Axis.of(-30, -200, 100, -10, -60, 20);

    assertThat(model(data).forward(axes).distance(RobotModel.kr6r900sixx().forward(mirrored)))
        .isLessThan(1e-9);
  }

  @Test
  void theHomePositionIsXhomeElseTheFirstFurtherOneElseAssumed() throws Exception {
    Map<String, KrlValue> data = kr6();
    put(data, "$AXIS_HOME[1]", "{A1 1.0,A2 -91.0,A3 91.0,A4 0.0,A5 10.0,A6 0.0,E1 0.0}");
    assertThat(model(data).home()).isEqualTo(Axis.of(1, -91, 91, 0, 10, 0));

    put(data, "XHOME", "{E6AXIS: A1 2.0,A2 -92.0,A3 92.0,A4 0.0,A5 20.0,A6 0.0}");
    assertThat(model(data).home()).isEqualTo(Axis.of(2, -92, 92, 0, 20, 0));

    put(data, "XHOME", "{E6AXIS: A1 2.0,A2 46.0,A3 92.0,A4 0.0,A5 20.0,A6 0.0}");
    assertThat(model(data).home()).isEqualTo(Axis.of(1, -91, 91, 0, 10, 0));

    put(data, "$SOFTN_END[3]", "100.0");
    data.remove("XHOME");
    assertThat(model(data).home()).isEqualTo(Axis.of(0, -90, 100, 0, 0, 0));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "$MAIN_AXIS; #SS; $MAIN_AXIS: expected #NR, found #SS",
        "$WRIST_AXIS; #NOH; $WRIST_AXIS: expected #ZEH, found #NOH",
        "$NUM_AX; 4; $NUM_AX: expected 6, found 4",
        "$DH_5; '{DHART_A 265.0,DHART_D 0.0,DHART_ALPHA -90.0}';"
            + " $DH_5.DHART_A: expected 0, found 265",
        "$DH_4; '{DHART_A 0.0,DHART_D 0.0,DHART_ALPHA 0.0}';"
            + " $DH_4.DHART_ALPHA: expected 90, found 0",
        "$AXIS_TYPE[3]; 1; $AXIS_TYPE[3]: expected 3 or 5 (rotary), found 1",
        "$AXIS_DIR[5]; 0; $AXIS_DIR[5]: expected 1 or -1, found 0",
        "$TX3P3; '{X 420.0,Y 0.0,Z 35.0,A 0.0,B 0.0,C 0.0}'; $TX3P3.B: expected 90, found 0",
        "$TIRORO; '{X 10.0,Y 0.0,Z 400.0,A 0.0,B 0.0,C 0.0}'; $TIRORO.X: expected 0, found 10",
        "$TFLWP; '{X 0.0}'; $TFLWP.Y: expected a number, found none",
        "$LENGTH_B; 0.0; $LENGTH_B: expected a number above 0, found 0",
        "$LENGTH_A; #NONE; $LENGTH_A: expected a number, found #NONE",
        "$LENGTH_A; ; $LENGTH_A: expected a value, found none",
        "$TRAFONAME[]; '\" \"'; $TRAFONAME[]: expected a name, found \" \"",
        "$VEL_AXIS_MA[2]; 0.0;"
            + " $VEL_AXIS_MA[2] * 6 / $RAT_MOT_AX[2]: expected a number above 0, found 0",
        "$SOFTN_END[1]; 170.0; $SOFTN_END[1]: expected less than $SOFTP_END[1], 170.0, found 170.0"
      })
  void refusesAnotherKindOfArmAndNamesTheReason(String name, String value, String message) {
    Map<String, KrlValue> data = kr6();
    if (value == null) {
      data.remove(name);
    } else {
      put(data, name, value);
    }

    assertThatExceptionOfType(MachineDataException.class)
        .isThrownBy(() -> model(data))
        .withMessage(message);
  }
}
