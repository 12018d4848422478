package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the limits and times of a controller, which the server has only if it is configured. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class LimitsTest {
  private static final String READ_OV_PRO = "00 00 00 0A 00 00 07 24 4F 56 5F 50 52 4F";
  private static final String ANSWER_100 = "00 00 00 09 00 00 03 31 30 30 00 01 01";
  private static final String PING = "00 09 00 07 00 00 04 50 49 4E 47";
  private static final String PONG = "00 09 00 0A 00 00 04 50 4F 4E 47 00 01 01";

  /** Longer than any test: only the end of the server ends such a wait. */
  private static final Latency FOR_EVER = Latency.fixed(Duration.ofHours(1));

  private MockServer server;
  private RawClient client;

  @BeforeEach
  void start() throws IOException {
    start(cfg -> {});
  }

  private void start(Consumer<MockServerConfig.Builder> changes) throws IOException {
    server = MockServer.start(changes);
    client = new RawClient(server);
  }

  @AfterEach
  void stop() throws IOException {
    client.close();
    server.close();
  }

  private void restart(Consumer<MockServerConfig.Builder> changes) throws IOException {
    stop();
    start(changes);
  }

  private void assertReceives(String hex) throws IOException {
    assertThat(client.receiveAsManyAs(hex)).isEqualTo(hex);
  }

  private void awaitDropped(int count) {
    while (server.dropCount() < count) {
      Thread.onSpinWait();
    }
    assertThat(server.dropCount()).isEqualTo(count);
  }

  // reads that are not joined

  @ParameterizedTest
  @ValueSource(ints = {2, 4, 5, 13})
  void dropsBothPartsOfARequestThatComesInTwoReads(int bytes) throws IOException {
    restart(cfg -> cfg.joinSplitRequests(false));
    client.send(READ_OV_PRO.substring(0, 3 * bytes - 1));
    awaitDropped(1);
    client.send(READ_OV_PRO.substring(3 * bytes));
    awaitDropped(2);
    client.send(PING);
    assertReceives(PONG);
  }

  @Test
  void answersTheFirstRequestOfAReadAndDropsTheRest() throws IOException {
    restart(cfg -> cfg.joinSplitRequests(false));
    client.send(READ_OV_PRO + " " + PING + " " + READ_OV_PRO.substring(0, 20));
    assertReceives(ANSWER_100);
    awaitDropped(1);
    client.send(PING);
    assertReceives(PONG);
    assertThat(server.requests()).hasSize(2);
  }

  @Test
  void takesTheSecondPartOfARequestForOneIfItLooksSo() throws IOException {
    restart(cfg -> cfg.joinSplitRequests(false));
    client.send(READ_OV_PRO.substring(0, 8));
    awaitDropped(1);
    // id 0A 00, length 7, and the unknown function 24
    client.send("0A 00 00 07 24 4F 56 5F 50 52 4F");
    assertReceives("0A 00 00 00");
  }

  @Test
  void reads2048BytesAtATime() throws IOException {
    restart(cfg -> cfg.joinSplitRequests(false));
    // 4 of the header, 1 function, 2 + 2 name, 2 length of the value
    String fits = "x".repeat(2048 - 11);
    assertThat(client.write("NO", fits).tail()).isEqualTo(Tail.FAILURE);
    client.send(Codec.encode(new WriteRequest(1, "NO", fits + "x")));
    // also the byte after it
    awaitDropped(2);
    assertThat(client.read("PING").value()).isEqualTo("PONG");
  }

  @Test
  void seesAClientLeaveBetweenReads() throws IOException {
    restart(cfg -> cfg.joinSplitRequests(false));
    client.send(READ_OV_PRO.substring(0, 8));
    client.close();
    while (server.clientCount() > 0) {
      Thread.onSpinWait();
    }
    awaitDropped(1);
  }

  // requests that arrive while another is served

  @Test
  void dropsWhatComesOnAConnectionBeforeItsAnswer() throws Exception {
    restart(cfg -> cfg.pendingRequests(PendingRequests.DROP_OF_SAME_CLIENT));
    CountDownLatch released = new CountDownLatch(1);
    server.enqueue(Fault.hold(released));
    client.send(READ_OV_PRO);
    assertThat(server.takeRequest(Duration.ofSeconds(20))).isPresent();
    client.send(READ_OV_PRO);
    try (RawClient other = new RawClient(server)) {
      // other clients are served; the request that was sent before has arrived by now
      assertThat(other.read("PING").value()).isEqualTo("PONG");
    }
    released.countDown();
    assertReceives(ANSWER_100);
    client.send(PING);
    assertReceives(PONG);
    assertThat(server.dropCount()).isEqualTo(1);
    assertThat(server.requestCount()).isEqualTo(3);
  }

  @ParameterizedTest
  @EnumSource(names = {"DROP_OF_SAME_CLIENT", "DROP"})
  void dropsTheSecondRequestOfOnePieceOnce(PendingRequests pending) throws IOException {
    restart(cfg -> cfg.joinSplitRequests(false).pendingRequests(pending));
    client.send(READ_OV_PRO + " " + PING);
    assertReceives(ANSWER_100);
    client.send(PING);
    assertReceives(PONG);
    assertThat(server.dropCount()).isEqualTo(1);
  }

  @Test
  void dropsWhatComesFromAnybodyWhileARequestIsServed() throws Exception {
    restart(cfg -> cfg.pendingRequests(PendingRequests.DROP));
    CountDownLatch entered = new CountDownLatch(1);
    CountDownLatch released = new CountDownLatch(1);
    server.faults(
        request -> {
          entered.countDown();
          try {
            released.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
          return Optional.empty();
        });
    client.send(READ_OV_PRO);
    entered.await();
    try (RawClient other = new RawClient(server)) {
      other.send(READ_OV_PRO);
      awaitDropped(1);
      released.countDown();
      assertReceives(ANSWER_100);
      other.send(PING);
      assertThat(other.receiveAsManyAs(PONG)).isEqualTo(PONG);
    }
    assertThat(server.requestCount()).isEqualTo(2);
  }

  // unknown functions and PING

  @Test
  void closesTheConnectionForAnUnknownFunctionIfToldSo() throws IOException {
    restart(cfg -> cfg.unknownFunction(UnknownFunction.CLOSE));
    client.send("00 11 00 05 0A 00 02 4E 4F");
    assertThat(client.receiveAll()).isEmpty();
    assertThat(server.requests().get(0).hex()).isEqualTo("00 11 00 05 0A 00 02 4E 4F");
  }

  @Test
  void letsAFaultTakeThePlaceOfClosing() throws IOException {
    restart(cfg -> cfg.unknownFunction(UnknownFunction.CLOSE));
    server.enqueue(Fault.wrongId());
    client.send("00 11 00 05 0A 00 02 4E 4F");
    assertReceives("00 12 00 00");
  }

  @Test
  void takesPingForAVariableIfToldSo() throws IOException {
    restart(cfg -> cfg.ping(false));
    assertThat(client.read("PING").value()).isEmpty();
    server.variables().declare("PING", "INT", "3");
    assertThat(client.read("PING").value()).isEqualTo("3");
  }

  // time

  @Test
  void spendsTheTimeOfARequestInItsTurn() throws Exception {
    restart(cfg -> cfg.latency(FOR_EVER).pendingRequests(PendingRequests.DROP));
    client.send(READ_OV_PRO);
    assertThat(server.takeRequest(Duration.ofSeconds(20))).isPresent();
    try (RawClient other = new RawClient(server)) {
      other.send(PING);
      awaitDropped(1);
    }
    server.close();
    assertThat(client.receiveAll()).isEmpty();
  }

  @Test
  void spendsTheTimeOfARequestOnItsConnectionOnlyIfToldSo() throws Exception {
    restart(cfg -> cfg.latency(FOR_EVER).oneAtATime(false));
    client.send(READ_OV_PRO);
    assertThat(server.takeRequest(Duration.ofSeconds(20))).isPresent();
    try (RawClient other = new RawClient(server)) {
      assertThat(other.read("PING").value()).isEqualTo("PONG");
    }
    server.close();
    assertThat(client.receiveAll()).isEmpty();
  }

  @Test
  void takesNoTimeForWhatTheControllerIsNotAskedFor() throws IOException {
    restart(cfg -> cfg.latency(FOR_EVER));
    client.send(PING);
    assertReceives(PONG);
    client.send("00 11 00 05 0A 00 02 4E 4F"); // an unknown function
    assertReceives("00 11 00 00");
    server.enqueue(Fault.none(), Fault.raw("01"));
    client.sendUnanswered("00 01 00 00"); // malformed
    client.send(READ_OV_PRO);
    assertReceives("01");
  }

  @Test
  void answersAllClientsWhenEachTakesItsTime() throws IOException {
    restart(cfg -> cfg.latency(Latency.fixed(Duration.ofNanos(100_000))));
    try (RawClient other = new RawClient(server)) {
      for (int i = 0; i < 5; i++) {
        client.send(READ_OV_PRO);
        assertThat(other.read("$OV_PRO").value()).isEqualTo("100");
        assertReceives(ANSWER_100);
      }
    }
  }

  @Test
  void servesAClientThatKeepsToTheRulesAsOnTheController() throws IOException {
    restart(cfg -> cfg.asOnTheController(1));
    assertThat(client.write("MYINT", "5").tail()).isEqualTo(Tail.SUCCESS);
    assertThat(client.read("MYINT").value()).isEqualTo("5");
    assertThat(server.dropCount()).isZero();
  }
}
