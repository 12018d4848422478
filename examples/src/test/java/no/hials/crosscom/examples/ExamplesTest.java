package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import no.hials.crosscom.mock.MockServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Runs every example as a user would. */
class ExamplesTest {
  private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
  private final PrintStream original = System.out;

  @BeforeEach
  void capture() {
    System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
  }

  @AfterEach
  void restore() {
    System.setOut(original);
  }

  private String output() {
    return printed.toString(StandardCharsets.UTF_8);
  }

  @Test
  void quickstartPrintsTheHomePosition() throws Exception {
    Quickstart.main(new String[0]);

    assertThat(output()).startsWith("X 525.0 mm, Z 890.0 mm").contains("all: {X=525.0, Y=0.0");
  }

  @Test
  void readVariablesPrintsAValueOfEveryType() throws Exception {
    ReadVariables.main(new String[0]);

    assertThat(output())
        .contains("program override: 100 %")
        .contains("operating mode: #T1")
        .contains("input 1025: true")
        .contains("model: #KR6R900 C4SR FLR 230")
        .contains("A1 to A6: [0.0, -90.0, 90.0, 0.0, 0.0, 0.0]")
        .contains("torques: [0.0, 0.0")
        .contains("load: {LOAD: M 2.50000, CM {FRAME: X 0.0");
  }

  @Test
  void writeVariablesPrintsWhatTheControllerHoldsAfterwards() throws Exception {
    WriteVariables.main(new String[0]);

    assertThat(output())
        .contains("$OV_PRO = 50")
        .contains("MYSTRING[] = \"weld 12, left\"")
        .contains("MYPOS = {E6POS: X 2.00000, Y 1.00000, Z 30.5000");
  }

  @Test
  void anExampleUsesTheControllerNamedOnItsCommandLine() throws Exception {
    try (MockServer robot = MockServer.start()) {
      robot.variables().set("$OV_PRO", "42");

      ReadVariables.main(new String[] {robot.host(), String.valueOf(robot.port())});
    }

    assertThat(output()).contains("program override: 42 %");
  }

  @Test
  void handleErrorsNamesTheVariableAndSaysThatNothingWasWritten() {
    assertThat(run(() -> HandleErrors.main(new String[0])))
        .contains("MYSPEED: the controller refused to read MYSPEED")
        .contains("nothing was written");
  }

  @Test
  void ownStructureChangesOneFieldAndWritesTheWhole() {
    assertThat(run(() -> OwnStructure.main(new String[0])))
        .contains("{WELD: SPEED 0.500000, SEAM 7}");
  }

  @Test
  void ownRecordReadsAndWritesAStructureInOneAccessEach() {
    assertThat(run(() -> OwnRecord.main(new String[0])))
        .contains("seam 1 left, Z 3.0 mm")
        .contains(
            "{WELD: SPEED 0.800000, SEAM_NO 2, NAME[] \"right\", STATE #WELDING, OFFSET {FRAME: X"
                + " 1.00000, Y 2.00000, Z 3.50000, A 0.0, B 0.0, C 0.0}}");
  }

  @Test
  void watchVariablesPrintsFiveSamples() {
    assertThat(run(() -> WatchVariables.main(new String[0])))
        .contains("1: $OV_PRO = 100")
        .contains("5: $OV_PRO = 100")
        .contains("missed periods: ");
  }

  @Test
  void moveTheSimulatedRobotPrintsItsWayAndThatItStandsOnAWholeStep() {
    List<String> lines = run(() -> MoveTheSimulatedRobot.main(new String[0])).lines().toList();

    assertThat(lines).hasSize(7);
    assertThat(lines.get(0)).contains("X 525.0 mm, Z 890.0 mm, AUT, ACTUATOR #P_ACTIVE");
    assertThat(lines.get(6)).contains("X 365.0 mm, Z 970.0 mm, AUT, ACTUATOR #P_ACTIVE");
  }

  @Test
  void loadOwnProgramPrintsTheMistakeAndThenTheResult() {
    assertThat(run(() -> LoadOwnProgram.main(new String[0])).lines())
        .startsWith("weigh.src:6:3: SPTP is not supported", "TOTAL = 15.0000", "A1 = 10.0000");
  }

  @Test
  void runKrlProgramBringsAProgramToTheControllerMovesTheRobotAndGetsItBack() {
    assertThat(run(() -> RunKrlProgram.main(new String[0])).lines())
        .containsExactly(
            "started: #P_ACTIVE",
            "moved up by 40 mm or more",
            "stopped: #P_STOP",
            "the same bytes: true");
  }

  @Test
  void followAPathComesBackToWhereItBegan() {
    assertThat(run(() -> FollowAPath.main(new String[0])))
        .contains("planning point 24, A1 0.0" + System.lineSeparator() + "JOV_RESULT = 1");
  }

  @Test
  void measureTheSimulationPrintsALineForEachProgram() {
    assertThat(run(() -> MeasureTheSimulation.main(new String[] {"1"})).lines())
        .hasSize(4)
        .allMatch(line -> line.matches(".+: 60 s in .+ s, .+ cycles a second"));
  }

  @Test
  void transferFilesPrintsHowFarItHasComeAndWhatTheControllerHas() {
    assertThat(run(() -> TransferFiles.main(new String[0])).lines())
        .startsWith("0 of 1398", "1398 of 1398", "ACTUATOR.SRC, 1398 bytes")
        .hasSize(4);
  }

  @Test
  void runAProgramPrintsEachState() {
    assertThat(run(() -> RunAProgram.main(new String[0])).lines())
        .containsExactly("not selected, code 0", "#P_RESET", "#P_ACTIVE", "#P_STOP", "#P_FREE");
  }

  @Test
  void unknownOutcomeFindsOneWriteDoneAndTheOtherNot() {
    assertThat(run(() -> UnknownOutcome.main(new String[0])).lines())
        .containsExactly(
            "the answer is lost",
            "it was written",
            "the request is lost",
            "it was not written, MYINT = 7",
            "the connection is closed while reading",
            "MYINT = 7");
  }

  @Test
  void checkBeforeMovingRefusesWithoutAProgramAndBeyondALimit() {
    assertThat(run(() -> CheckBeforeMoving.main(new String[0])).lines())
        .containsExactly(
            "not moved: FOLLOW_AXIS is #P_RESET",
            "not moved: A1 must be -165.0 to 165.0, would be 168.0",
            "A1 is at 10.0");
  }

  @Test
  void solveKinematicsFindsThePlaceThatTheControllerReports() {
    assertThat(run(() -> SolveKinematics.main(new String[0])).lines())
        .contains(
            "S 2, T 34: 30.000 -80.000 100.000 10.000 60.000 -20.000",
            "S 7, T 49: -150.000 170.503 92.363 26.814 -160.526 -169.483 beyond a limit",
            "the same place");
  }

  @Test
  void swingAxisOneStopsALawThatIsTooFast() {
    // how the first law ends depends on how busy the computer is
    assertThat(run(() -> SwingAxisOne.main(new String[0])))
        .startsWith("swing: ")
        .contains("too fast: SPEED: the speed of A1 must be at most 30 degrees/s, is 90");
  }

  private interface Main {
    void run() throws Exception;
  }

  private String run(Main main) {
    try {
      main.run();
    } catch (Exception e) {
      throw new AssertionError(e);
    }
    return output();
  }
}
