package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.Version;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.CopyFlag;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.code.ListFlag;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.BeginWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.ContentRequest;
import no.hials.crosscom.protocol.file.FileRequest.CopyFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.DeleteFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.FileNameRequest;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ListDirectoryResponse;
import no.hials.crosscom.protocol.file.FileResponse.ReadDataResponse;
import no.hials.crosscom.protocol.file.FileResponse.WriteDataResponse;
import no.hials.crosscom.protocol.program.ProgramRequest.MotionRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.PendantKeyRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.protocol.server.ServerRequest;
import no.hials.crosscom.protocol.server.ServerResponse.FeaturesResponse;
import no.hials.crosscom.protocol.server.ServerResponse.InformationResponse;
import no.hials.crosscom.protocol.variable.AccessResult;
import no.hials.crosscom.protocol.variable.Assignment;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.BenchmarkWriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadUtf16Request;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteUtf16Request;
import no.hials.crosscom.protocol.variable.VariableResponse.BenchmarkResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.Refusal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the behaviour of C3 Bridge beyond the measured rows. */
final class C3BridgeTest {
  private MockServer server;
  private RawClient client;

  @BeforeEach
  void start() throws IOException {
    start(cfg -> {});
  }

  private void start(Consumer<MockServerConfig.Builder> changes) throws IOException {
    server = MockServer.start(cfg -> changes.accept(cfg.server(ServerType.C3_BRIDGE)));
    client = new RawClient(server);
  }

  private void restart(Consumer<MockServerConfig.Builder> changes) throws IOException {
    stop();
    start(changes);
  }

  @AfterEach
  void stop() throws IOException {
    client.close();
    server.close();
  }

  private TextResponse text(Request request) throws IOException {
    return (TextResponse) client.exchange(request);
  }

  private MultipleResponse several(Request request) throws IOException {
    return (MultipleResponse) client.exchange(request);
  }

  private static AccessResult result(ErrorCode code, String value) {
    return new AccessResult(Code.of(code), value);
  }

  // variables

  @Test
  void readsSeveralVariablesInOneRequestEachWithItsCode() throws IOException {
    assertThat(several(new ReadMultipleRequest(1, List.of("$OV_PRO", "NOPE", "", "PING"))))
        .isEqualTo(
            new MultipleResponse(
                1,
                MessageType.READ_MULTIPLE,
                List.of(
                    result(ErrorCode.SUCCESS, server.variables().get("$OV_PRO")),
                    result(ErrorCode.GENERAL, ""),
                    result(ErrorCode.ARGUMENT, ""),
                    result(ErrorCode.SUCCESS, "PONG")),
                Tail.FAILURE_ZERO));
    assertThat(server.requests())
        .singleElement()
        .satisfies(
            request -> {
              assertThat(request.names()).containsExactly("$OV_PRO", "NOPE", "", "PING");
              assertThat(request.name()).isEmpty();
              assertThat(request.isWrite()).isFalse();
              assertThat(request.refusal()).isEqualTo(Refusal.UNKNOWN_VARIABLE);
            });
  }

  @Test
  void readsNoVariablesInOneRequestToo() throws IOException {
    assertThat(several(new ReadMultipleRequest(1, List.of())))
        .isEqualTo(new MultipleResponse(1, MessageType.READ_MULTIPLE, List.of(), Tail.SUCCESS));
  }

  @Test
  void givesBackWhatTheControllerHasAfterAWriteOfSeveral() throws IOException {
    MultipleResponse answer =
        several(
            new WriteMultipleRequest(
                1,
                List.of(
                    new Assignment("MYPOS", "{X 5}"),
                    new Assignment("$POS_ACT", "{X 5}"),
                    new Assignment("MYPOS", "{X 5" + " ".repeat(255) + "}"))));
    assertThat(answer.results())
        .containsExactly(
            result(ErrorCode.SUCCESS, server.variables().get("MYPOS")),
            result(ErrorCode.ACCESS, "{X 5}"),
            result(ErrorCode.GENERAL, "{X 5" + " ".repeat(255) + "}"));
    assertThat(answer.tail()).isEqualTo(Tail.FAILURE_ZERO);
    assertThat(server.variables().get("MYPOS.X")).isEqualTo("5.00000");
    assertThat(server.requests().get(0).isWrite()).isTrue();
    assertThat(server.requests().get(0).names()).containsExactly("MYPOS", "$POS_ACT", "MYPOS");
  }

  @Test
  void echoesInASingleWriteWhatWasSent() throws IOException {
    assertThat(text(new WriteUtf16Request(1, "MYPOS", "{X 5}")))
        .isEqualTo(new TextResponse(1, MessageType.WRITE_UTF16, "{X 5}", Tail.SUCCESS));
    assertThat(client.write("MYPOS", "{X 6}"))
        .isEqualTo(new ValueResponse(8, MessageType.WRITE, "{X 6}", Tail.SUCCESS));
    assertThat(server.requests())
        .extracting(RecordedRequest::name, RecordedRequest::value, RecordedRequest::isWrite)
        .containsExactly(tuple("MYPOS", "{X 5}", true), tuple("MYPOS", "{X 6}", true));
  }

  @Test
  void staysWrittenWhenTheAnswerIsTooLong() throws IOException {
    server.variables().declareStruc("STRUC LONGTYPE INT N, CHAR TEXT[40000]");
    server.variables().declare("LONG", "LONGTYPE", "{N 1,TEXT[] \"" + "x".repeat(40_000) + "\"}");
    assertThat(several(new WriteMultipleRequest(1, List.of(new Assignment("LONG", "{N 2}")))))
        .isEqualTo(new MultipleResponse(1, MessageType.WRITE_MULTIPLE, List.of(), new Tail(10, 0)));
    assertThat(server.variables().get("LONG.N")).isEqualTo("2");
    assertThat(server.requests().get(0).refusal()).isEqualTo(Refusal.TOO_LONG);
  }

  @Test
  void closesTheConnectionInsteadOfAnAnswerThatIsTooLong() throws IOException {
    server.variables().declareStruc("STRUC LONGTYPE CHAR TEXT[40000]");
    server.variables().declare("LONG", "LONGTYPE", "{TEXT[] \"" + "x".repeat(40_000) + "\"}");
    assertThat(client.read("LONG").tail()).isEqualTo(Tail.SUCCESS);
    assertThatThrownBy(() -> client.exchange(new ReadUtf16Request(1, "LONG")))
        .hasMessage("the server closed the connection");
    assertThat(server.requests().get(1).refusal()).isEqualTo(Refusal.TOO_LONG);
  }

  @Test
  void carriesTextsInItsCodePageInMessages0And1AndExactlyInTheOthers() throws IOException {
    server.variables().declare("MYTEXT[3]", "CHAR", "\"x\"");
    assertThat(text(new WriteUtf16Request(1, "MYTEXT[]", "\"\u20AC\u00C4\"")).tail())
        .isEqualTo(Tail.SUCCESS);
    assertThat(text(new ReadUtf16Request(2, "MYTEXT[]")).text()).isEqualTo("\"\u20AC\u00C4\"");
    assertThat(client.read("MYTEXT[]").value()).isEqualTo("\"\u0080\u00C4\"");
    assertThat(text(new WriteUtf16Request(3, "MYTEXT[]", "\"\u0141\u4F60\"")).tail())
        .isEqualTo(Tail.SUCCESS);
    assertThat(text(new ReadUtf16Request(4, "MYTEXT[]")).text()).isEqualTo("\"\u0141\u4F60\"");
    assertThat(client.read("MYTEXT[]").value()).isEqualTo("\"L?\"");
  }

  @Test
  void storesOtherCharactersThanTheClientMeantOnAChineseWindows() throws IOException {
    restart(cfg -> cfg.codePage(936));

    assertThat(client.write("MYSTRING[]", "\"Gr\u00F6\u00DFe\"").value())
        .isEqualTo("\"Gr\u00F6\u00DFe\"");
    assertThat(server.variables().get("MYSTRING[]")).isEqualTo("\"Gr\u9C9Ee\"");
    assertThat(client.write("MYSTRING[]", "\"\u00F6\"").tail())
        .as("the closing quote is lost")
        .isEqualTo(Tail.FAILURE_ZERO);
    server.variables().set("MYSTRING[]", "\"\u4F60\u597D\"");
    assertThat(client.read("MYSTRING[]").value()).isEqualTo("\"\u00C4\u00E3\u00BA\u00C3\"");
  }

  @Test
  void ignoresBytesBehindTheFields() throws IOException {
    client.send("00 01 00 09 00 00 04 50 49 4E 47 AA BB");
    assertThat(client.response())
        .isEqualTo(new ValueResponse(1, MessageType.READ, "PONG", Tail.SUCCESS));
  }

  // internal variables

  @Test
  void saysWhatItIs() throws IOException {
    assertThat(client.read("@PROXY_TYPE").value()).isEqualTo("C3 BRIDGE INTERFACE");
    assertThat(client.read("@PROXY_HOSTNAME").value()).isEqualTo("KRC4");
    assertThat(client.read("@PROXY_ENABLED").value()).isEqualTo("TRUE");
    assertThat(Instant.parse(client.read("@PROXY_TIME").value()))
        .isBetween(Instant.now().minusSeconds(60), Instant.now());
    assertThat(text(new WriteUtf16Request(1, "@PROXY_TYPE", "X")).tail())
        .isEqualTo(Tail.FAILURE_ZERO);
  }

  @Test
  void hasItsOwnNamesInCapitalLettersOnly() throws IOException {
    assertThat(client.read("@proxy_type"))
        .isEqualTo(new ValueResponse(7, MessageType.READ, "", Tail.FAILURE_ZERO));
    assertThat(text(new ReadUtf16Request(1, "@Proxy_Type")))
        .isEqualTo(new TextResponse(1, MessageType.READ_UTF16, "", Tail.FAILURE_ZERO));
  }

  @Test
  void asksTheControllerFirst() throws IOException {
    server.variables().declare("PING", "INT", "3");
    assertThat(client.read("PING").value()).isEqualTo("3");
  }

  @Test
  void hasNoPingIfToldSo() throws IOException {
    restart(cfg -> cfg.ping(false).trimValues(true));
    assertThat(client.read("PING"))
        .isEqualTo(new ValueResponse(7, MessageType.READ, "", Tail.FAILURE_ZERO));
    assertThat(client.read("@PROXY_TYPE").tail()).isEqualTo(Tail.SUCCESS);
    assertThat(client.read("$TORQUE_AXIS_ACT[]").value()).doesNotEndWith(" ");
  }

  @Test
  void givesItsVersionAndTheTime() throws IOException {
    InformationResponse answer =
        (InformationResponse) client.exchange(new ServerRequest(1, MessageType.INFORMATION));
    assertThat(answer.information().version()).isEqualTo(new Version(1, 4, 0));
    assertThat(answer.information().time().instant().orElseThrow())
        .isBetween(Instant.now().minusSeconds(60), Instant.now());
  }

  // older versions

  @Test
  void doesNotKnowInAnOlderVersionWhatCameLater() throws IOException {
    restart(cfg -> cfg.version(new Version(1, 1, 0)));
    assertThat(client.read("@PROXY_VERSION").value()).isEqualTo("1.1 (OPEN SOURCE)");
    FeaturesResponse features =
        (FeaturesResponse) client.exchange(new ServerRequest(1, MessageType.FEATURES));
    assertThat(features.features().types())
        .containsExactly(0, 1, 4, 5, 6, 7, 10, 11, 12, 13, 14, 63);
    assertThatThrownBy(() -> client.exchange(new BenchmarkReadRequest(2, 1, List.of("PING"))))
        .hasMessage("the server closed the connection");
    try (RawClient other = new RawClient(server)) {
      // a malformed request of type 20
      other.send("00 01 00 01 14");
      assertThat(other.receiveAll()).isEmpty();
    }
    assertThat(server.requests()).last().satisfies(r -> assertThat(r.request()).isNull());
  }

  @Test
  void hasInAnOlderVersionTheMessagesForSeveralVariablesWithMistakes() throws IOException {
    restart(cfg -> cfg.version(new Version(1, 2, 0)));
    assertThat(several(new ReadMultipleRequest(1, List.of("PING"))).tail()).isEqualTo(Tail.SUCCESS);
    assertThat(several(new WriteMultipleRequest(2, List.of(new Assignment("MYINT", "7")))))
        .isEqualTo(new MultipleResponse(2, MessageType.WRITE_MULTIPLE, List.of(), new Tail(7, 0)));
    assertThat(server.variables().get("MYINT")).isEqualTo("0");
    restart(cfg -> cfg.version(new Version(1, 1, 2)));
    assertThat(several(new ReadMultipleRequest(1, List.of("PING"))))
        .isEqualTo(new MultipleResponse(1, MessageType.READ_MULTIPLE, List.of(), new Tail(7, 0)));
    assertThat(client.exchange(new FileNameRequest(3, MessageType.FULL_NAME, "/R1")))
        .isInstanceOf(TextResponse.class);
  }

  // benchmark

  @Test
  void reallyAccessesTheVariablesOfABenchmark() throws IOException {
    List<String> names = new ArrayList<>(Collections.nCopies(10, "MYINT"));
    // more than 10 are not used
    names.add("NOPE");
    BenchmarkResponse read =
        (BenchmarkResponse) client.exchange(new BenchmarkReadRequest(1, 3, names));
    assertThat(read.tail()).isEqualTo(Tail.SUCCESS);
    assertThat(read.count()).isEqualTo(10);
    assertThat(read.iterations()).isEqualTo(3);
    assertThat(read.differenceMillis()).isEqualTo(read.stopMillis() - read.startMillis());

    BenchmarkResponse write =
        (BenchmarkResponse)
            client.exchange(new BenchmarkWriteRequest(2, 2, List.of(new Assignment("MYINT", "8"))));
    assertThat(write.write()).isTrue();
    assertThat(server.variables().get("MYINT")).isEqualTo("8");
    assertThat(server.requests()).extracting(r -> r.names().size()).containsExactly(11, 1);
    assertThat(server.requests()).extracting(RecordedRequest::isWrite).containsExactly(false, true);
  }

  // docs/reference/c3-messages.md#benchmark-17

  @Test
  void continuesABenchmarkAfterARefusedAccess() throws IOException {
    List<Assignment> items = List.of(new Assignment("NOPE", "1"), new Assignment("MYINT", "8"));
    BenchmarkResponse answer =
        (BenchmarkResponse) client.exchange(new BenchmarkWriteRequest(1, 5, items));
    assertThat(answer.tail()).isEqualTo(Tail.SUCCESS);
    assertThat(answer.count()).isEqualTo(2);
    assertThat(answer.iterations()).isEqualTo(5);
    assertThat(server.variables().get("MYINT")).isEqualTo("8");
  }

  @Test
  void answersTheMostIterationsAsOneLess() throws IOException {
    BenchmarkResponse none =
        (BenchmarkResponse) client.exchange(new BenchmarkReadRequest(1, 0xFFFF_FFFFL, List.of()));
    assertThat(none.tail()).isEqualTo(Tail.SUCCESS);
    assertThat(none.iterations()).isEqualTo(0xFFFF_FFFEL);
  }

  @Test
  void doesNotParseTheNamesOfABenchmarkAfterTheTenth() throws IOException {
    byte[] whole = Codec.encode(new BenchmarkReadRequest(1, 1, Collections.nCopies(10, "PING")));
    whole[6] = 12; // count
    client.send(whole);
    assertThat(client.response())
        .isInstanceOfSatisfying(
            BenchmarkResponse.class,
            answer -> {
              assertThat(answer.count()).isEqualTo(10);
              assertThat(answer.tail()).isEqualTo(Tail.SUCCESS);
            });
  }

  @Test
  void endsABenchmarkWhenItIsClosed() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    server.fault(
        request -> {
          begun.countDown();
          return false;
        },
        Fault.none());
    client.send(Codec.encode(new BenchmarkReadRequest(1, 0xFFFF_FFFFL, List.of("$OV_PRO"))));
    begun.await();
    server.close();
    assertThat(server.clientCount()).isZero();
  }

  // programs, keys and malformed file content

  @Test
  void needsInVersion10ParametersToSelectAProgram() throws Exception {
    restart(cfg -> cfg.version(new Version(1, 0, 0)));
    server.controller().load("MAIN.SRC", "DEF MAIN(N:IN)\nINT N\nEND\n");
    for (ProgramCommand command : List.of(ProgramCommand.SELECT, ProgramCommand.RUN)) {
      assertThat(select(command, "")).isEqualTo(tail(ErrorCode.PROTOCOL));
      assertThat(select(command, "1")).isEqualTo(Tail.SUCCESS);
      server.controller().robot().stop();
    }
  }

  private static Tail tail(ErrorCode code) {
    return new Tail(code.code(), 0);
  }

  private Tail select(ProgramCommand command, String parameters) throws IOException {
    Request request =
        new ProgramSelectRequest(
            1, Code.of(command), Code.of(Interpreter.SUBMIT), "/R1/MAIN", parameters, true);
    return ((ProgramResponse) client.exchange(request)).tail();
  }

  @Test
  void releasesThe6DMouseWhateverTheNumberOfTheAxis() throws IOException {
    client.send("01 75 00 0C 0C 04 00 00 00 63 00 00 00 00 00 01");
    assertThat(client.receive(9)).isEqualTo("01 75 00 05 0C 04 00 01 01");
  }

  @Test
  void releasesAStartKeyBackwardThatWasNotPressed() throws IOException {
    client.send("01 75 00 0C 0C 01 00 00 00 01 00 00 00 00 01 01");
    assertThat(client.receive(9)).isEqualTo("01 75 00 05 0C 01 00 01 01");
  }

  @Test
  void repeatsTheOperationOfATruncatedEndOfAWrite() throws IOException {
    client.send("01 75 00 02 1D 04");
    assertThat(client.receive(9)).isEqualTo("01 75 00 05 1D 04 00 09 00");
  }

  @Test
  void answersTruncatedDataWithoutABeginWithSize0() throws IOException {
    client.send("01 75 00 0B 1D 02 00 00 00 00 00 00 00 0A 78");
    assertThat(client.receive(17)).isEqualTo("01 75 00 0D 1D 02 00 00 00 00 00 00 00 00 00 01 01");
  }

  // files

  @Test
  void hasABufferForFilesOfEachConnection() throws IOException {
    assertThat(client.exchange(new BeginWriteRequest(1, 100)))
        .isInstanceOfSatisfying(
            ContentSizeResponse.class, r -> assertThat(r.size()).isEqualTo(100));
    ContentRequest size =
        new ContentRequest(2, MessageType.WRITE_CONTENT, Code.of(ContentOperation.SIZE));
    try (RawClient other = new RawClient(server)) {
      assertThat(((ContentSizeResponse) other.exchange(size)).size()).isZero();
    }
    assertThat(((ContentSizeResponse) client.exchange(size)).size()).isEqualTo(100);
  }

  // docs/reference/c3-messages.md#files-20-to-28

  private static final String PROGRAMS = "KRC:\\R1\\Program\\";

  private void putModule() throws IOException {
    for (String name : List.of("job.src", "job.dat", "jobs.txt")) {
      server.files().put(PROGRAMS + name, name);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {PROGRAMS + "JOB", "/R1/job"})
  void deletesAModuleByItsName(String name) throws IOException {
    putModule();
    assertThat(client.exchange(new DeleteFileRequest(1, false, name)))
        .isEqualTo(new PlainResponse(1, MessageType.DELETE_FILE, Tail.SUCCESS));
    assertThat(server.files().list(PROGRAMS)).containsExactly("jobs.txt");
    assertThat(client.exchange(new DeleteFileRequest(2, false, name)))
        .isEqualTo(new PlainResponse(2, MessageType.DELETE_FILE, Tail.FAILURE_ZERO));
  }

  @Test
  void copiesAModuleByItsName() throws IOException {
    putModule();
    CopyFileRequest copy =
        new CopyFileRequest(
            1, MessageType.COPY_FILE, Flags.none(CopyFlag.class), "/R1/JOB", PROGRAMS + "two");
    assertThat(client.exchange(copy))
        .isEqualTo(new PlainResponse(1, MessageType.COPY_FILE, Tail.SUCCESS));
    assertThat(server.files().get("/R1/TWO.SRC")).asString().isEqualTo("job.src");
    assertThat(server.files().get("/R1/TWO.DAT")).asString().isEqualTo("job.dat");
    assertThat(client.exchange(copy))
        .isEqualTo(new PlainResponse(1, MessageType.COPY_FILE, tail(ErrorCode.ACCESS)));
  }

  @Test
  void servesTheFilesItWasGiven() throws IOException {
    FileTree files = FileTree.inMemory();
    restart(cfg -> cfg.files(files));
    files.put("KRC:\\R1\\Program\\x.txt", "abc");
    assertThat(server.files()).isSameAs(files);
    assertThat(text(new FileNameRequest(1, MessageType.FULL_NAME, "/R1/X.TXT")).tail())
        .isEqualTo(Tail.SUCCESS);
  }

  // faults

  private static final Tail TAIL = new Tail(3, 0);

  static Stream<Request> requests() {
    return Stream.of(
        new ReadRequest(1, "A"),
        new WriteRequest(1, "A", "1"),
        new ReadUtf16Request(1, "A"),
        new WriteUtf16Request(1, "A", "1"),
        new ReadMultipleRequest(1, List.of("A", "B")),
        new WriteMultipleRequest(1, List.of(new Assignment("A", "1"))),
        new ProgramControlRequest(1, Code.of(ProgramCommand.START), Code.of(Interpreter.ROBOT)),
        new MotionRequest(1, Code.of(MotionType.LIN), "{X 1}"),
        new PendantKeyRequest(1, Code.of(PendantKey.STOP), 1, 0, false, false),
        new ServerRequest(1, MessageType.INFORMATION),
        new ServerRequest(1, MessageType.FEATURES),
        new ServerRequest(1, MessageType.CONFIRM_ALL),
        new BenchmarkReadRequest(1, 5, List.of("A")),
        new BenchmarkWriteRequest(1, 5, List.of(new Assignment("A", "1"))),
        new ListDirectoryRequest(
            1, Flags.none(ItemType.class), Flags.none(ListFlag.class), "KRC:\\"),
        new FilePropertiesRequest(1, Flags.none(FileProperty.class), "KRC:\\"),
        new FileNameRequest(1, MessageType.KRC_NAME, "X"),
        new BeginWriteRequest(1, 9),
        new WriteDataRequest(1, 6, Bytes.of(new byte[3])),
        new BeginReadRequest(1, Flags.none(CopyFlag.class), "X"),
        new ReadDataRequest(1, 6, 3),
        new ContentRequest(1, MessageType.READ_CONTENT, Code.of(ContentOperation.END)));
  }

  @ParameterizedTest
  @MethodSource("requests")
  void answersAnyRequestAsScripted(Request request) throws IOException {
    server.enqueue(Fault.answer("1", TAIL), Fault.answer("1", Tail.SUCCESS));
    for (Tail tail : List.of(TAIL, Tail.SUCCESS)) {
      Response answer = client.exchange(request);
      assertThat(answer)
          .isInstanceOfSatisfying(
              TypedResponse.class,
              typed -> {
                assertThat(typed.id()).isEqualTo(1);
                assertThat(typed.type()).isEqualTo(request.type());
                assertThat(typed.tail()).isEqualTo(tail);
              });
    }
  }

  private Response scripted(Request request, String value) throws IOException {
    server.enqueue(Fault.answer(value, Tail.SUCCESS));
    return client.exchange(request);
  }

  @Test
  void putsTheScriptedValueWhereAnAnswerHasATextForIt() throws IOException {
    assertThat(scripted(new ReadMultipleRequest(1, List.of("A", "B")), "5"))
        .isInstanceOfSatisfying(
            MultipleResponse.class,
            r -> assertThat(r.results()).containsOnly(result(ErrorCode.SUCCESS, "5")).hasSize(2));
    assertThat(scripted(new ServerRequest(1, MessageType.FEATURES), "10001"))
        .isInstanceOfSatisfying(
            FeaturesResponse.class, r -> assertThat(r.features().types()).containsExactly(0, 4));
    assertThat(scripted(new ServerRequest(1, MessageType.INFORMATION), "HOST"))
        .isInstanceOfSatisfying(
            InformationResponse.class,
            r -> assertThat(r.information().computerName()).isEqualTo("HOST"));
    Request list =
        new ListDirectoryRequest(
            1, Flags.none(ItemType.class), Flags.none(ListFlag.class), "KRC:\\");
    assertThat(scripted(list, "a\nb"))
        .isInstanceOfSatisfying(
            ListDirectoryResponse.class, r -> assertThat(r.items()).containsExactly("a", "b"));
    assertThat(scripted(new BenchmarkReadRequest(1, 5, List.of("A")), ""))
        .isEqualTo(new BenchmarkResponse(1, false, 1, 5, 0, 0, 0, Tail.SUCCESS));
    assertThat(scripted(new WriteDataRequest(1, 6, Bytes.of(new byte[3])), ""))
        .isEqualTo(new WriteDataResponse(1, 6, 0, Tail.SUCCESS));
    assertThat(scripted(new ReadDataRequest(1, 6, 3), ""))
        .isEqualTo(new ReadDataResponse(1, 6, Bytes.of(new byte[0]), Tail.SUCCESS));
    assertThat(scripted(new ServerRequest(1, MessageType.CONFIRM_ALL), "x"))
        .isEqualTo(new PlainResponse(1, MessageType.CONFIRM_ALL, Tail.SUCCESS));
    assertThat(scripted(new FilePropertiesRequest(1, Flags.none(FileProperty.class), "X"), "x"))
        .isInstanceOf(FilePropertiesResponse.class);
  }

  @ParameterizedTest
  @MethodSource("requests")
  void cutsAScriptedValueToWhatTheAnswerHolds(Request request) throws IOException {
    server.enqueue(Fault.answer("1".repeat(60_000), TAIL));
    assertThat(((TypedResponse) client.exchange(request)).tail()).isEqualTo(TAIL);
  }

  @Test
  void findsAVariableForAFaultAmongSeveral() throws IOException {
    server.faults(FaultRule.of(Fault.answer("9", TAIL)).onVariable("MYPOS"));
    assertThat(several(new ReadMultipleRequest(1, List.of("PING", "MYPOS.X"))).tail())
        .isEqualTo(TAIL);
    assertThat(several(new ReadMultipleRequest(1, List.of("PING", "MYINT"))).tail())
        .isEqualTo(Tail.SUCCESS);
  }

  @Test
  void doesNotExecuteAMalformedBatchThatIsDropped() throws IOException {
    server.enqueue(Fault.drop());
    // MYINT = 9 of two announced
    client.send(
        "01 42 00 12 07 02 00 05 4D 00 59 00 49 00 4E 00 54 00 00 01 39 00 00 01 00 07 00 00 04 50"
            + " 49 4E 47");
    client.receive(14);
    assertThat(server.variables().get("MYINT")).isEqualTo("0");
  }
}
