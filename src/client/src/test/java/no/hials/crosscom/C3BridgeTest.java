package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.c3.BenchmarkResult;
import no.hials.crosscom.c3.BridgeInfo;
import no.hials.crosscom.c3.KeyAction;
import no.hials.crosscom.c3.PressedKey;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.MockServerConfig;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.program.ProgramRequest.MotionRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.PendantKeyRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Does what only C3 Bridge can, and finds out that it is there. */
class C3BridgeTest {
  private static final Duration LONG = Duration.ofSeconds(60);

  private MockServer robot;
  private CrossComClient client;

  @BeforeEach
  void connect() throws Exception {
    start(cfg -> {});
  }

  @AfterEach
  void disconnect() throws Exception {
    client.close();
    robot.close();
  }

  private void start(Consumer<MockServerConfig.Builder> settings) throws Exception {
    robot =
        MockServer.start(
            cfg -> {
              cfg.server(ServerType.C3_BRIDGE);
              settings.accept(cfg);
            });
    client =
        new CrossComClient(
            ClientConfig.create(
                robot.host(),
                cfg -> cfg.port(robot.port()).requestTimeout(LONG).keepAlive(Duration.ZERO)));
  }

  private void restart(Consumer<MockServerConfig.Builder> settings) throws Exception {
    disconnect();
    start(settings);
  }

  private List<MessageType> types() {
    return robot.requests().stream().map(r -> r.request().type()).toList();
  }

  private List<String> names() {
    return robot.requests().stream().map(RecordedRequest::name).toList();
  }

  private <R extends Request> List<R> requests(Class<R> type) {
    return robot.requests().stream()
        .map(RecordedRequest::request)
        .filter(type::isInstance)
        .map(type::cast)
        .toList();
  }

  private static List<KRLVariable> ints(int count) {
    List<KRLVariable> variables = new ArrayList<>();
    IntStream.range(0, count)
        .forEach(i -> variables.add(new KRLInt("MYINTS[" + (i % 10 + 1) + "]")));
    return variables;
  }

  // --- which server there is

  @Test
  void theServerIsAskedForWhatItIsOnceForEachConnection() throws Exception {
    Server server = client.getServer();

    assertThat(server.type()).isEqualTo(ServerType.C3_BRIDGE);
    assertThat(server.version()).isEqualTo(new Version(1, 4, 0));
    assertThat(server.knows(MessageType.MOTION)).isTrue();
    assertThat(server.knows(MessageType.READ_ARRAY)).isFalse();
    assertThat(client.async(c -> c.getServer()).get()).isEqualTo(server);
    assertThat(types()).containsExactly(MessageType.READ, MessageType.READ, MessageType.FEATURES);

    robot.disconnectClients();
    robot.clearRequests();
    client.readVariables(ints(2));

    // not always first: a client that finds out by sending the batch has sent it again by then
    assertThat(names()).as("another server could be there").contains("@PROXY_TYPE");
  }

  @Test
  void aKukavarproxyIsKnownByItsSilence() throws Exception {
    restart(cfg -> cfg.server(ServerType.KUKAVARPROXY));
    Server server = client.getServer();

    assertThat(server.type()).isEqualTo(ServerType.KUKAVARPROXY);
    assertThat(server.version()).isNull();
    assertThat(server.knows(MessageType.READ_ARRAY)).isTrue();
    assertThat(server.knows(MessageType.READ_UTF16)).isFalse();
    assertThat(names()).containsExactly("@PROXY_TYPE");
  }

  @Test
  void whatIsPlainNeedsNoQuestion() throws Exception {
    KRLInt i = new KRLInt("MYINT");
    client.readVariable(i);
    client.writeVariable(i);
    client.readVariables(i);
    client.writeVariables(i);

    assertThat(names()).containsOnly("MYINT").hasSize(4);
  }

  // --- several variables

  @Test
  void tenVariablesTakeOneRoundTrip() throws Exception {
    client.getServer();
    robot.clearRequests();
    IntStream.rangeClosed(1, 10).forEach(i -> robot.variables().set("MYINTS[" + i + "]", "" + i));
    List<KRLVariable> variables = ints(10);

    assertThat(client.readVariables(variables)).allMatch(VariableResult::isOk);

    assertThat(types()).containsExactly(MessageType.READ_MULTIPLE);
    assertThat(variables)
        .extracting(KRLVariable::getValue)
        .containsExactly(1, 2, 3, 4, 5, 6, 7, 8, 9, 10);
    assertThat(variables).allMatch(v -> v.getReadTimeNano() > 0);
  }

  @Test
  void detectionForABatchTakesTwoReadsAndNoMore() throws Exception {
    client.readVariables(ints(2));
    client.readVariables(ints(2));

    assertThat(types())
        .containsExactly(
            MessageType.READ,
            MessageType.READ,
            MessageType.READ_MULTIPLE,
            MessageType.READ_MULTIPLE);
  }

  @Test
  void eachItemHasItsOwnCode() throws Exception {
    KRLInt good = new KRLInt("MYINT");
    KRLInt unknown = new KRLInt("NOSUCHVAR");
    KRLInt readOnly = new KRLInt("$POS_ACT.X");
    Stream.of(good, unknown, readOnly).forEach(v -> v.setValue(3));

    List<VariableResult> results = client.writeVariables(good, unknown, readOnly);

    assertThat(results).extracting(VariableResult::isOk).containsExactly(true, false, false);
    assertThat(codeOf(results.get(1))).contains(ErrorCode.GENERAL);
    assertThat(codeOf(results.get(2))).contains(ErrorCode.ACCESS);
    assertThat(robot.variables().get("MYINT")).isEqualTo("3");
    assertThat(types()).endsWith(MessageType.WRITE_MULTIPLE).doesNotContain(MessageType.WRITE);
  }

  private static Optional<ErrorCode> codeOf(VariableResult result) {
    return ((CrossComAccessException) result.failure()).getErrorCode();
  }

  @Test
  void aMessageHas255VariablesAtMost() throws Exception {
    List<KRLVariable> variables = ints(511);

    assertThat(client.readVariables(variables)).hasSize(511).allMatch(VariableResult::isOk);
    assertThat(client.writeVariables(variables)).hasSize(511).allMatch(VariableResult::isOk);

    assertThat(robot.requests())
        .extracting(r -> r.names().size())
        .containsExactly(1, 1, 255, 255, 1, 255, 255, 1);
  }

  @Test
  void aMessageIsNoLongerThanAFrame() throws Exception {
    // 10 names of 4,000 characters are 80,040 bytes in UTF-16
    List<KRLVariable> variables = new ArrayList<>();
    IntStream.range(0, 10).forEach(i -> variables.add(new KRLInt("A" + i + "B".repeat(3998))));

    assertThat(client.readVariables(variables))
        .extracting(VariableResult::failure)
        .hasSize(10)
        .hasOnlyElementsOfType(CrossComAccessException.class);
    assertThat(robot.requests()).extracting(r -> r.names().size()).containsExactly(1, 1, 8, 2);
  }

  @Test
  void anAnswerThatIsTooLongIsAskedForInParts() throws Exception {
    robot.faults(
        r ->
            r.names().size() > 3
                ? Optional.of(Fault.raw(hexId(r) + " 00 05 06 00 00 0A 00"))
                : Optional.empty());

    assertThat(client.readVariables(ints(10))).allMatch(VariableResult::isOk);

    assertThat(robot.requests())
        .extracting(r -> r.names().size())
        .as("10 is halved until 3 and 2 fit")
        .containsExactly(1, 1, 10, 5, 2, 3, 5, 2, 3);
  }

  private static String hexId(RecordedRequest request) {
    int id = request.request().id();
    return String.format("%02X %02X", id >> 8, id & 0xFF);
  }

  @Test
  void aWriteThatIsNotAnsweredForEachItemHasAnUnknownOutcome() throws Exception {
    robot.faults(
        r ->
            r.request().type() == MessageType.WRITE_MULTIPLE
                ? Optional.of(Fault.raw(hexId(r) + " 00 05 07 00 00 09 00"))
                : Optional.empty());
    KRLInt a = new KRLInt("MYINT");
    a.setValue(1);
    List<VariableResult> results = client.writeVariables(a, a);

    assertThat(results)
        .extracting(VariableResult::failure)
        .hasOnlyElementsOfType(CrossComProtocolException.class)
        .allMatch(CrossComException::isOutcomeUnknown);
  }

  @Test
  void olderVersionsAreAskedOneByOne() throws Exception {
    restart(cfg -> cfg.version(new Version(1, 2, 0)));
    List<KRLVariable> variables = ints(3);
    client.readVariables(variables);
    client.writeVariables(variables);

    assertThat(types().subList(2, 3)).containsExactly(MessageType.READ_MULTIPLE);
    assertThat(types().subList(3, 6)).containsOnly(MessageType.WRITE);

    for (Version old : List.of(new Version(1, 0, 0), new Version(1, 1, 0), new Version(1, 1, 2))) {
      restart(cfg -> cfg.version(old));
      List<KRLVariable> several = ints(3);
      assertThat(client.readVariables(several)).allMatch(VariableResult::isOk);
      assertThat(client.writeVariables(several)).allMatch(VariableResult::isOk);
      assertThat(types()).containsOnly(MessageType.READ, MessageType.WRITE);
    }
  }

  @Test
  void aReadOfSeveralIsRepeatedOnANewConnectionAndAWriteIsNot() throws Exception {
    client.getServer();
    robot.enqueue(Fault.closeBefore());
    List<KRLVariable> variables = ints(3);
    assertThat(client.readVariables(variables)).allMatch(VariableResult::isOk);

    robot.clearRequests();
    robot.fault(r -> r.request().type() == MessageType.WRITE_MULTIPLE, Fault.closeBefore());
    List<VariableResult> results = client.writeVariables(variables);

    assertThat(results)
        .extracting(VariableResult::failure)
        .hasOnlyElementsOfType(CrossComConnectionLostException.class)
        .allMatch(CrossComException::isOutcomeUnknown);
    assertThat(results.get(0).failure())
        .hasMessageContaining("broke during the write of MYINTS[1] and 2 more")
        .hasMessageContaining("the outcome is unknown");
    assertThat(types()).containsOnlyOnce(MessageType.WRITE_MULTIPLE);
  }

  @Test
  void aFailureWithoutABadResultIsNotTakenForSuccess() throws Exception {
    client.getServer();
    List<KRLVariable> variables = ints(2);
    robot.enqueue(Fault.answer("", Tail.FAILURE));
    assertThat(client.readVariables(variables)).allMatch(VariableResult::isOk);

    robot.enqueue(Fault.answer("", Tail.FAILURE));
    assertThat(client.writeVariables(variables))
        .extracting(VariableResult::failure)
        .hasOnlyElementsOfType(CrossComProtocolException.class)
        .allMatch(CrossComException::isOutcomeUnknown);
  }

  @Test
  void textsBeyondLatin1AreReadAndWrittenTogether() {
    KRLString text = new KRLString("MYSTRING[]");
    text.setValue("5 €");
    KRLInt i = new KRLInt("MYINT");
    i.setValue(4);

    assertThat(client.writeVariables(text, i)).allMatch(VariableResult::isOk);
    text.setValue("other");
    assertThat(client.readVariables(text, i)).allMatch(VariableResult::isOk);
    assertThat(text.getValue()).isEqualTo("5 €");
  }

  // --- what KUKAVARPROXY cannot

  /** Does something that needs C3 Bridge. */
  private interface Need {
    void on(CrossComClient client) throws Exception;
  }

  static Stream<Need> needs() {
    KRLPos target = new KRLPos("TARGET");
    target.setX(1);
    KRLAxis axes = new KRLAxis("TARGET");
    axes.setA1(1);
    return Stream.of(
        c -> c.programs().start(Interpreter.ROBOT),
        c -> c.programs().select("/R1/MAIN"),
        c -> c.motion().ptp(target),
        c -> c.asyncRun(it -> it.motion().lin(target)).get(),
        c -> c.asyncRun(it -> it.motion().ptpRel(axes)).get(),
        c -> c.pendant().press(KeyAction.stop(Interpreter.ROBOT)),
        c -> c.pendant().hold(KeyAction.jog(1, 2, true)).close(),
        c -> c.information().get(),
        c -> c.information().features(),
        c -> c.information().benchmarkRead(1, List.of("MYINT")),
        c -> c.asyncRun(it -> it.information().confirmAll()).get());
  }

  @ParameterizedTest
  @MethodSource("needs")
  void aKukavarproxySaysThatItCannotBeforeAnythingIsSent(Need need) throws Exception {
    restart(cfg -> cfg.server(ServerType.KUKAVARPROXY));
    Throwable thrown = null;
    try {
      need.on(client);
    } catch (ExecutionException e) {
      thrown = e.getCause();
    } catch (Exception e) {
      thrown = e;
    }

    assertThat(thrown)
        .isInstanceOf(CrossComUnsupportedException.class)
        .hasMessageContaining("it needs C3 Bridge Interface 1.")
        .hasMessageContaining("the server is KUKAVARPROXY");
    assertThat(((CrossComUnsupportedException) thrown).getServer())
        .isEqualTo(ServerType.KUKAVARPROXY);
    assertThat(names()).containsExactly("@PROXY_TYPE");
    assertThat(client.readText("MYINT")).as("the connection is usable").isEqualTo("0");
  }

  // --- programs

  @Test
  void aProgramIsSelectedStartedStoppedResetAndCancelled() throws Exception {
    robot.controller().load("WORK.SRC", "DEF WORK()\nLOOP\nWAIT SEC 1\nENDLOOP\nEND\n");
    robot.controller().setMode(OperatingMode.AUT);

    client.programs().select("/R1/WORK");
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_RESET");
    client.programs().start(Interpreter.ROBOT);
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_ACTIVE");
    client.programs().stop(Interpreter.ROBOT);
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_STOP");
    client.programs().reset(Interpreter.ROBOT);
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_RESET");
    client.programs().cancel(Interpreter.ROBOT);
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_FREE");

    client.asyncRun(c -> c.programs().run("/R1/WORK", "", true)).get();
    assertThat(client.readText("$PRO_STATE1")).isEqualTo("#P_ACTIVE");
    client.asyncRun(c -> c.programs().stop(Interpreter.ROBOT)).get();
    client.asyncRun(c -> c.programs().reset(Interpreter.ROBOT)).get();
    client.asyncRun(c -> c.programs().cancel(Interpreter.ROBOT)).get();
    client.asyncRun(c -> c.programs().select("WORK")).get();
    client.asyncRun(c -> c.programs().start(Interpreter.ROBOT)).get();
    client.programs().stop(Interpreter.ROBOT);
    client.asyncRun(c -> c.programs().select("WORK", "", true)).get();
    client.programs().run("WORK");
    client.programs().stop(Interpreter.ROBOT);
    client.asyncRun(c -> c.programs().run("WORK")).get();

    assertThat(requests(ProgramSelectRequest.class).get(0))
        .isEqualTo(
            new ProgramSelectRequest(
                requests(ProgramSelectRequest.class).get(0).id(),
                no.hials.crosscom.protocol.code.Code.of(
                    no.hials.crosscom.protocol.code.ProgramCommand.SELECT),
                no.hials.crosscom.protocol.code.Code.of(Interpreter.SUBMIT),
                "/R1/WORK",
                "",
                false));
  }

  @Test
  void aRefusedCommandSaysTheServersCodeInWords() throws Exception {
    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> client.programs().select("/R1/NOSUCH"))
        .withMessage(
            "the server refused the selection of program /R1/NOSUCH: code 0 (GENERAL: no reason"
                + " given)")
        .satisfies(e -> assertThat(e.getErrorCode()).contains(ErrorCode.GENERAL))
        .satisfies(e -> assertThat(e.getCode()).isZero())
        .satisfies(e -> assertThat(e.getCommand()).isEqualTo("selection of program /R1/NOSUCH"))
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
    assertThatIllegalArgumentException().isThrownBy(() -> client.programs().select(" "));
    assertThat(client.readText("MYINT")).as("the connection is usable").isEqualTo("0");
  }

  @Test
  void aRefusalOfEmptyParametersByVersion10HasAHint() throws Exception {
    restart(cfg -> cfg.version(new Version(1, 0, 0)));
    String hint = "; C3 Bridge 1.0 needs parameters that are not empty";
    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> client.programs().select("MAIN"))
        .withMessageEndingWith("malformed)" + hint);
    assertThatExceptionOfType(CrossComRefusedException.class)
        .isThrownBy(() -> client.programs().run("MAIN", "1", false))
        .withMessageNotContaining(hint);
  }

  @Test
  void aCommandWhoseConnectionBreaksIsNotRepeatedAndItsOutcomeUnknown() throws Exception {
    client.getServer();
    robot.enqueue(Fault.closeBefore());

    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(() -> client.programs().stop(Interpreter.SUBMIT))
        .withMessageContaining("broke during the stop of the submit interpreter's program")
        .withMessageContaining("may or may not have done it")
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
    assertThat(requests(ProgramControlRequest.class)).hasSize(1);
  }

  @Test
  void aCommandIsSentOnceEvenIfTheQuestionForTheServerIsRepeated() throws Exception {
    robot.enqueue(Fault.closeBefore());
    client.programs().stop(Interpreter.ROBOT);

    assertThat(names()).startsWith("@PROXY_TYPE", "@PROXY_TYPE");
    assertThat(requests(ProgramControlRequest.class)).hasSize(1);
  }

  // --- motions

  @Test
  void aMotionSendsOnlyTheFieldsThatHaveAValue() throws Exception {
    KRLFrame offset = new KRLFrame("OFFSET");
    offset.setX(1.5);
    offset.setZ(-2);
    KRLAxis axes = new KRLAxis("OFFSET");
    axes.setA3(5);
    List<Need> motions =
        List.of(
            c -> c.motion().ptp(offset),
            c -> c.motion().ptp(axes),
            c -> c.motion().lin(offset),
            c -> c.motion().ptpRel(offset),
            c -> c.motion().ptpRel(axes),
            c -> c.motion().linRel(offset),
            c -> c.asyncRun(it -> it.motion().ptp(offset)).get(),
            c -> c.asyncRun(it -> it.motion().ptp(axes)).get(),
            c -> c.asyncRun(it -> it.motion().lin(offset)).get(),
            c -> c.asyncRun(it -> it.motion().ptpRel(offset)).get(),
            c -> c.asyncRun(it -> it.motion().ptpRel(axes)).get(),
            c -> c.asyncRun(it -> it.motion().linRel(offset)).get());
    for (Need motion : motions) {
      try {
        motion.on(client);
      } catch (CrossComRefusedException | ExecutionException e) {
        // whether the robot can is not what this is about
        assertThat(e).hasMessageContaining("refused");
      }
    }

    assertThat(requests(MotionRequest.class))
        .extracting(r -> r.motion().known().orElseThrow() + " " + r.position())
        .containsExactly(
            "PTP {X 1.5,Z -2.0}",
            "PTP {A3 5.0}",
            "LIN {X 1.5,Z -2.0}",
            "PTP_REL {X 1.5,Z -2.0}",
            "PTP_REL {A3 5.0}",
            "LIN_REL {X 1.5,Z -2.0}",
            "PTP {X 1.5,Z -2.0}",
            "PTP {A3 5.0}",
            "LIN {X 1.5,Z -2.0}",
            "PTP_REL {X 1.5,Z -2.0}",
            "PTP_REL {A3 5.0}",
            "LIN_REL {X 1.5,Z -2.0}");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.motion().ptp(new KRLPos("NOWHERE")))
        .withMessage("NOWHERE has no position: none of its fields was set or read");
  }

  @Test
  void theRobotMoves() throws Exception {
    restart(cfg -> cfg.clock(SimulationClock.stepped()));
    robot.controller().setMode(OperatingMode.AUT);
    KRLAxis target = new KRLAxis("TARGET");
    target.setA1(20);
    client.motion().ptp(target);

    robot.controller().step(Duration.ofMillis(100));
    assertThat(robot.controller().stepUntil(robot.controller()::standing, LONG)).isTrue();
    assertThat(client.readJointAngles()[0])
        .isCloseTo(20, org.assertj.core.data.Offset.offset(0.01));
    assertThat(requests(MotionRequest.class).get(0).motion().is(MotionType.PTP)).isTrue();
  }

  // --- keys

  private List<Boolean> releases() {
    return requests(PendantKeyRequest.class).stream().map(PendantKeyRequest::released).toList();
  }

  @Test
  @SuppressWarnings("try") // closed twice on purpose
  void aHeldKeyIsReleasedOnceWhenTheBlockEnds() throws Exception {
    KeyAction jog = KeyAction.jog(3, 2, true);
    try (PressedKey key = client.pendant().hold(jog)) {
      assertThat(key.key()).isEqualTo(jog);
      assertThat(releases()).containsExactly(false);
      key.close();
    }
    assertThat(releases()).containsExactly(false, true);
    assertThat(requests(PendantKeyRequest.class))
        .allMatch(r -> r.number() == 3 && r.keyCode() == 2 && r.direction());

    PressedKey held = client.async(c -> c.pendant().hold(jog)).get();
    client.asyncRun(c -> held.close()).get();
    client.asyncRun(c -> c.pendant().press(jog)).get();
    client.asyncRun(c -> c.pendant().release(jog)).get();
    assertThat(releases()).containsExactly(false, true, false, true, false, true);
  }

  @Test
  void aHeldKeyIsReleasedWhenTheBlockFailsOrTheThreadIsInterrupted() throws Exception {
    assertThatExceptionOfType(IllegalStateException.class)
        .isThrownBy(
            () -> {
              try (PressedKey key = client.pendant().hold(KeyAction.jog(1, 2, false))) {
                Thread.currentThread().interrupt();
                throw new IllegalStateException("on purpose with " + key.key());
              }
            });
    assertThat(Thread.interrupted()).as("the flag is kept").isTrue();
    assertThat(releases()).containsExactly(false, true);
  }

  @Test
  void aKeyOfWhichNobodyKnowsIsReleased() throws Exception {
    client.getServer();
    robot.enqueue(Fault.closeBefore());

    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(() -> client.pendant().hold(KeyAction.jog(1, 2, true)))
        .satisfies(e -> assertThat(e.getSuppressed()).isEmpty());
    assertThat(releases()).containsExactly(false, true);
  }

  @Test
  void aReleaseThatNobodyKnowsOfIsDoneOnceMore() throws Exception {
    PressedKey key = client.pendant().hold(KeyAction.jog(1, 2, true));
    robot.enqueue(Fault.closeBefore());
    key.close();

    assertThat(releases()).containsExactly(false, true, true);
  }

  @Test
  void theKeysAreThoseOfTheVectors() throws Exception {
    assertThat(KeyAction.start(Interpreter.ROBOT).toString())
        .isEqualTo("key START (number 1, key code 0, direction 0)");
    assertThat(KeyAction.startBackward(Interpreter.ROBOT).direction()).isTrue();
    assertThat(KeyAction.mouse(2, 0, true).toString())
        .isEqualTo("key MOUSE (number 2, key code 0, direction 1)");
  }

  // --- information

  @Test
  void theServerTellsOfItself() throws Exception {
    Instant now = Instant.parse("2026-03-04T05:06:07.089Z");
    robot.faults(
        r ->
            r.request().type() == MessageType.INFORMATION
                ? Optional.of(
                    Fault.raw(
                        hexId(r)
                            + " 00 1D 0D 01 04 09 07 EA 00 03 00 03 00 04 00 05 00 06 00 07 00 59"
                            + " 00 02 56 00 4D 00 00 01 01"))
                : Optional.empty());

    BridgeInfo info = client.information().get();
    assertThat(info.version()).isEqualTo(new Version(1, 4, 0));
    assertThat(info.build().known()).isEmpty();
    assertThat(info.build().number()).isEqualTo(9);
    assertThat(info.clock()).isEqualTo(now);
    assertThat(info.host()).isEqualTo("VM");

    robot.clearFaults();
    assertThat(client.async(c -> c.information().get()).get().build().known())
        .contains(BuildType.OPEN_SOURCE);
  }

  @Test
  void featuresBenchmarksAndConfirmation() throws Exception {
    assertThat(client.information().features()).isEqualTo(client.getServer().features());
    assertThat(client.async(c -> c.information().features()).get())
        .isEqualTo(client.getServer().features());

    BenchmarkResult read = client.information().benchmarkRead(3, List.of("MYINT", "MYBOOL"));
    assertThat(read.variables()).isEqualTo(2);
    assertThat(read.iterations()).isEqualTo(3);
    assertThat(read.duration()).isBetween(Duration.ZERO, LONG);
    assertThat(
            client.async(c -> c.information().benchmarkRead(3, List.of("MYINT"))).get().variables())
        .isEqualTo(1);
    client.information().benchmarkWrite(1, Map.of("MYINT", "77"));
    assertThat(robot.variables().get("MYINT")).isEqualTo("77");
    client.async(c -> c.information().benchmarkWrite(1, Map.of("MYINT", "78"))).get();
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.information().benchmarkRead(1, List.of()))
        .withMessage("a benchmark must have 1 to 10 variables, has 0");

    client.information().confirmAll();
    client.asyncRun(c -> c.information().confirmAll()).get();
    assertThat(types()).endsWith(MessageType.CONFIRM_ALL, MessageType.CONFIRM_ALL);
  }
}
