package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.EmptyResponse;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.ReadArrayResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import no.hials.crosscom.simulator.Refusal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the answers of the server byte by byte. */
class WireTest {
  private static final String READ_OV_PRO = "00 00 00 0A 00 00 07 24 4F 56 5F 50 52 4F";
  private static final String ANSWER_100 = "00 00 00 09 00 00 03 31 30 30 00 01 01";
  private static final String PING = "00 09 00 07 00 00 04 50 49 4E 47";
  private static final String PONG = "00 09 00 0A 00 00 04 50 4F 4E 47 00 01 01";

  private MockServer server;
  private RawClient client;

  @BeforeEach
  void start() throws IOException {
    server = MockServer.start();
    client = new RawClient(server);
  }

  @AfterEach
  void stop() throws IOException {
    client.close();
    server.close();
  }

  private void restart(MockServerConfig config) throws IOException {
    stop();
    server = MockServer.start(config);
    client = new RawClient(server);
  }

  private void assertAnswer(String request, String answer) throws IOException {
    client.send(request);
    assertThat(client.receiveAsManyAs(answer)).isEqualTo(answer);
  }

  /** Checks that no other answer was sent before: the answer to PING comes next. */
  private void assertNothingBeforePong() throws IOException {
    assertAnswer(PING, PONG);
  }

  // docs/reference/wire-format.md#examples

  @Test
  void answersTheReadOfAnInt() throws IOException {
    assertAnswer(READ_OV_PRO, ANSWER_100);
  }

  @Test
  void answersTheWriteOfAnIntWithTheValueSent() throws IOException {
    assertAnswer(
        "00 01 00 0E 01 00 07 24 4F 56 5F 50 52 4F 00 02 35 30",
        "00 01 00 08 01 00 02 35 30 00 01 01");
    assertThat(server.variables().get("$OV_PRO")).isEqualTo("50");
  }

  @Test
  void answersTheReadOfAnEnum() throws IOException {
    assertAnswer(
        "01 00 00 0E 00 00 0B 24 41 43 43 55 5F 53 54 41 54 45",
        "01 00 00 10 00 00 0A 23 43 48 41 52 47 45 5F 4F 4B 00 01 01");
  }

  @Test
  void answersWithTheIdOfTheRequest() throws IOException {
    assertAnswer(
        "01 00 00 0E 01 00 07 24 4F 56 5F 50 52 4F 00 02 33 35",
        "01 00 00 08 01 00 02 33 35 00 01 01");
  }

  /** The sample of a real controller in docs/reference/wire-format.md#examples. */
  @Test
  void answersTheReadOfAComponentWhateverTheCaseOfItsName() throws IOException {
    server.variables().set("$POS_ACT", "{X 284.994965}");
    assertAnswer(
        "00 00 00 0D 00 00 0A 24 50 4F 53 5F 41 43 54 2E 78",
        "00 00 00 10 00 00 0A 32 38 34 2E 39 39 34 39 36 35 00 01 01");
  }

  // failed accesses

  @ParameterizedTest
  @CsvSource({"EMPTY_SUCCESS,00 01 01", "FAILURE,00 01 00", "FAILURE_ZERO,00 00 00"})
  void answersAFailedReadWithNoValueAndTheTailOfItsProfile(FailedRead profile, String tail)
      throws IOException {
    restart(MockServerConfig.create(cfg -> cfg.failedRead(profile)));
    assertAnswer("00 05 00 05 00 00 02 4E 4F", "00 05 00 06 00 00 00 " + tail);
  }

  @Test
  void answersAFailedReadAsKukavarproxyUnlessToldOtherwise() throws IOException {
    assertAnswer("00 05 00 05 00 00 02 4E 4F", "00 05 00 06 00 00 00 00 01 01");
  }

  @Test
  void answersAFailedWriteWithTheValueSentAndATailOfFailure() throws IOException {
    assertAnswer("00 05 00 08 01 00 02 4E 4F 00 01 31", "00 05 00 07 01 00 01 31 00 01 00");
  }

  @Test
  void answersAFailedWriteWithTheTailThatWasChosen() throws IOException {
    restart(MockServerConfig.create(cfg -> cfg.failedWriteTail(new Tail(2, 0))));
    assertThat(client.write("NO", "1"))
        .isEqualTo(new ValueResponse(8, MessageType.WRITE, "1", new Tail(2, 0)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " ", "[]", ".", "1", "$OV_PRO[", "$OV_PRO.", "MYINTS[1", "A B"})
  void refusesWhatIsNoName(String name) throws IOException {
    assertThat(client.read(name))
        .isEqualTo(new ValueResponse(7, MessageType.READ, "", Tail.SUCCESS));
    assertThat(client.write(name, "1"))
        .isEqualTo(new ValueResponse(8, MessageType.WRITE, "1", Tail.FAILURE));
  }

  @Test
  void keepsWhatWasThereWhenAWriteIsRefused() throws IOException {
    assertThat(client.write("$OV_PRO", "50.5").tail()).isEqualTo(Tail.FAILURE);
    assertThat(client.read("$OV_PRO").value()).isEqualTo("100");
  }

  @Test
  void refusesAValueThatDoesNotFitIntoItsOwnEcho() throws IOException {
    String value = "1".repeat(65_530);
    assertThat(client.write("", value))
        .isEqualTo(new ValueResponse(8, MessageType.WRITE, "", Tail.FAILURE));
  }

  @Test
  void refusesAReadWhoseValueDoesNotFitIntoAnAnswer() throws IOException {
    server.variables().declare("LONG[65528]", "CHAR", "\"" + "x".repeat(65_527) + "\"");
    assertThat(client.read("LONG[]").value()).hasSize(65_529);
    server.variables().set("LONG[]", "\"" + "x".repeat(65_528) + "\"");
    assertThat(client.read("LONG[]"))
        .isEqualTo(new ValueResponse(7, MessageType.READ, "", Tail.SUCCESS));
    assertThat(server.requests().get(1).refusal()).isEqualTo(Refusal.TOO_LONG);
  }

  @Test
  void acceptsAnAggregateOf255BytesAndRefusesALongerOne() throws IOException {
    String digits = "0".repeat(255 - "{X 1.,Y 2.0}".length());
    assertThat(client.write("MYPOS", "{X 1." + digits + ",Y 2.0}").tail().success()).isTrue();
    assertThat(client.write("MYPOS", "{X 1." + digits + ",Y 2.00}").tail().success()).isFalse();
    assertThat(server.requests().get(1).refusal()).isEqualTo(Refusal.TOO_LONG);
  }

  @Test
  void takesLongAggregatesWhenTheLimitIsLifted() throws IOException {
    restart(MockServerConfig.create(cfg -> cfg.maxAggregateLength(0)));
    String value = "{X 1." + "0".repeat(1000) + "}";
    assertThat(client.write("MYPOS", value).tail().success()).isTrue();
  }

  // PING and malformed requests

  @Test
  void answersPingWithPongWithoutAskingTheController() throws IOException {
    server.variables().declare("PING", "INT", "3");
    assertAnswer(PING, PONG);
  }

  @Test
  void takesPingInLowerCaseForAVariable() throws IOException {
    assertThat(client.read("ping").value()).isEmpty();
  }

  @Test
  void answersAnUnknownFunctionWithTheIdAndLengthZero() throws IOException {
    assertAnswer("00 11 00 05 0A 00 02 4E 4F", "00 11 00 00");
    assertNothingBeforePong();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "00 01 00 00", // no function
        "00 01 00 01 00", // no name length
        "00 01 00 0A 00 00 08 24 4F 56 5F 50 52 4F", // name length too large
        "00 01 00 0A 01 00 07 24 4F 56 5F 50 52 4F", // a write without a value
        "00 01 00 07 03 00 01 41 00 01 41" // an array of half a number
      })
  void doesNotAnswerAMalformedRequestAndStaysConnected(String request) throws IOException {
    client.sendUnanswered(request);
    assertNothingBeforePong();
    RecordedRequest recorded = server.requests().get(0);
    assertThat(recorded.request()).isNull();
    assertThat(recorded.hex()).isEqualTo(request);
    assertThat(recorded.name()).isEmpty();
    assertThat(recorded.value()).isNull();
    assertThat(recorded.isWrite()).isFalse();
  }

  // arrays of 16-bit numbers

  @Test
  void answersFunction2WithTheElementsAs16BitNumbers() throws IOException {
    server.variables().declare("TWO[2]", "INT", "1 65537");
    server.variables().set("TWO[2]", "-2");
    assertAnswer(
        "00 02 00 08 02 00 05 54 57 4F 5B 5D", // TWO[]
        "00 02 00 0A 02 00 04 00 01 FF FE 00 01 01");
  }

  @Test
  void answersFunction2OnASingleElementWithoutElements() throws IOException {
    server.variables().declare("TWO[2]", "INT", "1 2");
    for (String name : List.of("TWO[1]", "$OV_PRO")) {
      assertThat(client.exchange(new ReadArrayRequest(2, name)))
          .as(name)
          .isEqualTo(new ReadArrayResponse(2, List.of(), Tail.SUCCESS));
    }
  }

  @Test
  void answersFunction2WithoutElementsIfTheyAreNotInt() throws IOException {
    for (String name : List.of("$TORQUE_AXIS_ACT[]", "NO[]", "MYINTS")) {
      assertThat(client.exchange(new ReadArrayRequest(2, name)))
          .as(name)
          .isEqualTo(new ReadArrayResponse(2, List.of(), Tail.SUCCESS));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"MYINTS", "MYINTS[]"})
  void writesTheElementsOfFunction3OneByOne(String name) throws IOException {
    assertThat(client.exchange(new WriteArrayRequest(3, name, List.of(7, 65_535))))
        .isEqualTo(new ValueResponse(3, MessageType.WRITE_ARRAY, "", Tail.SUCCESS));
    assertThat(server.variables().get("MYINTS[]")).isEqualTo("7 65535 0 0 0 0 0 0 0 0 ");
  }

  @Test
  void keepsTheElementsOfFunction3ThatCameBeforeARefusedOne() throws IOException {
    server.variables().declare("TWO[2]", "INT", "0");
    assertThat(client.exchange(new WriteArrayRequest(3, "TWO", List.of(1, 2, 3))))
        .isEqualTo(new ValueResponse(3, MessageType.WRITE_ARRAY, "", Tail.FAILURE));
    assertThat(server.variables().get("TWO[]")).isEqualTo("1 2 ");
    assertThat(server.requests().get(0).refusal()).isEqualTo(Refusal.BAD_INDEX);
  }

  // pieces of requests

  @Test
  void putsARequestTogetherThatArrivesByteByByte() throws IOException {
    for (byte b : HexFormat.ofDelimiter(" ").parseHex(READ_OV_PRO)) {
      client.send(new byte[] {b});
    }
    assertThat(client.receiveAsManyAs(ANSWER_100)).isEqualTo(ANSWER_100);
  }

  // docs/reference/kukavarproxy.md#pieces-of-requests

  @ParameterizedTest
  @ValueSource(strings = {"00", "00 00 00 00 00 00 00", PING})
  void dropsTheBytesAfterARequestInTheSameReceive(String surplus) throws IOException {
    for (int i = 0; i < 3; i++) {
      assertAnswer(READ_OV_PRO + " " + surplus, ANSWER_100);
    }
    assertNothingBeforePong();
    assertThat(server.dropCount()).isEqualTo(3);
    assertThat(server.requestCount()).isEqualTo(4);
  }

  @Test
  void dropsTheBytesAfterTheLastPieceOfARequest() throws IOException {
    client.send(READ_OV_PRO.substring(0, 20));
    client.send(READ_OV_PRO.substring(21) + " 00");
    assertThat(client.receiveAsManyAs(ANSWER_100)).isEqualTo(ANSWER_100);
    assertNothingBeforePong();
  }

  @ParameterizedTest
  @ValueSource(strings = {"00 00", "00 07", "00 08", "00 09", "00 0E", "FF FF"})
  void answersAReadWithAWrongLengthField(String length) throws IOException {
    assertAnswer("00 00 " + length + " 00 00 07 24 4F 56 5F 50 52 4F", ANSWER_100);
    assertNothingBeforePong();
  }

  @ParameterizedTest
  @ValueSource(strings = {"00 0B", "00 12"})
  void answersAWriteWithAWrongLengthField(String length) throws IOException {
    assertAnswer(
        "00 01 " + length + " 01 00 07 24 4F 56 5F 50 52 4F 00 02 35 30",
        "00 01 00 08 01 00 02 35 30 00 01 01");
    assertThat(server.variables().get("$OV_PRO")).isEqualTo("50");
    assertNothingBeforePong();
  }

  @Test
  void readsTheNameByItsOwnLength() throws IOException {
    // $OV_PR and a byte more, which the length field counts
    assertAnswer("00 01 00 0A 00 00 06 24 4F 56 5F 50 52 4F", "00 01 00 06 00 00 00 00 01 01");
    assertThat(server.requests().get(0).name()).isEqualTo("$OV_PR");
  }

  @Test
  void joinsThePiecesOfALongWrite() throws IOException {
    String value = "x".repeat(60_000);
    assertThat(client.write("NO", value))
        .isEqualTo(new ValueResponse(8, MessageType.WRITE, value, Tail.FAILURE));
    assertNothingBeforePong();
  }

  @Test
  void givesUpAClientThatLeavesWithinARequest() throws IOException {
    client.send("00 01 00");
    client.close();
    try (RawClient other = new RawClient(server)) {
      assertThat(other.read("PING").value()).isEqualTo("PONG");
    }
    assertThat(server.requests()).hasSize(1);
  }

  // values

  @Test
  void trimsValuesAsKukavarproxyUnlessToldOtherwise() throws IOException {
    assertThat(client.read("MYINTS[]").value()).isEqualTo("0 0 0 0 0 0 0 0 0 0");
    restart(MockServerConfig.create(cfg -> cfg.trimValues(false)));
    assertThat(client.read("MYINTS[]").value()).isEqualTo("0 0 0 0 0 0 0 0 0 0 ");
  }

  @Test
  void sendsCharactersAsIso88591() throws IOException {
    client.send(Codec.encode(new WriteRequest(1, "MYSTRING[]", "\"\u00fc\"")));
    assertThat(client.receive(12)).isEqualTo("00 01 00 09 01 00 03 22 FC 22 00 01");
    assertThat(client.receive(1)).isEqualTo("01");
    assertThat(server.variables().get("mystring[]")).isEqualTo("\"\u00fc\"");
    client.send(Codec.encode(new ReadRequest(1, "MYSTRING[]")));
    String frame = client.receive(13);
    byte[] bytes = HexFormat.ofDelimiter(" ").parseHex(frame);
    assertThat(new String(bytes, 7, 3, StandardCharsets.ISO_8859_1)).isEqualTo("\"\u00fc\"");
  }

  @Test
  void answersInTheTypesOfTheCodec() throws IOException {
    assertThat(client.read("$MODEL_NAME[]"))
        .isEqualTo(
            new ValueResponse(7, MessageType.READ, "\"#KR6R900 C4SR FLR 230\"", Tail.SUCCESS));
    client.send("00 11 00 01 63");
    assertThat(client.response()).isEqualTo(new EmptyResponse(0x11));
  }
}
