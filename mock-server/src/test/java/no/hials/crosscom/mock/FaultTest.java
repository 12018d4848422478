package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.SocketException;
import java.time.Duration;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.mock.internal.ResponsePlan;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.EmptyResponse;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.ReadArrayResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the effect of each fault, and whether it executes the write of MYINT = 5. */
class FaultTest {
  private static final String WRITE = "00 01 00 0B 01 00 05 4D 59 49 4E 54 00 01 35";
  private static final String WRITTEN = "00 01 00 07 01 00 01 35 00 01 01";
  private static final String PING = "00 09 00 07 00 00 04 50 49 4E 47";
  private static final String PONG = "00 09 00 0A 00 00 04 50 4F 4E 47 00 01 01";

  @KukaController private MockServer server;
  private RawClient client;

  @BeforeEach
  void start() throws IOException {
    client = new RawClient(server);
  }

  @AfterEach
  void stop() throws IOException {
    client.close();
  }

  private void assertReceives(String hex) throws IOException {
    assertThat(client.receiveAsManyAs(hex)).isEqualTo(hex);
  }

  private void assertServesOn() throws IOException {
    client.send(PING);
    assertReceives(PONG);
  }

  private void assertExecuted(boolean executed) {
    assertThat(server.variables().get("MYINT")).isEqualTo(executed ? "5" : "0");
    assertThat(server.requests().get(0).name()).isEqualTo("MYINT");
  }

  @Test
  void answersTheGivenBytesInstead() throws IOException {
    server.enqueue(Fault.raw("DE AD", "beef"));
    client.send(WRITE);
    assertReceives("DE AD BE EF");
    assertExecuted(false);
    assertServesOn();
  }

  @Test
  void sendsEachTextOfRawBytesByItself() {
    assertThat(ResponsePlan.of(Fault.raw("DE AD", "beef"), null, null).segments())
        .containsExactly(
            new byte[] {(byte) 0xDE, (byte) 0xAD}, new byte[] {(byte) 0xBE, (byte) 0xEF});
  }

  @Test
  void answersAScriptedValueWithTheRequestsOwnIdAndFunction() throws IOException {
    Tail tail = new Tail(2, 0);
    server.faults(request -> Optional.of(Fault.answer("1 2", tail)));
    assertThat(client.read("MYINT")).isEqualTo(new ValueResponse(7, MessageType.READ, "1 2", tail));
    assertThat(client.write("MYINT", "5"))
        .isEqualTo(new ValueResponse(8, MessageType.WRITE, "1 2", tail));
    assertThat(client.exchange(new ReadArrayRequest(3, "MYINTS[]")))
        .isEqualTo(new ReadArrayResponse(3, List.of(1, 2), tail));
    assertThat(client.exchange(new WriteArrayRequest(4, "MYINTS", List.of(3))))
        .isEqualTo(new ValueResponse(4, MessageType.WRITE_ARRAY, "1 2", tail));
    assertExecuted(false);
    assertThat(server.variables().get("MYINTS[1]")).isEqualTo("0");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "x", "1.5"})
  void answersAnArrayReadWithoutElementsIfTheScriptedValueIsNoInts(String value)
      throws IOException {
    server.enqueue(Fault.answer(value, Tail.SUCCESS));
    assertThat(client.exchange(new ReadArrayRequest(3, "MYINTS[]")))
        .isEqualTo(new ReadArrayResponse(3, List.of(), Tail.SUCCESS));
  }

  @Test
  void answersAsIfTheFunctionWereUnknown() throws IOException {
    server.enqueue(Fault.emptyAnswer());
    client.send(WRITE);
    assertReceives("00 01 00 00");
    assertExecuted(false);
    assertServesOn();
  }

  @Test
  void dropsARequest() throws IOException {
    server.enqueue(Fault.drop());
    client.sendUnanswered(WRITE);
    assertServesOn();
    assertExecuted(false);
  }

  @Test
  void dropsAnAnswer() throws IOException {
    server.enqueue(Fault.dropAnswer());
    client.sendUnanswered(WRITE);
    assertServesOn();
    assertExecuted(true);
  }

  @Test
  void closesTheConnectionInsteadOfAnAnswer() throws IOException {
    server.enqueue(Fault.closeBefore());
    client.send(WRITE);
    assertThat(client.receiveAll()).isEmpty();
    assertExecuted(false);
  }

  @Test
  void resetsTheConnectionInsteadOfAnAnswer() throws IOException {
    server.enqueue(Fault.resetBefore());
    client.send(WRITE);
    assertThatThrownBy(client::receiveAll).isInstanceOf(SocketException.class);
    assertExecuted(false);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 4, 10, 11, 100})
  void closesTheConnectionWithinAnAnswer(int bytes) throws IOException {
    server.enqueue(Fault.closeDuring(bytes));
    client.send(WRITE);
    String start = WRITTEN.substring(0, Math.max(0, Math.min(bytes, 11) * 3 - 1));
    assertThat(client.receiveAll()).isEqualTo(start);
    assertExecuted(true);
  }

  @Test
  void closesTheConnectionAfterAnAnswer() throws IOException {
    server.enqueue(Fault.closeAfter());
    client.send(WRITE);
    assertThat(client.receiveAll()).isEqualTo(WRITTEN);
    assertExecuted(true);
  }

  @Test
  void answersLaterButExecutesAtOnce() throws IOException {
    server.enqueue(Fault.delay(Duration.ofMillis(1)));
    client.send(WRITE);
    assertReceives(WRITTEN);
    assertExecuted(true);
    assertServesOn();
  }

  @Test
  void answersWhenReleasedAndServesOthersMeanwhile() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    server.enqueue(Fault.hold(released));
    client.send(WRITE);
    assertThat(server.takeRequest(Duration.ofSeconds(20))).isPresent();
    assertExecuted(true);
    try (RawClient other = new RawClient(server)) {
      assertThat(other.read("MYINT").value()).isEqualTo("5");
    }
    released.countDown();
    assertReceives(WRITTEN);
  }

  @Test
  void cutsAnAnswerIntoSegments() throws IOException {
    server.enqueue(new Fault.Split(List.of(1, 2, 3), Duration.ofMillis(1)));
    client.send(WRITE);
    assertReceives(WRITTEN);
    assertExecuted(true);
    byte[] answer = HexFormat.ofDelimiter(" ").parseHex(WRITTEN);
    assertThat(ResponsePlan.of(Fault.split(1, 2, 3), null, answer).segments())
        .extracting(piece -> piece.length)
        .containsExactly(1, 2, 3, 5);
    assertThat(ResponsePlan.of(Fault.split(10, 20, 30), null, answer).segments())
        .extracting(piece -> piece.length)
        .containsExactly(10, 1);
  }

  @Test
  void sendsAnAnswerOneByteAtATime() throws IOException {
    server.enqueue(Fault.oneByteAtATime(Duration.ofMillis(1)), Fault.oneByteAtATime());
    client.send(WRITE);
    assertReceives(WRITTEN);
    assertExecuted(true);
    assertServesOn();
    byte[] answer = HexFormat.ofDelimiter(" ").parseHex(WRITTEN);
    assertThat(ResponsePlan.of(Fault.oneByteAtATime(), null, answer).segments())
        .hasSize(11)
        .allMatch(piece -> piece.length == 1);
  }

  @Test
  void answersTwiceInOnePiece() throws IOException {
    server.enqueue(Fault.answerTwice());
    client.send(WRITE);
    assertReceives(WRITTEN + " " + WRITTEN);
    assertExecuted(true);
    byte[] answer = HexFormat.ofDelimiter(" ").parseHex(WRITTEN);
    assertThat(ResponsePlan.of(Fault.answerTwice(), null, answer).segments()).hasSize(1);
  }

  @Test
  void gluesAnAnswerToTheNextOne() throws IOException {
    server.enqueue(Fault.glueToNext(), Fault.glueToNext());
    client.sendUnanswered(WRITE);
    client.sendUnanswered(WRITE);
    client.send(PING);
    assertReceives(WRITTEN + " " + WRITTEN + " " + PONG);
    assertExecuted(true);
  }

  @Test
  void answersWithAnotherId() throws IOException {
    server.enqueue(Fault.wrongId(), new Fault.WrongId(-2));
    client.send(WRITE);
    assertReceives("00 02" + WRITTEN.substring(5));
    client.send(WRITE);
    assertReceives("FF FF" + WRITTEN.substring(5));
    assertExecuted(true);
  }

  @Test
  void answersWithAnotherFunction() throws IOException {
    server.enqueue(Fault.wrongFunction(0xFF));
    client.send(WRITE);
    assertReceives("00 01 00 07 FF" + WRITTEN.substring(14));
    assertExecuted(true);
  }

  @Test
  void answersWithAnotherLength() throws IOException {
    server.enqueue(Fault.wrongLength(1), Fault.wrongLength(-8));
    client.send(WRITE);
    assertReceives("00 01 00 08" + WRITTEN.substring(11));
    client.send(WRITE);
    assertReceives("00 01 FF FF" + WRITTEN.substring(11));
    assertExecuted(true);
  }

  @Test
  void truncatesAnAnswerAndStaysConnected() throws IOException {
    server.enqueue(Fault.truncate(6));
    client.send(WRITE);
    assertReceives(WRITTEN.substring(0, 17));
    assertExecuted(true);
    assertServesOn();
  }

  @Test
  void answersWithTheSameGarbageForTheSameSeed() throws IOException {
    server.enqueue(Fault.garbage(1, 100), Fault.garbage(1, 100));
    client.send(WRITE);
    String garbage = client.receive(100);
    client.send(WRITE);
    assertThat(client.receive(100)).isEqualTo(garbage);
    assertExecuted(true);
  }

  // requests without an answer

  @Test
  void hasNothingToCutIfThereIsNoAnswer() throws IOException {
    server.enqueue(Fault.oneByteAtATime(), Fault.answer("1", Tail.SUCCESS), Fault.emptyAnswer());
    for (int i = 0; i < 3; i++) {
      client.sendUnanswered("00 01 00 00");
    }
    assertServesOn();
    server.enqueue(Fault.closeAfter());
    client.send("00 01 00 00");
    assertThat(client.receiveAll()).isEmpty();
  }

  @Test
  void appliesToTheAnswerOfAnUnknownFunction() throws IOException {
    server.enqueue(Fault.wrongId(), Fault.wrongFunction(1));
    client.send("00 01 00 01 63");
    assertThat(client.response()).isEqualTo(new EmptyResponse(2));
    client.send("00 01 00 01 63");
    assertThat(client.response()).isEqualTo(new EmptyResponse(1));
  }

  // the choice of requests

  @Test
  void passesOverRequestsForNoFault() throws IOException {
    server.enqueue(Fault.none(), Fault.wrongId(), Fault.none());
    assertThat(client.read("PING").id()).isEqualTo(7);
    assertThat(client.read("PING").id()).isEqualTo(8);
    assertThat(client.read("PING").id()).isEqualTo(7);
    assertThat(client.read("PING").id()).isEqualTo(7);
  }

  @Test
  void appliesToEachRequestThatAPredicatePicks() throws IOException {
    server.fault(RecordedRequest::isWrite, Fault.wrongId());
    server.fault(request -> request.name().equals("MYINT"), Fault.wrongLength(0));
    assertThat(client.write("MYINT", "5").id()).isEqualTo(9);
    assertThat(client.read("MYINT").id()).isEqualTo(7);
    assertThat(client.write("MYINT", "6").id()).isEqualTo(9);
    server.enqueue(Fault.none());
    assertThat(client.write("MYINT", "7").id()).isEqualTo(8);
    server.enqueue(Fault.wrongId());
    server.clearFaults();
    assertThat(client.write("MYINT", "8").id()).isEqualTo(8);
  }

  @Test
  void canBeChosenByTheNumberOfTheRequest() throws IOException {
    server.faults(
        request -> request.number() % 2 == 0 ? Optional.of(Fault.wrongId()) : Optional.empty());
    assertThat(client.read("PING").id()).isEqualTo(7);
    assertThat(client.read("PING").id()).isEqualTo(8);
    assertThat(client.read("PING").id()).isEqualTo(7);
  }

  @Test
  void losesOnlyTheConnectionWhoseRequestAPredicateFailsOn() throws IOException {
    server.fault(
        request -> {
          throw new IllegalStateException("a mistake in a test");
        },
        Fault.none());
    client.send(WRITE);
    assertThat(client.receiveAll()).isEmpty();
    server.clearFaults();
    try (RawClient other = new RawClient(server)) {
      assertThat(other.read("MYINT").value()).isEqualTo("0");
    }
  }

  // invalid arguments

  @Test
  void refusesSettingsThatMakeNoSense() {
    assertThatThrownBy(() -> Fault.raw("0")).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Fault.raw("xx")).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Fault.answer("\u20ac", Tail.SUCCESS))
        .hasMessageContaining("ISO 8859-1");
    assertThatThrownBy(() -> Fault.answer("x".repeat(65_530), Tail.SUCCESS))
        .hasMessageContaining("65529");
    assertThatThrownBy(() -> Fault.closeDuring(-1)).hasMessageContaining("bytes");
    assertThatThrownBy(() -> Fault.truncate(-1)).hasMessageContaining("bytes");
    assertThatThrownBy(() -> Fault.garbage(1, -1)).hasMessageContaining("length");
    assertThatThrownBy(() -> Fault.delay(Duration.ofMillis(-1))).hasMessageContaining("time");
    assertThatThrownBy(() -> Fault.oneByteAtATime(Duration.ofMillis(-1)))
        .hasMessageContaining("pause");
    assertThatThrownBy(() -> Fault.split(0)).hasMessageContaining("at least 1 byte");
    assertThatThrownBy(() -> Fault.wrongFunction(256)).hasMessageContaining("0 to 255");
  }
}
