package no.hials.crosscom.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.mock.MockServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Runs every example like a user. */
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

    assertThat(output()).startsWith("X 525.0 mm, Z 890.0 mm").contains("override 100 %");
  }

  @Test
  void readVariablesPrintsAValueOfEveryType() throws Exception {
    ReadVariables.main(new String[0]);

    assertThat(output())
        .contains("program override: 100 %")
        .contains("operating mode: T1")
        .contains("input 1025: true")
        .contains("model: #KR6R900 C4SR FLR 230")
        .contains("A1 to A6: [0.0, -90.0, 90.0, 0.0, 0.0, 0.0]")
        .contains("torques: [0.0, 0.0")
        .contains("any type: {LOAD: M 2.50000, CM {FRAME: X 0.0");
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
  void anExampleRefusesAHostWithoutAPortAndDoesNotSimulateOne() {
    assertThatThrownBy(() -> ReadVariables.main(new String[] {"192.168.1.10"}))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("the arguments must be HOST PORT or none, are 192.168.1.10");

    assertThat(output()).isEmpty();
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
        .startsWith(
            "weigh.src:6:3: ASYPTP is not supported",
            "ended: true",
            "TOTAL = 15.0000",
            "A1 = 10.0000");
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
        .startsWith("0 of 1418", "1418 of 1418", "ACTUATOR.SRC, 1418 bytes")
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
  void recoverFromARestartWritesOnceTheControllerIsBack() {
    assertThat(run(() -> RecoverFromARestart.main(new String[0])).lines())
        .satisfiesExactly(
            line -> assertThat(line).contains("the outcome is unknown"),
            line -> assertThat(line).isEqualTo("it was written"),
            line -> assertThat(line).contains("the outcome is unknown"),
            line -> assertThat(line).isEqualTo("it had been written"),
            line -> assertThat(line).contains("timeouts=1, losses=1, reconnects=2"));
  }

  @Test
  void checkBeforeMovingRefusesWithoutAProgramAndBeyondALimit() {
    List<String> lines = run(() -> CheckBeforeMoving.main(new String[0])).lines().toList();

    assertThat(lines).hasSize(3);
    assertThat(lines)
        .startsWith(
            "not moved: FOLLOW_AXIS is #P_RESET",
            "not moved: A1 must be -165.0 to 165.0, would be 168.0");
    assertThat(lines.get(2)).matches("A1 is at (9\\.99|10\\.0).*"); // arrived is within 0.01
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
    // the end of the first law depends on the load of the computer
    assertThat(run(() -> SwingAxisOne.main(new String[0])))
        .startsWith("swing: ")
        .contains("too fast: SPEED: the speed of A1 must be at most 30 degrees/s, is 90");
  }

  @Test
  void asyncReadsPrintsTwoValuesAndARefusal() {
    assertThat(run(() -> AsyncReads.main(new String[0])).lines())
        .containsExactly(
            "asked for the mode and the override", "#T1 at 100 %", "refused: NO_SUCH_VARIABLE");
  }

  @Test
  void readArraysPrintsWholeArraysAndAnElement() {
    assertThat(run(() -> ReadArrays.main(new String[0])))
        .contains("A1 to A6 in degrees: [-170.0, -190.0, -120.0, -185.0, -120.0, -350.0]")
        .contains("inputs that are on: [1025]")
        .contains("upper limit of A1 in degrees: 170.0");
  }

  @Test
  void discoverServersFindsTheSimulatedController() {
    assertThat(run(() -> DiscoverServers.main(new String[0])))
        .startsWith("1 found")
        .contains("#KR6R900 C4SR FLR 230, serial number 736512")
        .contains("C3_BRIDGE at 127.0.0.1:");
  }

  @Test
  void inspectTheServerTellsTheTwoKindsApart() {
    assertThat(run(() -> InspectTheServer.main(new String[0])).lines())
        .startsWith("server: KUKAVARPROXY", "version: unknown", "several at once: false")
        .contains("server: C3_BRIDGE", "version: 1.4", "several at once: true", "programs: true");
  }

  @Test
  void logToCsvSaysWhereSamplesAreMissing() throws Exception {
    List<String> lines = run(() -> LogToCsv.main(new String[0])).lines().toList();

    Matcher file = Pattern.compile("20 samples in (.+), after a gap:").matcher(lines.get(1));
    assertThat(file.matches()).isTrue();
    assertThat(lines.get(2)).isEqualTo("time,a1_deg,a2_deg,missed");
    assertThat(lines.get(3)).matches(".+Z,0.0,-90.0000,[1-9][0-9]*");
    assertThat(Path.of(file.group(1))).content().hasLineCount(21);
    Files.delete(Path.of(file.group(1)));
  }

  @Test
  void krlValuesPrintsEachKindAndAMistake() {
    assertThat(run(() -> KrlValues.main(new String[0])))
        .contains("'HFF' is a KrlInt: 255")
        .contains("{X 1.5, S 'B010'} is a KrlStruct: {X 1.50000, S 2}")
        .contains("Z in mm: 0.100000")
        .contains("A: Optional.empty")
        .contains("to be written: {X 1000.25,Y 0.0,Z 0.1}")
        .contains("expected ',' or '}' at position 13, found the end");
  }

  @Test
  void injectFaultsPrintsTheExceptionOfEachFault() {
    assertThat(run(() -> InjectFaults.main(new String[0])).lines())
        .containsExactly(
            "no fault: 100 %",
            "a slow answer: 100 %",
            "an answer in single bytes: 100 %",
            "no answer: CrossComTimeoutException",
            "the answer to something else: CrossComProtocolException",
            "half an answer: CrossComConnectionLostException",
            "an empty answer: CrossComProtocolException",
            "noise: CrossComTimeoutException");
  }

  @Test
  void digitalTwinIsAlwaysWhereTheRobotIs() {
    assertThat(run(() -> DigitalTwin.main(new String[0])).lines())
        .hasSize(5)
        .doesNotHaveDuplicates()
        .allMatch(line -> line.endsWith("; $POS_ACT is 0.000 mm away"));
  }

  @Test
  void handleAStoppedRobotBringsItsProgramToTheEnd() {
    assertThat(run(() -> HandleAStoppedRobot.main(new String[0])).lines())
        .hasSize(7)
        .contains("  1200 emergency stop", "  1 the emergency stop is pressed")
        .anyMatch(line -> line.startsWith("emergency stop: program #P_STOP, stop message TRUE"))
        .anyMatch(line -> line.startsWith("confirmed: program #P_STOP, stop message FALSE"))
        .endsWith("started again: program #P_END, stop message FALSE, A1 at 0.0 degrees");
  }

  @Test
  void twoRobotsEndAtTheSameAngle() {
    List<String> lines = run(() -> TwoRobots.main(new String[0])).lines().toList();

    assertThat(lines).hasSize(6);
    assertThat(lines.get(2)).isNotEqualTo(lines.get(3));
    assertThat(lines.get(5)).isEqualTo("leader A1 20.00 degrees, follower A1 20.00 degrees");
  }

  @Test
  void setOutputsSwitchesAnOutputOnAndOff() {
    assertThat(run(() -> SetOutputs.main(new String[0])).lines())
        .containsExactly("output 3 is on", "part is there: true", "output 3 is off");
  }

  @Test
  void playAPathComesToTheLastPointAndRefusesABadPath() {
    assertThat(run(() -> PlayAPath.main(new String[0])).lines())
        .containsExactly(
            "came to [0.0, -90.0, 90.0, 0.0, 50.0, 0.0] degrees",
            "nothing was moved: A1 must be -165 to 165 degrees (limits minus a margin of 5), would"
                + " be 169");
  }

  @Test
  void controlByPositionClosesTheCircle() {
    assertThat(run(() -> ControlByPosition.main(new String[0])))
        .contains("TIME_OVER")
        .contains("path: at most ")
        .contains("the circle is closed");
  }

  @Test
  void controlByVelocityMovesUntilTheDeadManIsLetGo() {
    List<String> lines = run(() -> ControlByVelocity.main(new String[0])).lines().toList();

    assertThat(lines.get(0)).startsWith("TIME_OVER");
    assertThat(lines.get(1)).isEqualTo("the robot stopped after the dead-man was released: true");
    assertThat(lines.get(2)).matches("moved along Y: [1-9].* mm");
  }

  @Test
  void followALineGoesAlongTheLine() {
    assertThat(run(() -> FollowALine.main(new String[0])))
        .contains("TIME_OVER")
        // the distance depends on the load of this computer; FollowingTest has simulated time
        .containsPattern(
            "[1-9][0-9]\\.[0-9] mm along the line, [12]?[0-9]\\.[0-9] mm from its target");
  }

  @Test
  void readAndMoveTurnsA1ByThreeDegrees() {
    assertThat(run(() -> ReadAndMove.main(new String[0])).lines())
        .containsExactly(
            "mode #T1",
            "A1 to A6 in degrees: [0.0, -90.0, 90.0, 0.0, 0.0, 0.0]",
            "override in %: 50",
            "A1 is at 3.0 degrees");
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
