package no.hials.crosscom.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.ConnectException;
import java.net.SocketException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteArrayRequest;
import no.hials.crosscom.simulator.Refusal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests the start, the limits and the end of servers. */
@Timeout(60)
class LifecycleTest {

  private static List<String> threadsOf(MockServer server) {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("mock-server-" + server.port() + "-"))
        .sorted()
        .toList();
  }

  private static void awaitClients(MockServer server, int count) {
    while (server.clientCount() != count) {
      Thread.onSpinWait();
    }
  }

  @Test
  void listensOnAFreePortOfTheLoopbackAddressUnlessToldOtherwise() throws IOException {
    try (MockServer server = MockServer.start()) {
      assertThat(server.address().getAddress().isLoopbackAddress()).isTrue();
      assertThat(server.port()).isPositive();
      assertThat(server.config().port()).isZero();
    }
  }

  @Test
  @SuppressWarnings("NullAway") // on purpose
  void refusesNull() {
    assertThatNullPointerException()
        .isThrownBy(() -> MockServer.start((MockServerConfig) null))
        .withMessage("config");
    assertThatNullPointerException()
        .isThrownBy(() -> MockServer.start((Consumer<MockServerConfig.Builder>) null))
        .withMessage("changes");
  }

  @Test
  void namesItsThreads() throws IOException {
    try (MockServer server = MockServer.start();
        RawClient client = new RawClient(server)) {
      client.read("PING");
      String prefix = "mock-server-" + server.port();
      assertThat(threadsOf(server)).containsExactly(prefix + "-accept", prefix + "-client-1");
    }
  }

  @Test
  void hasAThreadForDiscoveryIfThatIsOn() throws IOException {
    MockServer server = MockServer.start(cfg -> cfg.discoveryPort(0));
    String prefix = "mock-server-" + server.port();
    assertThat(threadsOf(server)).containsExactly(prefix + "-accept", prefix + "-discovery");
    server.close();
    assertThat(threadsOf(server)).isEmpty();
  }

  @Test
  void stopsWhileARequestTakesItsTimeAndAnotherWaitsForItsTurn() throws Exception {
    MockServer server = MockServer.start(cfg -> cfg.latency(Latency.fixed(Duration.ofHours(1))));
    try (RawClient served = new RawClient(server);
        RawClient waiting = new RawClient(server)) {
      for (RawClient client : List.of(served, waiting)) {
        client.send("00 00 00 0A 00 00 07 24 4F 56 5F 50 52 4F");
      }
      assertThat(server.takeRequest(Duration.ofSeconds(20))).isPresent();
      server.close();
      assertThat(threadsOf(server)).isEmpty();
      assertThat(served.receiveAll()).isEmpty();
      assertEndsWithoutAnAnswer(waiting);
    }
  }

  /** The connection is reset if the server has not read the request yet. */
  private static void assertEndsWithoutAnAnswer(RawClient client) throws IOException {
    try {
      assertThat(client.receiveAll()).isEmpty();
    } catch (SocketException e) {
      assertThat(e).hasMessage("Connection reset");
    }
  }

  @Test
  void leavesNoThreadAndNoSocketBehind() throws IOException {
    MockServer server = MockServer.start();
    List<RawClient> clients = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      clients.add(new RawClient(server));
      clients.get(i).read("PING");
    }
    server.close();
    assertThat(threadsOf(server)).isEmpty();
    assertThat(server.clientCount()).isZero();
    for (RawClient client : clients) {
      assertThat(client.receiveAll()).isEmpty();
      client.close();
    }
    assertThatThrownBy(() -> new RawClient(server)).isInstanceOf(ConnectException.class);
    try (MockServer next = MockServer.start(cfg -> cfg.port(server.port()))) {
      assertThat(next.port()).isEqualTo(server.port());
    }
  }

  @Test
  void stopsWhileAnswersAreDelayedOrHeld() throws Exception {
    MockServer server = MockServer.start();
    try (RawClient delayed = new RawClient(server);
        RawClient held = new RawClient(server)) {
      server.enqueue(Fault.delay(Duration.ofHours(1)), Fault.hold(new CountDownLatch(1)));
      for (RawClient client : List.of(delayed, held)) {
        client.send("00 09 00 07 00 00 04 50 49 4E 47");
        assertThat(server.takeRequest(Duration.ofSeconds(20))).isPresent();
      }
      server.close();
      assertThat(threadsOf(server)).isEmpty();
      assertThat(delayed.receiveAll()).isEmpty();
      assertThat(held.receiveAll()).isEmpty();
    }
  }

  @Test
  void canBeStoppedTwiceAndByTwoThreads() throws Exception {
    MockServer server = MockServer.start();
    try (RawClient client = new RawClient(server)) {
      client.read("PING");
      Thread other = new Thread(server::close);
      other.start();
      server.close();
      other.join();
      server.close();
      assertThat(threadsOf(server)).isEmpty();
    }
  }

  @Test
  void canBeStoppedByAThreadThatIsInterruptedWhichStaysSo() throws IOException {
    MockServer server = MockServer.start();
    Thread.currentThread().interrupt();
    server.close();
    assertThat(Thread.interrupted()).isTrue();
    assertThat(threadsOf(server)).isEmpty();
  }

  @Test
  void canBeStoppedByOneOfItsOwnThreads() throws IOException {
    MockServer server = MockServer.start();
    server.faults(
        request -> {
          server.close();
          return Optional.empty();
        });
    try (RawClient client = new RawClient(server)) {
      client.send("00 09 00 07 00 00 04 50 49 4E 47");
      assertThat(client.receiveAll()).isEmpty();
    }
    server.close();
    assertThat(threadsOf(server)).isEmpty();
  }

  @Test
  void runsManyAtATimeEachWithVariablesOfItsOwn() throws IOException {
    List<MockServer> servers = new ArrayList<>();
    try {
      Set<Integer> ports = new HashSet<>();
      for (int i = 0; i < 20; i++) {
        servers.add(MockServer.start());
        servers.get(i).variables().set("MYINT", String.valueOf(i));
        ports.add(servers.get(i).port());
      }
      assertThat(ports).hasSize(20);
      for (int i = 0; i < 20; i++) {
        try (RawClient client = new RawClient(servers.get(i))) {
          assertThat(client.read("MYINT").value()).isEqualTo(String.valueOf(i));
        }
      }
    } finally {
      servers.forEach(MockServer::close);
    }
  }

  @Test
  void saysWhichAddressItCannotListenOn() throws IOException {
    try (MockServer server = MockServer.start()) {
      assertThatThrownBy(() -> MockServer.start(cfg -> cfg.port(server.port())))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("cannot listen on")
          .hasMessageContaining(String.valueOf(server.port()));
    }
  }

  // clients

  @Test
  void acceptsTheEleventhClientAndClosesItAtOnce() throws IOException {
    List<RawClient> clients = new ArrayList<>();
    try (MockServer server = MockServer.start()) {
      for (int i = 0; i < 10; i++) {
        clients.add(new RawClient(server));
      }
      try (RawClient eleventh = new RawClient(server)) {
        assertThat(eleventh.receiveAll()).isEmpty();
      }
      for (RawClient client : clients) {
        assertThat(client.read("PING").value()).isEqualTo("PONG");
      }
      clients.remove(0).close();
      awaitClients(server, 9);
      try (RawClient next = new RawClient(server)) {
        assertThat(next.read("PING").value()).isEqualTo("PONG");
      }
    } finally {
      for (RawClient client : clients) {
        client.close();
      }
    }
  }

  @Test
  void servesMoreClientsWhenTheLimitIsLifted() throws IOException {
    List<RawClient> clients = new ArrayList<>();
    try (MockServer server = MockServer.start(cfg -> cfg.maxClients(0))) {
      for (int i = 0; i < 50; i++) {
        clients.add(new RawClient(server));
      }
      for (RawClient client : clients) {
        assertThat(client.read("PING").value()).isEqualTo("PONG");
      }
      assertThat(server.clientCount()).isEqualTo(50);
    } finally {
      for (RawClient client : clients) {
        client.close();
      }
    }
  }

  @Test
  void disconnectsASilentClient() throws IOException {
    try (MockServer server = MockServer.start(cfg -> cfg.idleTimeout(Duration.ofNanos(1)));
        RawClient client = new RawClient(server)) {
      assertThat(client.receiveAll()).isEmpty();
    }
  }

  @Test
  void canKeepSilentClientsForEver() throws IOException {
    try (MockServer server = MockServer.start(cfg -> cfg.idleTimeout(Duration.ZERO));
        RawClient client = new RawClient(server)) {
      assertThat(client.read("PING").value()).isEqualTo("PONG");
    }
  }

  @Test
  void refusesConnectionsUntilItAcceptsThemAgain() throws IOException {
    try (MockServer server = MockServer.start();
        RawClient client = new RawClient(server)) {
      client.read("PING");
      server.refuseConnections();
      server.refuseConnections();
      assertThatThrownBy(() -> new RawClient(server)).isInstanceOf(ConnectException.class);
      assertThat(client.read("PING").value()).isEqualTo("PONG");
      server.acceptConnections();
      server.acceptConnections();
      try (RawClient next = new RawClient(server)) {
        assertThat(next.read("PING").value()).isEqualTo("PONG");
      }
    }
  }

  @Test
  void canBeStoppedWhileItRefusesConnections() throws IOException {
    MockServer server = MockServer.start();
    server.refuseConnections();
    server.close();
    assertThat(threadsOf(server)).isEmpty();
    assertThatThrownBy(server::acceptConnections).isInstanceOf(IllegalStateException.class);
  }

  @Test
  void disconnectsItsClientsAndGoesOnListening() throws IOException {
    try (MockServer server = MockServer.start();
        RawClient client = new RawClient(server)) {
      client.read("PING");
      server.disconnectClients();
      assertThat(client.receiveAll()).isEmpty();
      try (RawClient next = new RawClient(server)) {
        assertThat(next.read("PING").value()).isEqualTo("PONG");
      }
    }
  }

  // order and records

  @Test
  void servesOneRequestAtATimeOverAllClients() throws Exception {
    int clients = 4;
    int each = 500;
    AtomicInteger inside = new AtomicInteger();
    AtomicInteger most = new AtomicInteger();
    ExecutorService threads = Executors.newFixedThreadPool(clients);
    try (MockServer server = MockServer.start()) {
      server.faults(
          request -> {
            most.accumulateAndGet(inside.incrementAndGet(), Math::max);
            inside.decrementAndGet();
            return Optional.empty();
          });
      Callable<Void> task =
          () -> {
            try (RawClient client = new RawClient(server)) {
              for (int i = 0; i < each; i++) {
                assertThat(client.write("MYINT", String.valueOf(i)).tail()).isEqualTo(Tail.SUCCESS);
              }
            }
            return null;
          };
      List<Future<Void>> results = new ArrayList<>();
      for (int i = 0; i < clients; i++) {
        results.add(threads.submit(task));
      }
      for (Future<Void> result : results) {
        result.get();
      }
      assertThat(most).hasValue(1);
      List<RecordedRequest> requests = server.requests();
      assertThat(requests).hasSize(clients * each);
      for (int i = 0; i < requests.size(); i++) {
        assertThat(requests.get(i).number()).isEqualTo(i + 1);
      }
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void recordsWhoAskedWhatAndWhetherItWasRefused() throws Exception {
    try (MockServer server = MockServer.start();
        RawClient first = new RawClient(server)) {
      first.write("MYINT", "5");
      try (RawClient second = new RawClient(server)) {
        second.read("NOTHING");
      }
      RecordedRequest write = server.takeRequest(Duration.ZERO).orElseThrow();
      RecordedRequest read = server.takeRequest(Duration.ZERO).orElseThrow();
      assertThat(server.takeRequest(Duration.ZERO)).isEmpty();
      assertThat(server.requests()).containsExactly(write, read);
      assertThat(write.number()).isEqualTo(1);
      assertThat(write.connection()).isEqualTo(1);
      assertThat(write.name()).isEqualTo("MYINT");
      assertThat(write.value()).isEqualTo("5");
      assertThat(write.isWrite()).isTrue();
      assertThat(write.refusal()).isNull();
      assertThat(read.number()).isEqualTo(2);
      assertThat(read.connection()).isEqualTo(2);
      assertThat(read.value()).isNull();
      assertThat(read.isWrite()).isFalse();
      assertThat(read.refusal()).isEqualTo(Refusal.UNKNOWN_VARIABLE);
      assertThat(read.time()).isAfterOrEqualTo(write.time());
    }
  }

  @Test
  void keepsTheLastRequestsOnly() throws Exception {
    try (MockServer server = MockServer.start(cfg -> cfg.recordedRequests(3));
        RawClient client = new RawClient(server)) {
      for (int i = 1; i <= 5; i++) {
        client.write("MYINT", String.valueOf(i));
      }
      assertThat(server.requests())
          .extracting(RecordedRequest::value)
          .containsExactly("3", "4", "5");
      assertThat(server.requestCount()).isEqualTo(5);
      assertThat(server.takeRequest(Duration.ZERO).orElseThrow().value()).isEqualTo("3");
      server.clearRequests();
      assertThat(server.requests()).isEmpty();
      assertThat(server.takeRequest(Duration.ofNanos(1))).isEmpty();
      client.write("MYINT", "6");
      assertThat(server.requests()).extracting(RecordedRequest::number).containsExactly(6L);
      assertThat(server.takeRequest(Duration.ZERO).orElseThrow().value()).isEqualTo("6");
    }
  }

  @Test
  void keepsTheRequestsThatFitInto16MebibytesUnlessToldOtherwise() throws Exception {
    String value = "x".repeat(60_000);
    try (MockServer server = MockServer.start();
        RawClient client = new RawClient(server)) {
      for (int i = 0; i < 400; i++) {
        client.write("NO", value);
      }
      long kept = server.requests().size();
      assertThat(kept).isBetween(200L, (16L << 20) / 60_000);
      assertThat(server.requests()).last().extracting(RecordedRequest::number).isEqualTo(400L);
      assertThat(server.discardedRequestCount()).isEqualTo(400 - kept);
      assertThat(server.takeRequest(Duration.ZERO).orElseThrow().number()).isEqualTo(401 - kept);
    }
  }

  @Test
  void keepsTheLastRequestHoweverLarge() throws Exception {
    try (MockServer server = MockServer.start(cfg -> cfg.recordedBytes(0));
        RawClient client = new RawClient(server)) {
      client.write("MYINT", "1");
      client.write("MYINT", "2");
      assertThat(server.requests()).extracting(RecordedRequest::value).containsExactly("2");
      server.clearRequests();
      client.write("MYINT", "3");
      assertThat(server.requests()).extracting(RecordedRequest::value).containsExactly("3");
      assertThat(server.discardedRequestCount()).isEqualTo(1);
    }
  }

  @Test
  void canRecordNothing() throws Exception {
    try (MockServer server = MockServer.start(cfg -> cfg.recordedRequests(0));
        RawClient client = new RawClient(server)) {
      client.read("PING");
      assertThat(server.requests()).isEmpty();
      assertThat(server.takeRequest(Duration.ofNanos(1))).isEmpty();
      assertThat(server.requestCount()).isEqualTo(1);
      server.clearRequests();
    }
  }

  @Test
  void recordsTheOtherKindsOfRequestByTheirNames() throws Exception {
    try (MockServer server = MockServer.start();
        RawClient client = new RawClient(server)) {
      client.exchange(new ReadArrayRequest(1, "MYINTS[]"));
      client.exchange(new WriteArrayRequest(2, "MYINTS[]", List.of(1)));
      assertThat(server.requests())
          .extracting(RecordedRequest::name)
          .containsExactly("MYINTS[]", "MYINTS[]");
      assertThat(server.requests())
          .extracting(RecordedRequest::isWrite)
          .containsExactly(false, true);
    }
  }
}
