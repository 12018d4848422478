package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.variables.Struct;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Fails as promised, and never with a value. */
class FailureTest extends RobotTest {
  @Test
  void aRefusedConnectionSaysWhere() {
    int port = robot.port();
    robot.close();

    assertThatExceptionOfType(CrossComConnectException.class)
        .isThrownBy(() -> new CrossComClient("127.0.0.1", port))
        .withMessageStartingWith("could not connect to 127.0.0.1:" + port);
    assertThatExceptionOfType(CrossComConnectException.class)
        .isThrownBy(() -> new CrossComClient("::1", port))
        .withMessageStartingWith("could not connect to [::1]:" + port);
  }

  @Test
  void anUnknownHostSaysSo() {
    assertThatExceptionOfType(CrossComConnectException.class)
        .isThrownBy(() -> new CrossComClient("no-such-host.invalid", 7000))
        .withMessageContaining("the host name is unknown")
        .withCauseInstanceOf(UnknownHostException.class);
  }

  @Test
  void connectingTakesNoLongerThanItsLimit() throws Exception {
    // a full backlog makes the system drop the request to connect
    try (ServerSocket full = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      ClientConfig config =
          ClientConfig.create(
              full.getInetAddress().getHostAddress(),
              cfg -> cfg.port(full.getLocalPort()).connectTimeout(SHORT));
      assertThatExceptionOfType(CrossComConnectException.class)
          .isThrownBy(
              () -> {
                for (int i = 0; i < 10; i++) {
                  // not closed on purpose: they fill the backlog, and end with the server socket
                  @SuppressWarnings("resource")
                  CrossComClient filler = new CrossComClient(config);
                  assertThat(filler.isClosed()).isFalse();
                }
              })
          .withMessageContaining("no answer within 100 ms");
    }
  }

  @Test
  void aStalledReadTimesOutAndClosesTheConnection() throws Exception {
    robot.enqueue(Fault.drop());
    try (CrossComClient hasty = client(SHORT)) {
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> hasty.readText("$OV_PRO"))
          .withMessage("no answer to the read of $OV_PRO within 100 ms; the connection is closed")
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
      assertThat(hasty.isClosed()).isTrue();
    }
  }

  @Test
  void aStalledWriteSaysThatItsOutcomeIsUnknownAndIsNotRepeated() throws Exception {
    robot.enqueue(Fault.dropAnswer());
    try (CrossComClient hasty = client(SHORT)) {
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> hasty.writeText("MYINT", "5"))
          .withMessageContaining("the outcome is unknown")
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
    }
    assertThat(robot.requests()).hasSize(1);
    assertThat(robot.variables().get("MYINT")).isEqualTo("5");
  }

  @Test
  void aSlowServerThatSendsByteByByteDoesNotStretchTheLimit() throws Exception {
    // 13 bytes, each in time, but not all of them together
    robot.enqueue(Fault.oneByteAtATime(Duration.ofMillis(80)));
    try (CrossComClient hasty = client(Duration.ofMillis(200))) {
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> hasty.readText("$OV_PRO"));
    }
  }

  @Test
  void aLateAnswerIsNeverTakenForAnothers() throws Exception {
    CountDownLatch release = new CountDownLatch(1);
    robot.enqueue(Fault.hold(release));
    try (CrossComClient hasty = client(SHORT)) {
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> hasty.readText("$OV_PRO"));
      release.countDown();
      assertThatExceptionOfType(CrossComException.class)
          .isThrownBy(() -> hasty.readText("$OV_JOG"));
    }
  }

  @Test
  void aMessageLeavesOutTheMiddleOfALongNameAndKeepsTheEnd() {
    robot.enqueue(Fault.closeBefore());

    assertThatExceptionOfType(CrossComException.class)
        .isThrownBy(() -> client.writeText("A".repeat(5000), "5"))
        .withMessageContaining("AAA... (")
        .withMessageContaining(" characters) ...")
        .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(2200));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> Struct.parseString("\"" + "A".repeat(5000) + "\""))
        .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(2200));
  }

  @Test
  void theTimeLimitCanBeSetAsOnASocket() throws Exception {
    assertThat(client.getSoTimeout()).isEqualTo((int) LONG.toMillis());
    client.setSoTimeout(50);
    assertThat(client.getSoTimeout()).isEqualTo(50);
    robot.enqueue(Fault.drop());

    assertThatExceptionOfType(CrossComTimeoutException.class)
        .isThrownBy(() -> client.readText("$OV_PRO"))
        .withMessageContaining("within 50 ms");
    assertThatIllegalArgumentException().isThrownBy(() -> client.setSoTimeout(-1));
  }

  @Test
  void aLimitOfZeroWaitsForEver() throws Exception {
    client.setSoTimeout(0);
    robot.enqueue(Fault.delay(Duration.ofMillis(200)));

    assertThat(client.readText("$OV_PRO")).isEqualTo("100");
  }

  @Test
  void manyFastExchangesUnderAShortLimitDoNotTimeOut() throws Exception {
    // enough for the timer to look several times and to rest
    try (CrossComClient hasty = client(Duration.ofSeconds(1))) {
      KRLInt i = new KRLInt("MYINT");
      for (int n = 0; n < 30_000; n++) {
        hasty.readVariable(i);
      }
      robot.enqueue(Fault.drop());
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> hasty.readVariable(i));
    }
  }

  static Stream<Fault> lies() {
    return Stream.of(
        Fault.wrongId(),
        Fault.wrongFunction(2),
        Fault.wrongFunction(200),
        Fault.wrongLength(-1),
        Fault.wrongLength(-3),
        Fault.emptyAnswer(),
        Fault.raw("00 01 00 09 00 00 04 31 30 30 00 01 01"),
        Fault.raw("00 01 00 09 00 00 02 31 30 30 00 01 01"),
        Fault.raw("00 01 00 03 00 00 00"),
        Fault.raw("00 01 00 05 00 00 00 00 01"),
        Fault.raw("FF FF 00 01 00"));
  }

  @ParameterizedTest
  @MethodSource("lies")
  void aWrongAnswerIsAProtocolErrorWithItsBytesAndClosesTheConnection(Fault lie) throws Exception {
    robot.enqueue(lie);

    assertThatExceptionOfType(CrossComProtocolException.class)
        .isThrownBy(() -> client.readText("$OV_PRO"))
        .withMessageContaining("frame: ");
    assertThat(client.isClosed()).isTrue();
    assertThatExceptionOfType(CrossComException.class).isThrownBy(() -> client.readText("$OV_PRO"));
  }

  @Test
  void theMessageShowsTheFirst32BytesOfALongAnswer() {
    robot.enqueue(Fault.raw("00 01 01 00 09" + " 41".repeat(255)));

    assertThatExceptionOfType(CrossComProtocolException.class)
        .isThrownBy(() -> client.readText("$OV_PRO"))
        .withMessageMatching(".* [0-9A-F]{2}( [0-9A-F]{2}){31} \\.\\.\\. \\(260 bytes\\)");
  }

  @ParameterizedTest
  @MethodSource("lies")
  void aWrongAnswerToAWriteLeavesItsOutcomeUnknown(Fault lie) throws Exception {
    robot.enqueue(lie);

    assertThatExceptionOfType(CrossComProtocolException.class)
        .isThrownBy(() -> client.writeText("$OV_PRO", "50"))
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
    assertThat(robot.requests()).hasSize(1);
  }

  static Stream<Fault> breaks() {
    return Stream.of(
        Fault.closeBefore(),
        Fault.resetBefore(),
        Fault.closeDuring(1),
        Fault.closeDuring(4),
        Fault.closeDuring(11));
  }

  @ParameterizedTest
  @MethodSource("breaks")
  void aBrokenConnectionIsLostAndAWritesOutcomeUnknown(Fault fault) throws Exception {
    robot.enqueue(fault);
    assertThatExceptionOfType(CrossComConnectionLostException.class)
        .isThrownBy(() -> client.writeText("$OV_PRO", "50"))
        .withMessageContaining("write of $OV_PRO")
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isTrue());
    assertThat(client.isClosed()).isTrue();
    assertThat(robot.requests()).hasSize(1);

    robot.enqueue(fault);
    try (CrossComClient other = client(LONG)) {
      assertThatExceptionOfType(CrossComConnectionLostException.class)
          .isThrownBy(() -> other.readText("$OV_PRO"))
          .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());
    }
  }

  @Test
  void aTruncatedAnswerTimesOut() throws Exception {
    robot.enqueue(Fault.truncate(10));
    try (CrossComClient hasty = client(SHORT)) {
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> hasty.readText("$OV_PRO"));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
  void garbageIsNeverAValue(long seed) throws Exception {
    robot.enqueue(Fault.garbage(seed, 40));
    // the client waits for the rest of garbage with too large a length
    try (CrossComClient hasty = client(Duration.ofMillis(20))) {
      assertThatExceptionOfType(CrossComException.class)
          .isThrownBy(() -> hasty.readText("$OV_PRO"));
      assertThat(hasty.isClosed()).isTrue();
    }
  }

  @Test
  void aClosedClientSaysSo() throws Exception {
    client.close();
    client.close();

    assertThatExceptionOfType(CrossComClosedException.class)
        .isThrownBy(() -> client.readText("$OV_PRO"))
        .withMessage("the client is closed");
    assertThat(client.isClosed()).isTrue();
    assertThat(client.isConnected()).as("as a Socket that was connected").isTrue();
  }

  @Test
  void closingEndsAnExchangeUnderWay() throws Exception {
    CountDownLatch never = new CountDownLatch(1);
    CountDownLatch asked = new CountDownLatch(1);
    robot.faults(
        request -> {
          asked.countDown();
          return java.util.Optional.of(Fault.hold(never));
        });
    ExecutorService pool = Executors.newSingleThreadExecutor();
    try {
      Future<?> read = pool.submit(() -> client.readText("$OV_PRO"));
      asked.await();
      client.close();

      assertThatExceptionOfType(java.util.concurrent.ExecutionException.class)
          .isThrownBy(read::get)
          .withCauseInstanceOf(CrossComClosedException.class);
    } finally {
      never.countDown();
      pool.shutdownNow();
    }
  }

  @Test
  void aReadThatWaitsTooLongForItsTurnSendsNothingAndLeavesTheConnection() throws Exception {
    HeldRead held = holdRead();
    client.setSoTimeout((int) SHORT.toMillis());

    assertThatExceptionOfType(CrossComTimeoutException.class)
        .isThrownBy(() -> client.writeText("MYINT", "5"))
        .withMessage("the write of MYINT waited 100 ms for other accesses to end; nothing was sent")
        .satisfies(e -> assertThat(e.isOutcomeUnknown()).isFalse());

    assertThat(held.end()).isEqualTo("100");
    assertThat(client.readText("MYINT")).isEqualTo("0");
    assertThat(requests()).hasSize(2);
  }

  @Test
  void aReadThatWaitsForItsTurnCanBeInterrupted() throws Exception {
    HeldRead held = holdRead();
    Thread reader = Thread.currentThread();
    ExecutorService pool = Executors.newSingleThreadExecutor();
    try {
      pool.execute(
          () -> {
            while (LockSupport.getBlocker(reader) == null) {
              Thread.onSpinWait();
            }
            reader.interrupt();
          });
      assertThatExceptionOfType(CrossComConnectionLostException.class)
          .isThrownBy(() -> client.readText("MYINT"))
          .withMessage("the thread was interrupted before the read of MYINT; nothing was sent");
      assertThat(Thread.interrupted()).isTrue();
    } finally {
      pool.shutdownNow();
    }
    assertThat(held.end()).isEqualTo("100");
    assertThat(client.readText("$OV_PRO")).isEqualTo("100");
  }

  /** A read of {@code $OV_PRO} in another thread, whose answer the server holds back. */
  private record HeldRead(Future<String> read, CountDownLatch released, ExecutorService pool) {
    String end() throws Exception {
      released.countDown();
      pool.shutdown();
      return read.get();
    }
  }

  private HeldRead holdRead() throws Exception {
    CountDownLatch asked = new CountDownLatch(1);
    CountDownLatch released = new CountDownLatch(1);
    robot.faults(
        request -> {
          boolean first = asked.getCount() > 0;
          asked.countDown();
          return first ? Optional.of(Fault.hold(released)) : Optional.empty();
        });
    ExecutorService pool = Executors.newSingleThreadExecutor();
    Future<String> read = pool.submit(() -> client.readText("$OV_PRO"));
    asked.await();
    return new HeldRead(read, released, pool);
  }

  @Test
  void aClosedClientLeavesNoThreadBehind() throws Exception {
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    ClientRuntime runtime = ClientRuntime.create(cfg -> {});
    CrossComClient its = client(cfg -> cfg.runtime(runtime).keepAlive(LONG));
    assertThat(its.readText("$OV_PRO")).isEqualTo("100");
    List<Thread> started =
        Thread.getAllStackTraces().keySet().stream()
            .filter(t -> t.getName().startsWith("crosscom-") && !before.contains(t))
            .toList();
    assertThat(started).isNotEmpty().allMatch(Thread::isDaemon);
    its.close();
    runtime.close();
    for (Thread thread : started) {
      thread.join();
    }
  }

  @Test
  void theSocketsAddressesCanBeAsked() throws Exception {
    assertThat(client.getInetAddress()).isEqualTo(robot.address().getAddress());
    assertThat(client.getPort()).isEqualTo(robot.port());
    assertThat(client.getLocalPort()).isBetween(1, 65_535).isNotEqualTo(robot.port());
    assertThat(client.isConnected()).isTrue();
    assertThat(client.isClosed()).isFalse();
    assertThat(client).hasToString("CrossComClient{" + robot.host() + ":" + robot.port() + "}");
  }

  @Test
  void theEleventhClientIsToldThatTheConnectionWasClosed() throws Exception {
    try (MockServer full = MockServer.start(cfg -> cfg.maxClients(1));
        CrossComClient first = new CrossComClient(full.host(), full.port())) {
      assertThat(first.readText("PING")).isEqualTo("PONG");
      assertThatExceptionOfType(CrossComConnectionLostException.class)
          .isThrownBy(
              () -> {
                try (CrossComClient second = new CrossComClient(full.host(), full.port())) {
                  second.readText("$OV_PRO");
                }
              })
          .withMessageMatching(
              ".* broke (before the first request|during the read of \\$OV_PRO): .*the server"
                  + " closed it before it answered anything.*KUKAVARPROXY takes 10.*");
    }
  }

  @Test
  void configurationsAreCheckedFieldByField() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ClientConfig.create(" ", cfg -> {}))
        .withMessage("host must not be blank");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new CrossComClient("127.0.0.1", 0))
        .withMessage("port must be 1 to 65535, is 0");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new CrossComClient("127.0.0.1", 65_536))
        .withMessage("port must be 1 to 65535, is 65536");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ClientConfig.create("h", cfg -> cfg.connectTimeout(Duration.ZERO)))
        .withMessageContaining("connect time-out");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ClientConfig.create("h", cfg -> cfg.requestTimeout(Duration.ofNanos(5))))
        .withMessage("request time-out must be 0 or 1 to 2147483647 ms, is PT0.000000005S");
    assertThatIllegalArgumentException()
        .isThrownBy(
            () ->
                ClientConfig.create(
                    "h", cfg -> cfg.reconnectBackoff(Duration.ofSeconds(2), Duration.ofSeconds(1))))
        .withMessage("maximum reconnect backoff must be at least PT2S, is PT1S");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> ClientConfig.create("h", cfg -> cfg.maxRequestLength(15)));
    ClientConfig defaults = ClientConfig.create("h", cfg -> {});
    assertThat(defaults.port()).isEqualTo(7000);
    assertThat(defaults.connectTimeout()).isEqualTo(Duration.ofSeconds(5));
    assertThat(defaults.requestTimeout()).isEqualTo(Duration.ofSeconds(3));
    assertThat(defaults.maxAggregateLength()).isEqualTo(255);
    assertThat(defaults.keepAlive()).isEqualTo(Duration.ofSeconds(10));
    assertThat(defaults.reconnect()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"5\n", "5\r\nX", "5\0", "\"a\"\n"})
  void aValueOfSeveralLinesIsNotSent(String value) {
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.writeText("MYINT", value))
        .withMessageContaining("must be one line, has U+00")
        .returns(false, CrossComValueException::isSent);
    assertThatExceptionOfType(CrossComValueException.class)
        .isThrownBy(() -> client.checkText("MYINT", value));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> client.readText("MYINT" + value))
        .withMessageContaining("must not have a line break or NUL, has U+00");
    assertThat(robot.requestCount()).isZero();
  }

  @Test
  void aTextCanHaveALineBreak() throws Exception {
    client.writeText("MYSTRING[]", "\"a\nb\"");

    assertThat(robot.variables().get("MYSTRING[]")).isEqualTo("\"a\nb\"");
  }
}
