package no.hials.crosscom.web.internal.programs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.CrossComAccessException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlPrograms;
import no.hials.crosscom.simulator.SimulationClock;
import no.hials.crosscom.web.internal.programs.MoveChecks.Check;
import no.hials.crosscom.web.internal.programs.MoveChecks.State;
import no.hials.crosscom.web.internal.robot.Readings.ReadOutcome;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.provider.EnumSource;

/** On both servers, with the simulated controller in different states. */
@ParameterizedClass
@EnumSource(ServerType.class)
class MoveChecksTest {
  private static final String LOOP =
      """
      DEF WORK ( )
        BAS (#INITMOV,0)
        PTP {A1 0,A2 -90,A3 90,A4 0,A5 0,A6 0}
        LOOP
          PTP {A1 5}
          PTP {A1 0}
        ENDLOOP
      END
      """;

  private final MockServer server;
  private final Controller controller;
  private final CrossComClient client;

  MoveChecksTest(ServerType type) throws IOException {
    server = MockServer.start(cfg -> cfg.server(type).clock(SimulationClock.stepped()));
    controller = server.controller();
    client = new CrossComClient(server.host(), server.port());
  }

  @BeforeEach
  void load() throws Exception {
    controller.load("work.src", LOOP);
  }

  @AfterEach
  void stop() throws IOException {
    client.close();
    server.close();
  }

  private Map<String, ReadOutcome> read() throws IOException {
    Map<String, ReadOutcome> values = new HashMap<>();
    for (String name : MoveChecks.VARIABLES) {
      try {
        values.put(name, new ReadOutcome(client.readValue(name), "", false));
      } catch (CrossComAccessException e) {
        values.put(name, new ReadOutcome(null, String.valueOf(e.getMessage()), false));
      }
    }
    return values;
  }

  private List<String> having(State state) throws IOException {
    return MoveChecks.of(read()).stream()
        .filter(it -> it.state() == state)
        .map(Check::name)
        .toList();
  }

  private List<String> problems() throws IOException {
    return having(State.PROBLEM);
  }

  private String advice(String name) throws IOException {
    return MoveChecks.of(read()).stream()
        .filter(it -> it.name().equals(name))
        .findFirst()
        .orElseThrow()
        .advice();
  }

  private void set(String name, String value) {
    server.variables().set(name, value);
  }

  private void step(Duration time) {
    controller.step(time);
  }

  /** Runs the program in AUT, beyond its BCO run. */
  private void run() throws Exception {
    controller.setMode(OperatingMode.AUT);
    controller.robot().select("WORK");
    controller.runProgram();
    step(Duration.ofMillis(500));
  }

  @Test
  void withoutAProgramTheFirstProblemIsTheProgram() throws Exception {
    assertThat(problems()).containsExactly("Program", "Enabling switch and drives");
    assertThat(advice("Program")).startsWith("No program is selected.");
    assertThat(advice("Enabling switch and drives")).contains("$SAFETY_SW = #RELEASED");
    assertThat(MoveChecks.isMoving(read())).isFalse();
  }

  @Test
  void aSelectedProgramNeedsStartTwice() throws Exception {
    controller.setMode(OperatingMode.AUT);
    controller.robot().select("WORK");

    assertThat(problems()).containsExactly("Start");
    assertThat(advice("Start")).contains("BCO run", "press Start again");

    controller.start();
    step(Duration.ofSeconds(5));

    assertThat(problems()).containsExactly("Start");
    assertThat(advice("Start")).contains("at the end of its BCO run", "Press Start.");
  }

  @Test
  void inExtThePlcStartsTheProgram() throws Exception {
    run();
    controller.setMode(OperatingMode.EXT);

    assertThat(problems()).contains("Start");
    assertThat(advice("Start")).contains("the PLC starts it").doesNotContain("Press");
  }

  @Test
  void aRunningProgramHasNoProblem() throws Exception {
    run();

    assertThat(problems()).isEmpty();
    assertThat(having(State.UNKNOWN)).isEmpty();
    assertThat(MoveChecks.isMoving(read())).isTrue();
  }

  @Test
  void theEmergencyStopIsBeforeItsMessageAndTheStoppedProgram() throws Exception {
    run();

    controller.emergencyStop(true);
    step(Duration.ofSeconds(1));

    assertThat(problems()).containsExactly("Emergency stop", "Messages", "Drives", "Start");
    controller.emergencyStop(false);
    assertThat(problems()).containsExactly("Messages", "Start");
    assertThat(advice("Start")).startsWith("The program was stopped by a message.");
    assertThat(controller.confirmAll()).isPositive();
    assertThat(problems()).containsExactly("Start");
  }

  @Test
  void anOverrideOfZeroIsTheOnlyProblemOfARunningProgram() throws Exception {
    run();

    set("$OV_PRO", "0");
    step(Duration.ofSeconds(1));

    assertThat(problems()).containsExactly("Override");
    assertThat(advice("Motion")).startsWith("The program runs and the robot stands");
  }

  @Test
  void anOpenGateMattersOutsideOfT1() throws Exception {
    controller.robot().select("WORK");
    set("$USER_SAF", "FALSE");

    assertThat(problems()).doesNotContain("Operator safety");
    assertThat(advice("Operator safety")).contains("T1 and T2 permit");
    controller.setMode(OperatingMode.AUT);
    assertThat(problems()).containsExactly("Operator safety", "Start");
  }

  @Test
  void inExtTheReleasesOfThePlcAreChecked() throws Exception {
    controller.robot().select("WORK");
    controller.setMode(OperatingMode.EXT);
    set("$MOVE_ENABLE", "FALSE");
    set("$DRIVES_OFF", "FALSE");

    assertThat(problems())
        .startsWith("Motion released by the PLC", "Drives released by the PLC")
        .contains("Start");
  }

  @Test
  void anAxisAtItsLimitIsNamed() throws Exception {
    run();
    controller.robot().stop();
    step(Duration.ofSeconds(1));
    controller.robot().cancel();
    set("$SOFTP_END[2]", "-90");

    assertThat(problems()).contains("Software limits");
    assertThat(MoveChecks.of(read()).toString()).contains("A2 is at -90.00 of -190.00 to -90.00");
  }

  @Test
  void aStepModeIsNamed() throws Exception {
    set("$PRO_MODE1", "#MSTEP");

    assertThat(advice("Step mode")).contains("each one needs Start");
  }

  @Test
  void anEndedProgramIsNamed() throws Exception {
    controller.load("once.src", "DEF ONCE ( )\nEND\n");
    controller.setMode(OperatingMode.AUT);
    controller.robot().select("ONCE");
    controller.start();
    step(Duration.ofMillis(100));

    assertThat(problems()).containsExactly("Start");
    assertThat(advice("Start")).startsWith("The program has ended.");
  }

  @Test
  void aProgramThatFollowsAVariableWaitsForIt() throws Exception {
    KrlPrograms.start(controller, KrlPrograms.START, "actuator");
    step(Duration.ofSeconds(1));

    assertThat(problems()).containsExactly("Variable that the program follows");
    assertThat(advice("Variable that the program follows"))
        .isEqualTo("The program adds MYPOS again and again, and it is all zeros.");

    set("MYPOS", "{Z 0.5}");
    assertThat(problems()).isEmpty();
    set("JOV_LIMIT", "50");
    step(Duration.ofSeconds(1));
    assertThat(problems()).startsWith("Start").contains("Watchdog of the client");
  }

  @Test
  void aTargetThatIsReachedIsNamed() throws Exception {
    KrlPrograms.start(controller, KrlPrograms.START, "follow_axis");
    step(Duration.ofSeconds(1));

    assertThat(problems()).containsExactly("Variable that the program follows");
    assertThat(advice("Variable that the program follows"))
        .isEqualTo("The robot is at JOV_AXIS: write another target.");
    set("JOV_AXIS", "{A1 20}");
    assertThat(problems()).isEmpty();
  }

  @Test
  void aPathWaitsForItsCommand() throws Exception {
    KrlPrograms.start(controller, KrlPrograms.START, "play_path");
    step(Duration.ofSeconds(1));

    assertThat(advice("Variable that the program follows")).contains("last JOV_COMMAND");
  }

  @Test
  void valuesOfALostServerAreNotJudged() throws Exception {
    Map<String, ReadOutcome> values = read();
    values.put("$OV_PRO", new ReadOutcome(null, "the connection broke", true));

    List<Check> checks = MoveChecks.of(values);

    assertThat(checks.get(0).name()).isEqualTo("Server");
    assertThat(checks.get(0).state()).isEqualTo(State.PROBLEM);
    assertThat(checks.get(0).read()).isEqualTo("the connection broke");
    assertThat(checks.subList(1, checks.size()))
        .extracting(Check::state)
        .containsOnly(State.UNKNOWN);
    assertThat(MoveChecks.isMoving(values)).isNull();
  }

  @Test
  void aVariableThatTheControllerDoesNotHaveIsUnknown() throws Exception {
    Map<String, ReadOutcome> values = read();
    values.put("$ROB_CAL", new ReadOutcome(null, "refused", false));

    assertThat(MoveChecks.of(values))
        .contains(new Check("Mastering", State.UNKNOWN, "$ROB_CAL: refused", ""));
  }
}
