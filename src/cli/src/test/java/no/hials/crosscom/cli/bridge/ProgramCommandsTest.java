package no.hials.crosscom.cli.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.simulator.Message;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The commands of {@code program}, and {@code confirm}, on C3 Bridge. */
class ProgramCommandsTest {
  private static final String WAITS = "DEF WAITS ( )\n  WAIT FOR $IN[1]\nEND\n";

  @KukaController(server = ServerType.C3_BRIDGE, mode = OperatingMode.AUT, clock = "stepped")
  private MockServer server;

  @BeforeEach
  void start() throws IOException {
    server.files().put("/R1/WAITS.SRC", WAITS);
  }

  private Cli.Result run(String command, String... args) {
    return Cli.runOn(server, command, args);
  }

  private ProgramState state() {
    return server.controller().robot().state();
  }

  @ParameterizedTest
  @ValueSource(strings = {"/R1/WAITS", "/r1/waits.src", "KRC:\\R1\\PROGRAM\\WAITS.SRC", "WAITS"})
  void selectsAProgramInEveryFormOfItsNameAndDoesNotStartIt(String name) {
    run("program select", name, "--yes").succeeds().containsExactly("robot: WAITS #P_RESET");
    assertThat(state()).isEqualTo(ProgramState.RESET);
  }

  @Test
  void startsStopsResetsAndCancels() {
    run("program select", "/R1/WAITS", "--yes");

    assertThat(run("program start", "--yes").lines()).containsExactly("robot: WAITS #P_ACTIVE");
    assertThat(run("program stop").lines()).containsExactly("robot: WAITS #P_STOP");
    assertThat(run("program reset", "--yes").lines()).containsExactly("robot: WAITS #P_RESET");
    assertThat(run("program cancel", "--yes").lines()).containsExactly("robot: no program #P_FREE");
  }

  @Test
  void runsAProgramWithParameters() throws IOException {
    server.files().put("/R1/SETS.SRC", "DEF SETS (I:IN)\nINT I\n  WAIT FOR $IN[1]\nEND\n");

    assertThat(run("program run", "/R1/SETS", "--parameters", "5", "--yes").lines())
        .containsExactly("robot: SETS #P_ACTIVE");

    ProgramSelectRequest request =
        (ProgramSelectRequest)
            server.requests().stream()
                .map(each -> each.request())
                .filter(ProgramSelectRequest.class::isInstance)
                .findFirst()
                .orElseThrow();
    assertThat(request.parameters()).isEqualTo("5");
    assertThat(request.force()).isFalse();
  }

  @Test
  void runStartsTheProgramAgainAfterItsBcoRun() throws IOException {
    try (MockServer moving = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      moving.controller().setMode(OperatingMode.AUT);
      moving.files().put("/R1/MOVES.SRC", "DEF MOVES ( )\n  PTP {A1 1}\n  WAIT FOR FALSE\nEND\n");

      assertThat(Cli.runOn(moving, "program run", "/R1/MOVES", "--yes").lines())
          .containsExactly("robot: MOVES #P_ACTIVE");

      assertThat(moving.controller().messages())
          .extracting(Message::toString)
          .containsExactly("1350 programmed path reached (BCO)");
    }
  }

  @Test
  void runStartsAProgramAgainWhoseFirstTargetIsWhereTheRobotStands() throws IOException {
    try (MockServer moving = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      moving.controller().setMode(OperatingMode.AUT);
      moving
          .files()
          .put("/R1/STANDS.SRC", "DEF STANDS ( )\n  PTP $AXIS_ACT\n  WAIT FOR FALSE\nEND\n");

      assertThat(Cli.runOn(moving, "program run", "/R1/STANDS", "--yes").lines())
          .containsExactly("robot: STANDS #P_ACTIVE");
    }
  }

  @Test
  void runFailsIfTheProgramHasStopped() throws IOException {
    try (MockServer stopping = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      stopping.controller().setMode(OperatingMode.AUT);
      stopping.files().put("/R1/HALTS.SRC", "DEF HALTS ( )\n  HALT\n  WAIT FOR FALSE\nEND\n");

      Cli.Result result = Cli.runOn(stopping, "program run", "/R1/HALTS", "--yes");

      assertThat(result.code()).isEqualTo(1);
      assertThat(result.lines()).containsExactly("robot: HALTS #P_STOP");
      assertThat(result.errLines().get(0)).isEqualTo("jopenshowvar: the program has stopped");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"program run WAITS", "program start"})
  void namesTheConfirmationIfAMessagePreventsTheStart(String command) {
    run("program select", "WAITS", "--yes");
    server.controller().emergencyStop(true);
    server.controller().emergencyStop(false);

    run(command, "--yes")
        .failsInLines(1)
        .last()
        .asString()
        .endsWith("a message has to be confirmed ('jopenshowvar confirm')");
    run("confirm", "--yes").succeeds();
    run(command, "--yes").succeeds();
  }

  @Test
  void stopsAnActiveProgramOnlyByForce() {
    run("program run", "WAITS", "--yes");

    Cli.Result refused = run("program select", "WAITS", "--yes");
    assertThat(refused.errLines().get(0)).contains("code 2 (ACCESS");
    assertThat(refused.errLines().get(1)).startsWith("likely cause: the operating mode");
    assertThat(refused.code()).isEqualTo(1);

    assertThat(run("program select", "WAITS", "--force", "--yes").lines())
        .containsExactly("robot: WAITS #P_RESET");
  }

  @Test
  void worksOnTheSubmitInterpreterToo() throws Exception {
    server.files().put("/R1/LOOPS.SUB", "DEF LOOPS ( )\nLOOP\n  WAIT SEC 1\nENDLOOP\nEND\n");
    server.controller().load("loops.sub", server.files().text("/R1/LOOPS.SUB").orElseThrow());
    server.controller().submit().select("LOOPS");

    assertThat(run("program start", "--submit", "--yes").lines())
        .containsExactly("submit: LOOPS #P_ACTIVE");
    assertThat(run("program stop", "--submit").lines()).containsExactly("submit: LOOPS #P_STOP");
  }

  @Test
  void printsJson() {
    assertThat(run("program run", "WAITS", "--yes", "--json").lines())
        .containsExactly(
            "{\"command\":\"run\",\"interpreter\":\"robot\",\"program\":\"WAITS\",\"state\":\"#P_ACTIVE\"}");
  }

  @Test
  void saysThatAProgramCannotBeSelected() throws IOException {
    server.files().put("/R1/BAD.SRC", "DEF BAD ( )\n  MYINT = = 3\nEND\n");

    for (String name : new String[] {"/R1/BAD", "/R1/NOPE", "/R1/\u00e4\u4e2d"}) {
      run("program select", name, "--yes")
          .failsInLines(1)
          .containsExactly(
              "jopenshowvar: the server refused the selection of program "
                  + name
                  + ": code 0 (GENERAL: no reason given)",
              "likely cause: there is no such program, or it has errors");
    }
  }

  @ParameterizedTest
  @CsvSource({
    "program select WAITS,select WAITS",
    "program run WAITS,run WAITS",
    "program start,start the program of the robot interpreter",
    "program reset,reset the program of the robot interpreter",
    "program cancel --submit,cancel the program of the submit interpreter",
    "confirm,confirm all messages"
  })
  void asksOutsideT1AndSendsNothingWithoutATerminal(String command, String what) {
    run(command)
        .failsInLines(5)
        .containsExactly("jopenshowvar: did not " + what + ": $MODE_OP is #AUT, which needs --yes");
    assertThat(server.controller().robot().program()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "program select WAITS",
        "program run WAITS",
        "program start",
        "program stop",
        "program reset",
        "program cancel",
        "confirm"
      })
  void refusesEverythingWhereOnlyReadingIsAllowed(String command) {
    run(command, "--read-only", "--yes")
        .failsInALine(5)
        .startsWith("jopenshowvar: did not ")
        .endsWith(": --read-only is given");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void stopsWithoutAQuestionInEveryMode() {
    run("program run", "WAITS", "--yes");
    server.clearRequests();

    assertThat(run("program stop").code()).isZero();

    assertThat(state()).isEqualTo(ProgramState.STOP);
    assertThat(server.requests()).noneMatch(each -> each.toString().contains("$MODE_OP"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "program select WAITS",
        "program run WAITS",
        "program start",
        "program stop",
        "program reset",
        "program cancel",
        "confirm"
      })
  void saysThatKukavarproxyCannot(String command) throws IOException {
    try (MockServer old = MockServer.start()) {
      old.controller().setMode(OperatingMode.AUT);

      Cli.runOn(old, command)
          .failsInALine(1)
          .startsWith("jopenshowvar: this server does not support the ")
          .endsWith("the server is KUKAVARPROXY");
    }
  }

  @Test
  void neverRepeatsACommandWhoseAnswerWasLost() {
    run("program select", "WAITS", "--yes");
    server.clearRequests();
    server.fault(each -> each.request() instanceof ProgramControlRequest, Fault.closeDuring(3));

    run("program start", "--yes").fails(4).contains("the outcome is unknown");
    assertThat(server.requests())
        .filteredOn(each -> each.request() instanceof ProgramControlRequest)
        .hasSize(1);
  }

  @Test
  void saysThatACommandWasDoneAlthoughTheStateCannotBeRead() {
    run("program run", "WAITS", "--yes");
    server.fault(each -> each.toString().contains("$PRO_"), Fault.closeBefore());

    run("program stop").succeeds().containsExactly("robot: program unknown state unknown");
    assertThat(state()).isEqualTo(ProgramState.STOP);
  }

  @Test
  void startsAControllerOfItsOwnWithC3Bridge() {
    Cli.Result result = Cli.run("program", "cancel", "--mock");

    assertThat(result.lines()).containsExactly("robot: no program #P_FREE");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "program | missing required subcommand: select, start, stop, reset, cancel, run",
        "program go | unknown command: 'go'",
        "program select | missing required parameter: 'PROGRAM'",
        "program select A B | too many arguments: 'B'",
        "program start | which controller?",
        "program start A --mock | too many arguments: 'A'"
      })
  void saysWhatIsWrongWithTheUsage(String arguments, String message) {
    Cli.Result result = Cli.run(arguments.split(" "));

    assertThat(result.errLines().get(0)).startsWith("jopenshowvar: ").contains(message);
    result.failsInLines(2).last().asString().startsWith("try 'jopenshowvar program");
  }

  @Test
  void doesNotSendABlankOrEndlessName() {
    assertThat(run("program select", " ").code()).isEqualTo(2);
    assertThat(run("program select", "X".repeat(10_001)).err()).contains("at most 10000");
    assertThat(server.requestCount()).isZero();
  }

  // confirm

  @Test
  void confirmsAllMessages() {
    assertThat(run("confirm", "--yes").lines()).containsExactly("all messages confirmed");
    assertThat(run("confirm", "--yes", "--json").lines())
        .containsExactly("{\"command\":\"confirm\"}");
  }
}
