package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import no.hials.crosscom.ConnectionEvent.ConnectionChange;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.Tail;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Survives what breaks a connection. */
class ReconnectTest extends RobotTest {
  private static final Duration TINY = Duration.ofMillis(1);

  private CrossComClient steady(Duration requestTimeout) throws Exception {
    return client(cfg -> cfg.requestTimeout(requestTimeout).reconnectBackoff(TINY, TINY));
  }

  static Stream<Fault> breaks() {
    return Stream.of(
        Fault.closeBefore(),
        Fault.resetBefore(),
        Fault.closeDuring(1),
        Fault.closeDuring(4),
        Fault.closeDuring(10));
  }

  @ParameterizedTest
  @MethodSource("breaks")
  void aReadWhoseConnectionBreaksIsRepeatedOnce(Fault fault) throws Exception {
    try (CrossComClient its = steady(LONG)) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      robot.enqueue(fault);
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
    }
    assertThat(robot.requests()).hasSize(3);
  }

  @ParameterizedTest
  @MethodSource("breaks")
  void aReadThatBreaksTwiceFails(Fault fault) throws Exception {
    try (CrossComClient its = steady(LONG)) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      robot.enqueue(fault, fault);
      assertThatExceptionOfType(CrossComConnectionLostException.class)
          .isThrownBy(() -> its.readText("$OV_PRO"));
      assertThat(robot.requests()).hasSize(3);
    }
  }

  @ParameterizedTest
  @MethodSource("breaks")
  void aWriteWhoseConnectionBreaksIsNotRepeatedAndTheNextCallWorks(Fault fault) throws Exception {
    try (CrossComClient its = steady(LONG)) {
      assertThat(its.readText("MYINT")).isEqualTo("0");
      robot.enqueue(fault);
      assertThatExceptionOfType(CrossComConnectionLostException.class)
          .isThrownBy(() -> its.writeText("MYINT", "5"))
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
      assertThat(robot.requests()).filteredOn(r -> r.isWrite()).hasSize(1);
      assertThat(its.readText("MYINT")).isEqualTo(fault.executes() ? "5" : "0");
    }
  }

  @Test
  void afterATimeOutALateAnswerIsNotTakenAndTheClientIsUsable() throws Exception {
    CountDownLatch release = new CountDownLatch(1);
    robot.variables().set("$OV_JOG", "7");
    try (CrossComClient its = steady(SHORT)) {
      robot.enqueue(Fault.hold(release));
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> its.readText("$OV_PRO"));
      release.countDown();
      its.setSoTimeout(0);
      assertThat(its.readText("$OV_JOG")).isEqualTo("7");
    }
  }

  @Test
  void bytesThatNobodyAskedForAreNotTakenForAnAnswerAndNothingIsLost() throws Exception {
    try (CrossComClient its = steady(LONG)) {
      robot.enqueue(Fault.answerTwice());
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      its.writeText("MYINT", "3");
      assertThat(its.readText("MYINT")).isEqualTo("3");
    }
    assertThat(robot.requests()).as("the write was sent once").hasSize(3);
  }

  @Test
  void aConnectionThatTheServerClosedWhileIdleDoesNotCostAWrite() throws Exception {
    try (CrossComClient its = steady(LONG)) {
      robot.enqueue(Fault.closeAfter());
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      awaitNoClientButOne();
      its.writeText("MYINT", "4");
      assertThat(robot.variables().get("MYINT")).isEqualTo("4");
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {100, 2037, 2038, 2039, 3000, 60_000})
  void aLongAnswerDoesNotHideThatTheServerClosedTheConnection(int length) throws Exception {
    try (CrossComClient its = steady(LONG)) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      String value = "7".repeat(length);
      robot.enqueue(Fault.answer(value, Tail.SUCCESS));
      assertThat(its.readText("MYINTS[]")).isEqualTo(value);
      int port = its.getLocalPort();
      robot.disconnectClients();
      client.close();
      client = client(LONG);
      awaitNoClientButOne();
      its.writeText("MYINT", "4");
      assertThat(its.getLocalPort()).as("a new connection").isNotEqualTo(port);
    }
    assertThat(robot.variables().get("MYINT")).isEqualTo("4");
  }

  @Test
  void aClosedClientLeavesNoKeepAliveThreadBehind() throws Exception {
    for (int i = 0; i < 100; i++) {
      try (MockServer other = MockServer.start()) {
        // a client of another test may still try to reach a server that had the same port
        Set<Thread> before = Thread.getAllStackTraces().keySet();
        CrossComClient its = new CrossComClient(other.host(), other.port());
        its.readText("$OV_PRO");
        String name = "crosscom-keepalive-" + other.port();
        Optional<Thread> keeper =
            Thread.getAllStackTraces().keySet().stream()
                .filter(t -> t.getName().equals(name) && !before.contains(t))
                .findAny();
        its.close();
        if (keeper.isPresent()) {
          // the default keep-alive time is 10 s: a thread that missed the end would wait for it
          keeper.get().join(5_000);
          assertThat(keeper.get().isAlive()).isFalse();
        }
      }
    }
  }

  /** Waits until only the client of the base class is there, and long enough to count as idle. */
  private void awaitNoClientButOne() throws Exception {
    while (robot.clientCount() > 1) {
      Thread.onSpinWait();
    }
    // an exchange of another client that takes longer than a pause that counts as idle
    robot.enqueue(Fault.delay(Duration.ofMillis(50)));
    client.readText("$OV_PRO");
  }

  @Test
  void aWriteThatCouldNotBeSentSaysThatNothingWasWritten() throws Exception {
    try (CrossComClient its = steady(LONG)) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      robot.enqueue(Fault.closeAfter());
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      robot.refuseConnections();
      awaitNoClientButOne();
      for (int i = 0; i < 3; i++) {
        assertThatExceptionOfType(CrossComConnectException.class)
            .isThrownBy(() -> its.writeText("MYINT", "4"))
            .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
      }
    }
    assertThat(robot.requests()).noneMatch(r -> r.isWrite());
  }

  @Test
  void whileBackingOffACallFailsAtOnceAndSaysHowLong() throws Exception {
    try (CrossComClient its =
        client(cfg -> cfg.reconnectBackoff(Duration.ofHours(1), Duration.ofHours(1)))) {
      robot.refuseConnections();
      robot.disconnectClients();
      assertThatExceptionOfType(CrossComException.class).isThrownBy(() -> its.readText("$OV_PRO"));
      assertThatExceptionOfType(CrossComConnectException.class)
          .isThrownBy(() -> its.readText("$OV_PRO"))
          .withMessageMatching(
              "not connected, and the next attempt is in \\d+ ms; the last one: .*");
    }
  }

  @Test
  void theOutcomeOfALostWriteIsNotThatOfTheNextOne() throws Exception {
    try (CrossComClient its =
        client(cfg -> cfg.reconnectBackoff(Duration.ofHours(1), Duration.ofHours(1)))) {
      robot.enqueue(Fault.closeBefore()); // before any answer, so that the client waits
      assertThatExceptionOfType(CrossComConnectionLostException.class)
          .isThrownBy(() -> its.writeText("MYINT", "4"))
          .withMessageContaining("the outcome is unknown");

      assertThatExceptionOfType(CrossComConnectException.class)
          .isThrownBy(() -> its.writeText("MYINT", "5"))
          .withMessageMatching(
              "not connected, and the next attempt is in \\d+ ms; the last one: .*MYINT.*")
          .withMessageNotContaining("outcome")
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
    }
  }

  @Test
  void theBackoffGrowsAndIsCapped() throws Exception {
    try (CrossComClient its = client(cfg -> cfg.reconnectBackoff(TINY, Duration.ofHours(1)))) {
      robot.refuseConnections();
      robot.disconnectClients();
      long longest = 0;
      // each attempt doubles the wait, so a few are enough to see it grow
      for (int attempts = 0; longest < 200; ) {
        try {
          its.readText("$OV_PRO");
        } catch (CrossComConnectException e) {
          java.util.regex.Matcher wait =
              java.util.regex.Pattern.compile("next attempt is in (\\d+) ms")
                  .matcher(e.getMessage());
          if (wait.find()) {
            longest = Math.max(longest, Long.parseLong(wait.group(1)));
          }
          assertThat(attempts++).isLessThan(100_000_000);
        } catch (CrossComConnectionLostException e) {
          assertThat(longest).isZero();
        }
      }
      assertThat(longest).isBetween(200L, 800L);
    }
  }

  @Test
  void theListenerHearsOfConnectsLossesAndReconnects() throws Exception {
    BlockingQueue<ConnectionEvent> events = new LinkedBlockingQueue<>();
    try (CrossComClient its =
        client(cfg -> cfg.reconnectBackoff(TINY, TINY).listener(events::add))) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      robot.enqueue(Fault.closeBefore());
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
    }
    List<ConnectionChange> kinds = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      ConnectionEvent event = events.poll(60, TimeUnit.SECONDS);
      assertThat(event).isNotNull();
      kinds.add(event.kind());
      assertThat(event.cause() != null).isEqualTo(event.kind() == ConnectionChange.LOST);
    }
    assertThat(kinds)
        .containsExactly(
            ConnectionChange.CONNECTED,
            ConnectionChange.LOST,
            ConnectionChange.RECONNECTED,
            ConnectionChange.CLOSED);
  }

  @Test
  void aListenerThatThrowsOrBlocksDisturbsNothing() throws Exception {
    CountDownLatch never = new CountDownLatch(1);
    AtomicInteger calls = new AtomicInteger();
    try (CrossComClient its =
        client(
            cfg ->
                cfg.reconnectBackoff(TINY, TINY)
                    .listener(
                        event -> {
                          if (calls.getAndIncrement() == 0) {
                            throw new IllegalStateException("on purpose");
                          }
                          try {
                            never.await();
                          } catch (InterruptedException e) {
                            Thread.currentThread().interrupt();
                          }
                        }))) {
      for (int i = 0; i < 3; i++) {
        assertThat(its.readText("$OV_PRO")).isEqualTo("100");
        robot.enqueue(Fault.closeBefore());
      }
    } finally {
      never.countDown();
    }
  }

  @Test
  void keepAliveHoldsAnIdleConnection() throws Exception {
    try (MockServer strict = MockServer.start(cfg -> cfg.idleTimeout(Duration.ofSeconds(1)));
        CrossComClient its =
            new CrossComClient(
                ClientConfig.create(
                    strict.host(),
                    cfg -> cfg.port(strict.port()).keepAlive(Duration.ofMillis(60))))) {
      int port = its.getLocalPort();
      // twenty times 60 ms are above the 1000
      for (int i = 0; i < 20; i++) {
        assertThat(strict.takeRequest(Duration.ofSeconds(60)))
            .hasValueSatisfying(r -> assertThat(r.name()).isEqualTo("PING"));
      }
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      assertThat(its.getLocalPort()).as("still the same connection").isEqualTo(port);
    }
  }

  @Test
  void keepAliveMakesALostConnectionAnewBeforeItIsNeeded() throws Exception {
    BlockingQueue<ConnectionEvent> events = new LinkedBlockingQueue<>();
    try (CrossComClient its =
        client(
            cfg ->
                cfg.keepAlive(Duration.ofMillis(30))
                    .reconnectBackoff(TINY, TINY)
                    .listener(events::add))) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      robot.disconnectClients();
      ConnectionEvent event;
      do {
        event = events.poll(60, TimeUnit.SECONDS);
        assertThat(event).isNotNull();
      } while (event.kind() != ConnectionChange.RECONNECTED);
      its.writeText("MYINT", "6");
    }
    assertThat(robot.variables().get("MYINT")).isEqualTo("6");
  }

  @Test
  void noTrafficIsAddedWhileTheProgramMakesSome() throws Exception {
    try (CrossComClient its = client(cfg -> cfg.keepAlive(Duration.ofSeconds(30)))) {
      for (int i = 0; i < 1000; i++) {
        its.readText("$OV_PRO");
      }
    }
    assertThat(robot.requests()).noneMatch(r -> r.name().equals("PING"));
  }

  @Test
  void anInterruptedThreadSendsNothingAndKeepsItsFlag() throws Exception {
    try (CrossComClient its = steady(LONG)) {
      assertThat(its.readText("MYINT")).isEqualTo("0");
      int port = its.getLocalPort();
      Thread.currentThread().interrupt();
      assertThatExceptionOfType(CrossComException.class)
          .isThrownBy(() -> its.writeText("MYINT", "5"))
          .withMessageContaining("the thread was interrupted")
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
      assertThat(Thread.interrupted()).isTrue();
      assertThat(its.readText("MYINT")).isEqualTo("0");
      assertThat(its.getLocalPort()).as("still the same connection").isEqualTo(port);
    }
  }

  @Test
  void aCallThatIsInterruptedWhileItWaitsFailsAndIsNotRepeated() throws Exception {
    CountDownLatch never = new CountDownLatch(1);
    Thread caller = Thread.currentThread();
    try (CrossComClient its = steady(LONG)) {
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      robot.clearRequests();
      robot.faults(
          request -> {
            caller.interrupt();
            return Optional.of(Fault.hold(never));
          });
      assertThatExceptionOfType(CrossComException.class)
          .isThrownBy(() -> its.readText("$OV_PRO"))
          .withMessageContaining("the thread was interrupted");
      assertThat(Thread.interrupted()).isTrue();
      never.countDown();
      robot.clearFaults();
      assertThat(its.readText("$OV_PRO")).isEqualTo("100");
      assertThat(robot.requests()).as("the interrupted one and this").hasSize(2);
    }
  }

  @Test
  void closingEndsConnecting() throws Exception {
    // a server that takes one connection and leaves further ones in a full queue
    try (ServerSocket full = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      BlockingQueue<ConnectionEvent> events = new LinkedBlockingQueue<>();
      CrossComClient its =
          new CrossComClient(
              ClientConfig.create(
                  full.getInetAddress().getHostAddress(),
                  cfg ->
                      cfg.port(full.getLocalPort())
                          .connectTimeout(LONG)
                          .keepAlive(Duration.ZERO)
                          .listener(events::add)));
      List<Socket> fillers = new ArrayList<>();
      for (int i = 0; i < 10; i++) {
        Socket filler = new Socket();
        fillers.add(filler);
        try {
          filler.connect(full.getLocalSocketAddress(), 50);
        } catch (SocketTimeoutException e) {
          break; // now it is full
        }
      }
      full.accept().close();
      CompletableFuture<String> read = its.async(c -> c.readText("$OV_PRO"));
      ConnectionEvent event;
      do {
        event = events.poll(60, TimeUnit.SECONDS);
        assertThat(event).isNotNull();
      } while (event.kind() != ConnectionChange.LOST);
      its.close();

      assertThatExceptionOfType(ExecutionException.class)
          .isThrownBy(() -> read.get(30, TimeUnit.SECONDS));
      for (Socket filler : fillers) {
        filler.close();
      }
    }
  }

  @Test
  void fifteenThousandRequestsUnderRandomFaultsGiveRightValuesOrExceptionsAndNoWriteTwice()
      throws Exception {
    for (int n = 1; n <= 10; n++) {
      robot.variables().set("MYINTS[" + n + "]", String.valueOf(n));
    }
    Random random = new Random(20_261_121);
    robot.faults(request -> randomFault(random));
    int right = 0;
    int failed = 0;
    int known = 0;
    try (CrossComClient its =
        client(cfg -> cfg.requestTimeout(Duration.ofMillis(20)).reconnectBackoff(TINY, TINY))) {
      KRLInt counter = new KRLInt("MYINT");
      for (int i = 1; i <= 15_000; i++) {
        String own = "MYINTS[" + (i % 10 + 1) + "]";
        try {
          if (i % 2 == 0) {
            // every write has a value of its own, so that one executed twice would show
            counter.setValue(i);
            its.writeVariable(counter);
            known = i;
            right++;
          } else {
            int value = Integer.parseInt(its.readText(own));
            assertThat(value).isEqualTo(i % 10 + 1);
            right++;
          }
        } catch (CrossComException e) {
          failed++;
        }
      }
    }
    assertThat(right).isGreaterThan(12_000);
    assertThat(failed).isGreaterThan(300);
    assertThat(known).isPositive();
    assertThat(robot.requests())
        .filteredOn(r -> r.isWrite())
        .extracting(r -> r.value())
        .as("no write was sent twice")
        .doesNotHaveDuplicates();
  }

  private static Optional<Fault> randomFault(Random random) {
    return switch (random.nextInt(240)) {
      case 0 -> Optional.of(Fault.drop());
      case 1 -> Optional.of(Fault.dropAnswer());
      case 2 -> Optional.of(Fault.closeBefore());
      case 3 -> Optional.of(Fault.closeDuring(random.nextInt(12)));
      case 4 -> Optional.of(Fault.closeAfter());
      case 5 -> Optional.of(Fault.delay(Duration.ofMillis(random.nextInt(30))));
      case 6 -> Optional.of(Fault.wrongId());
      case 7 -> Optional.of(Fault.wrongFunction(random.nextInt(256)));
      case 8 -> Optional.of(Fault.wrongLength(random.nextInt(20) - 10));
      case 9 -> Optional.of(Fault.truncate(random.nextInt(12)));
      case 10 -> Optional.of(Fault.garbage(random.nextLong(), random.nextInt(40)));
      case 11 -> Optional.of(Fault.answerTwice());
      case 12 -> Optional.of(Fault.oneByteAtATime());
      case 13 -> Optional.of(Fault.resetBefore());
      case 14 -> Optional.of(Fault.emptyAnswer());
      case 15 -> Optional.of(Fault.split(1 + random.nextInt(10)));
      default -> Optional.empty();
    };
  }
}
