package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.protocol.file.FileRequest.DeleteFileRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.MotionRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.PendantKeyRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.JogCoordinates;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the messages of C3 Bridge for programs, motions and keys. */
final class C3ControlTest {
  private static final Duration SHORT = Duration.ofMillis(240);
  private static final Duration LONG = Duration.ofSeconds(60);
  private static final Axis START = Axis.of(0, -90, 90, 0, 45, 0);

  @KukaController(server = ServerType.C3_BRIDGE, clock = "stepped")
  private MockServer server;

  private RawClient client;
  private Controller controller;

  @BeforeEach
  void start() throws IOException {
    client = new RawClient(server);
    controller = server.controller();
    controller.place(START);
    server.variables().set("$OV_PRO", "100");
    server.variables().set("$OV_JOG", "100");
  }

  @AfterEach
  void stop() throws IOException {
    client.close();
  }

  private ErrorCode code(Request request) throws IOException {
    TypedResponse answer = (TypedResponse) client.exchange(request);
    assertThat(answer.tail().success()).isEqualTo(answer.tail().code() == 1);
    return ErrorCode.from(answer.tail().code()).orElseThrow();
  }

  private ErrorCode control(ProgramCommand command) throws IOException {
    return code(new ProgramControlRequest(1, Code.of(command), Code.of(Interpreter.ROBOT)));
  }

  private ErrorCode select(String name) throws IOException {
    return select(ProgramCommand.SELECT, name, "", false);
  }

  private ErrorCode select(ProgramCommand command, String name, String parameters, boolean force)
      throws IOException {
    return code(
        new ProgramSelectRequest(
            1, Code.of(command), Code.of(Interpreter.SUBMIT), name, parameters, force));
  }

  private ErrorCode move(MotionType type, String position) throws IOException {
    return code(new MotionRequest(1, Code.of(type), position));
  }

  private ErrorCode press(PendantKey key, int number, boolean direction) throws IOException {
    return code(new PendantKeyRequest(1, Code.of(key), number, 0, direction, false));
  }

  private ErrorCode release(PendantKey key, int number) throws IOException {
    return code(new PendantKeyRequest(1, Code.of(key), number, 0, false, true));
  }

  private void put(String name, String... lines) throws IOException {
    server.files().put("/R1/" + name, String.join("\r\n", lines) + "\r\n");
  }

  private void putLoop() throws IOException {
    put("WORK.SRC", "DEF WORK()", "LOOP", "MYINT=MYINT+1", "WAIT SEC 0.1", "ENDLOOP", "END");
  }

  private double tcp(String component) {
    return Double.parseDouble(server.variables().get("$POS_ACT." + component));
  }

  private void untilStanding() {
    controller.step(SHORT);
    assertThat(controller.stepUntil(controller::standing, LONG)).isTrue();
  }

  // type 10

  @Nested
  final class Programs {

    @ParameterizedTest
    @ValueSource(strings = {"/R1/WORK", "/r1/work.src", "KRC:\\R1\\PROGRAM\\WORK.SRC", "WORK"})
    void runsAProgramOfTheFiles(String name) throws IOException {
      putLoop();
      assertThat(select(name)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.RESET);
      assertThat(control(ProgramCommand.START)).isEqualTo(ErrorCode.SUCCESS);
      controller.step(SHORT);
      assertThat(server.variables().get("MYINT")).isEqualTo("3");
      assertThat(control(ProgramCommand.STOP)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
      assertThat(control(ProgramCommand.RESET)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.RESET);
      assertThat(control(ProgramCommand.CANCEL)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.FREE);
    }

    @Test
    void runsWithParameters() throws IOException {
      put(
          "JOB.SRC",
          "DEF JOB(N:IN, P:IN)",
          "DECL INT N",
          "DECL FRAME P",
          "MYINT=N",
          "MYPOS.X=P.X",
          "END");
      assertThat(
              select(ProgramCommand.RUN, "/R1/JOB", "5, {FRAME: X 7,Y 8,Z 0,A 0,B 0,C 0}", false))
          .isEqualTo(ErrorCode.SUCCESS);
      controller.step(SHORT);
      assertThat(server.variables().get("MYINT")).isEqualTo("5");
      assertThat(server.variables().get("MYPOS.X")).isEqualTo("7.00000");
    }

    @Test
    void saysWhichArgumentsItCannotTake() throws IOException {
      putLoop();
      put("TEXT.SRC", "DEF TEXT(S[]:IN)", "DECL CHAR S[]", "END");
      assertThat(select(" ")).isEqualTo(ErrorCode.ARGUMENT);
      assertThat(select(ProgramCommand.SELECT, "WORK", "1", false)).isEqualTo(ErrorCode.ARGUMENT);
      assertThat(select(ProgramCommand.SELECT, "WORK", ",", false)).isEqualTo(ErrorCode.ARGUMENT);
      assertThat(select(ProgramCommand.SELECT, "TEXT", "\"a, {b\"", false))
          .isEqualTo(ErrorCode.SUCCESS);
      assertThat(
              code(
                  new ProgramControlRequest(
                      1, Code.of(ProgramCommand.STOP), new Code<>(Interpreter.class, 2))))
          .isEqualTo(ErrorCode.ARGUMENT);
    }

    @Test
    void refusesAProgramThatIsNotThereOrHasErrors() throws IOException {
      put("BAD.SRC", "DEF BAD()", "NOSUCHVARIABLE=1", "END");
      assertThat(select("/R1/NOPE")).isEqualTo(ErrorCode.GENERAL);
      assertThat(select("/R1/BAD")).isEqualTo(ErrorCode.GENERAL);
      put("BAD.SRC", "DEF BAD()", "MYINT=1", "END");
      assertThat(select("/R1/BAD")).isEqualTo(ErrorCode.SUCCESS);
    }

    @Test
    void refusesWhatTheStateDoesNotAllow() throws IOException {
      putLoop();
      assertThat(control(ProgramCommand.START)).isEqualTo(ErrorCode.ACCESS);
      assertThat(control(ProgramCommand.RESET)).isEqualTo(ErrorCode.ACCESS);
      controller.setMode(OperatingMode.EXT);
      assertThat(select(ProgramCommand.RUN, "WORK", "", false)).isEqualTo(ErrorCode.ACCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.RESET);
    }

    @Test
    void replacesAnActiveProgramOnlyByForce() throws IOException {
      putLoop();
      put("OTHER.SRC", "DEF OTHER()", "END");
      assertThat(select(ProgramCommand.RUN, "WORK", "", true)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(select("OTHER")).isEqualTo(ErrorCode.ACCESS);
      assertThat(select(ProgramCommand.SELECT, "OTHER", "", true)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().program()).contains("OTHER");
    }

    @Test
    void keepsTheFileOfASelectedProgram() throws IOException {
      putLoop();
      Request delete = new DeleteFileRequest(1, true, "/R1/WORK.SRC");
      assertThat(select("WORK")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(code(delete)).isNotEqualTo(ErrorCode.SUCCESS);
      assertThat(control(ProgramCommand.CANCEL)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(code(delete)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(select("WORK")).isEqualTo(ErrorCode.GENERAL);
    }

    @Test
    void controlsTheSubmitInterpreter() throws Exception {
      controller.load("SPS.SUB", "DEF SPS()\nLOOP\nWAIT SEC 1\nENDLOOP\nEND\n");
      controller.submit().select("SPS");
      assertThat(
              client.exchange(
                  new ProgramControlRequest(
                      652, Code.of(ProgramCommand.START), Code.of(Interpreter.SUBMIT))))
          .isEqualTo(
              new ProgramResponse(
                  652, MessageType.PROGRAM_CONTROL, ProgramCommand.START.code(), Tail.SUCCESS));
      assertThat(controller.submit().state()).isEqualTo(ProgramState.ACTIVE);
    }
  }

  @Test
  void confirmsAllMessages() throws IOException {
    controller.emergencyStop(true);
    controller.emergencyStop(false);
    assertThat(server.variables().get("$STOPMESS")).isEqualTo("TRUE");
    assertThat(client.exchange(new ServerRequest(1, MessageType.CONFIRM_ALL)))
        .isEqualTo(new PlainResponse(1, MessageType.CONFIRM_ALL, Tail.SUCCESS));
    assertThat(server.variables().get("$STOPMESS")).isEqualTo("FALSE");
  }

  // type 11

  @Nested
  final class Motions {

    @Test
    void movesTheRobotToAPosition() throws IOException {
      assertThat(client.exchange(new MotionRequest(1, Code.of(MotionType.PTP), "{A1 30}")))
          .isEqualTo(
              new ProgramResponse(1, MessageType.MOTION, MotionType.PTP.code(), Tail.SUCCESS));
      controller.step(SHORT);
      assertThat(controller.standing()).isFalse();
      untilStanding();
      assertThat(controller.axes()).isEqualTo(START.with(0, 30));
    }

    @Test
    void movesTheRobotByADifferenceOneMotionAfterTheOther() throws IOException {
      double x = tcp("X");
      double y = tcp("Y");
      double z = tcp("Z");
      assertThat(move(MotionType.LIN_REL, "{X -100}")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(move(MotionType.PTP_REL, "{Y 50}")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(move(MotionType.LIN, "{Z " + (z - 20) + "}")).isEqualTo(ErrorCode.SUCCESS);
      controller.stepUntil(() -> tcp("Z") < z - 19.99 && controller.standing(), LONG);
      assertThat(tcp("X")).isEqualTo(x - 100, within(0.01));
      assertThat(tcp("Y")).isEqualTo(y + 50, within(0.01));
      assertThat(tcp("Z")).isEqualTo(z - 20, within(0.01));
      assertThat(controller.messages()).isEmpty();
    }

    @Test
    void refusesWhereItCannotGo() throws IOException {
      assertThat(move(MotionType.PTP, "{X 5000}")).isEqualTo(ErrorCode.GENERAL);
      assertThat(move(MotionType.PTP, "{A1 999}")).isEqualTo(ErrorCode.GENERAL);
      assertThat(move(MotionType.LIN_REL, "{A1 9}")).isEqualTo(ErrorCode.ARGUMENT);
      assertThat(move(MotionType.PTP, "5")).isEqualTo(ErrorCode.ARGUMENT);
      assertThat(code(new MotionRequest(1, new Code<>(MotionType.class, 5), "{X 1}")))
          .isEqualTo(ErrorCode.NOT_IMPLEMENTED);
      controller.step(SHORT);
      assertThat(controller.axes()).isEqualTo(START);
    }

    @Test
    void stopsWithAMessageWhereThePathLeadsNowhere() throws IOException {
      assertThat(move(MotionType.LIN_REL, "{X 2000}")).isEqualTo(ErrorCode.SUCCESS);
      untilStanding();
      assertThat(controller.messages()).hasSize(1);
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.ACCESS);
      controller.confirmAll();
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.SUCCESS);
    }

    @Test
    void movesOnlyWhileNoProgramIsActiveOrStoppedWithinAMotion() throws IOException {
      put("GO.SRC", "DEF GO()", "PTP {A1 60}", "LOOP", "WAIT SEC 1", "ENDLOOP", "END");
      assertThat(select(ProgramCommand.RUN, "GO", "", false)).isEqualTo(ErrorCode.SUCCESS);
      controller.step(SHORT);
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.ACCESS);
      controller.robot().stop();
      untilStanding();
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.ACCESS);
      controller.robot().reset();
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.SUCCESS);
      untilStanding();
      assertThat(controller.axes().get(0)).isEqualTo(30, within(1e-6));
    }

    @Test
    void startsNoProgramWhileItMoves() throws IOException {
      putLoop();
      assertThat(select("WORK")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(control(ProgramCommand.START)).isEqualTo(ErrorCode.ACCESS);
      assertThat(control(ProgramCommand.STOP)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(control(ProgramCommand.START)).isEqualTo(ErrorCode.SUCCESS);
    }

    @Test
    void endsAtTheEmergencyStopAndWhenTheModeChanges() throws IOException {
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.SUCCESS);
      controller.step(SHORT);
      controller.setMode(OperatingMode.T2);
      untilStanding();
      double between = controller.axes().get(0);
      assertThat(between).isStrictlyBetween(0.0, 30.0);
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.SUCCESS);
      controller.emergencyStop(true);
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.ACCESS);
      controller.emergencyStop(false);
      controller.confirmAll();
      controller.step(SHORT);
      assertThat(controller.axes().get(0)).isEqualTo(between, within(1e-6));
    }
  }

  // type 12

  @Nested
  final class Keys {

    @Test
    void movesAnAxisWhileTheKeyIsPressed() throws IOException {
      assertThat(
              client.exchange(new PendantKeyRequest(1, Code.of(PendantKey.JOG), 1, 2, true, false)))
          .isEqualTo(
              new ProgramResponse(1, MessageType.PENDANT_KEY, PendantKey.JOG.code(), Tail.SUCCESS));
      controller.step(Duration.ofSeconds(2));
      assertThat(controller.standing()).isFalse();
      assertThat(release(PendantKey.JOG, 1)).isEqualTo(ErrorCode.SUCCESS);
      untilStanding();
      Axis there = controller.axes();
      assertThat(there.get(0)).isStrictlyBetween(1.0, controller.model().maximum(0));
      assertThat(there.with(0, 0)).isEqualTo(START);
      // the motion has ended
      controller.step(LONG);
      assertThat(controller.axes()).isEqualTo(there);
    }

    @Test
    void releasesAJogKeyWhenItsConnectionEnds() throws IOException {
      assertThat(press(PendantKey.JOG, 1, true)).isEqualTo(ErrorCode.SUCCESS);
      try (RawClient other = new RawClient(server)) {
        other.exchange(
            new PendantKeyRequest(1, Code.of(PendantKey.JOG), 99, 0, true, false)); // is refused
      }
      untilConnected(1);
      controller.step(SHORT);
      assertThat(controller.standing()).isFalse();

      client.close();
      untilConnected(0);
      untilStanding();
      assertThat(controller.axes().a1()).isStrictlyBetween(0.1, 30.0);
    }

    private void untilConnected(int count) {
      while (server.clientCount() != count) {
        Thread.onSpinWait();
      }
    }

    @Test
    void movesAnAxisToItsLimitAtMost() throws IOException {
      assertThat(press(PendantKey.JOG, 3, false)).isEqualTo(ErrorCode.SUCCESS);
      untilStanding();
      assertThat(controller.axes().get(2)).isEqualTo(controller.model().minimum(2), within(0.001));
      assertThat(release(PendantKey.JOG, 3)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.messages()).isEmpty();
    }

    @Test
    void takesTheJogOverride() throws IOException {
      server.variables().set("$OV_JOG", "0");
      assertThat(press(PendantKey.JOG, 1, true)).isEqualTo(ErrorCode.SUCCESS);
      controller.step(SHORT);
      assertThat(controller.axes()).isEqualTo(START);
    }

    @Test
    void goesOnWithTheKeyThatWasPressedLast() throws IOException {
      assertThat(press(PendantKey.JOG, 1, true)).isEqualTo(ErrorCode.SUCCESS);
      controller.step(SHORT);
      assertThat(move(MotionType.PTP, "{A1 0}")).isEqualTo(ErrorCode.ACCESS);
      assertThat(press(PendantKey.JOG, 6, false)).isEqualTo(ErrorCode.SUCCESS);
      controller.step(Duration.ofSeconds(2));
      double first = controller.axes().get(0);
      controller.step(SHORT);
      assertThat(controller.axes().get(0)).isEqualTo(first, within(1e-6));
      assertThat(controller.axes().get(5)).isNegative();
    }

    @Test
    void movesTheToolWithTheMouse() throws IOException {
      double x = tcp("X");
      double y = tcp("Y");
      assertThat(press(PendantKey.MOUSE, 2, false)).isEqualTo(ErrorCode.SUCCESS);
      controller.step(Duration.ofSeconds(3));
      assertThat(release(PendantKey.MOUSE, 2)).isEqualTo(ErrorCode.SUCCESS);
      untilStanding();
      assertThat(tcp("X")).isEqualTo(x, within(0.01));
      assertThat(tcp("Y")).isLessThan(y - 10);
    }

    @ParameterizedTest
    @EnumSource(names = {"JOG", "MOUSE"})
    void movesTheToolInTheDirectionsThatArePressed(PendantKey key) throws IOException {
      server.variables().set("$BASE", "{X 0,Y 0,Z 0,A 90,B 0,C 0}");
      controller.setJogCoordinates(JogCoordinates.WORLD);
      controller.step(SHORT);
      double x = tcp("X");
      double y = tcp("Y");
      // X of the world is -Y of the base
      assertThat(press(key, 1, false)).isEqualTo(ErrorCode.SUCCESS);
      controller.step(Duration.ofSeconds(2));
      assertThat(release(key, 1)).isEqualTo(ErrorCode.SUCCESS);
      untilStanding();
      assertThat(tcp("X")).isEqualTo(x, within(0.01));
      assertThat(tcp("Y")).isGreaterThan(y + 10);
    }

    @Test
    void turnsTheToolWithTheMouse() throws IOException {
      double x = tcp("X");
      String a = server.variables().get("$POS_ACT.A");
      assertThat(press(PendantKey.MOUSE, 4, true)).isEqualTo(ErrorCode.SUCCESS);
      controller.step(SHORT);
      assertThat(tcp("X")).isEqualTo(x, within(0.01));
      assertThat(server.variables().get("$POS_ACT.A")).isNotEqualTo(a);
    }

    @Test
    void standsAtTheEndOfTheReachWithoutAMessage() throws IOException {
      assertThat(press(PendantKey.MOUSE, 1, true)).isEqualTo(ErrorCode.SUCCESS);
      untilStanding();
      assertThat(controller.messages()).isEmpty();
      assertThat(press(PendantKey.JOG, 1, true)).isEqualTo(ErrorCode.SUCCESS);
    }

    @Test
    void jogsInT1AndT2Only() throws IOException {
      controller.setMode(OperatingMode.AUT);
      assertThat(press(PendantKey.JOG, 1, true)).isEqualTo(ErrorCode.ACCESS);
      assertThat(press(PendantKey.JOG, 0, true)).isEqualTo(ErrorCode.ARGUMENT);
      assertThat(press(PendantKey.MOUSE, 7, true)).isEqualTo(ErrorCode.ARGUMENT);
    }

    @Test
    void leavesAMotionAloneWhenAJogKeyIsReleased() throws IOException {
      assertThat(move(MotionType.PTP, "{A1 30}")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(release(PendantKey.JOG, 1)).isEqualTo(ErrorCode.SUCCESS);
      untilStanding();
      assertThat(controller.axes().get(0)).isEqualTo(30, within(1e-6));
    }

    @Test
    void holdsTheStartKeyInT1() throws IOException {
      putLoop();
      assertThat(select("WORK")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(press(PendantKey.START, 1, false)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
      assertThat(release(PendantKey.START, 1)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    }

    @Test
    void pressesTheStartKeyInAutAndStopsByTheStopKey() throws IOException {
      controller.setMode(OperatingMode.AUT);
      putLoop();
      assertThat(select("WORK")).isEqualTo(ErrorCode.SUCCESS);
      assertThat(press(PendantKey.START, 1, false)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(release(PendantKey.START, 1)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(release(PendantKey.STOP, 1)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.ACTIVE);
      assertThat(press(PendantKey.STOP, 1, false)).isEqualTo(ErrorCode.SUCCESS);
      assertThat(controller.robot().state()).isEqualTo(ProgramState.STOP);
    }

    @Test
    void doesNotRunBackwardsNorKnowOtherKeys() throws IOException {
      assertThat(press(PendantKey.START, 1, true)).isEqualTo(ErrorCode.NOT_IMPLEMENTED);
      assertThat(press(PendantKey.START, 5, false)).isEqualTo(ErrorCode.ARGUMENT);
      assertThat(press(PendantKey.STOP, 5, false)).isEqualTo(ErrorCode.ARGUMENT);
    }
  }
}
