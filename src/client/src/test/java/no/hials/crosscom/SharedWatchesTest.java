package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.net.ServerSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.stream.Stream;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlString;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Watches many robots in the threads of one runtime. */
class SharedWatchesTest extends RobotTest {
  private static final Duration PERIOD = Duration.ofMillis(5);
  private static final int CLIENTS = 200;
  private static final int LISTENER_THREADS = 4;

  private final ClientRuntime runtime =
      ClientRuntime.create(cfg -> cfg.listenerThreads(LISTENER_THREADS));
  private final BlockingQueue<Sample> samples = new LinkedBlockingQueue<>();

  @AfterEach
  void closeRuntime() {
    runtime.close();
  }

  private CrossComClient clientOf(MockServer of) throws Exception {
    return client(cfg -> cfg.port(of.port()).runtime(runtime));
  }

  private Sample next() throws InterruptedException {
    Sample sample = samples.poll(60, TimeUnit.SECONDS);
    assertThat(sample).as("a sample within a minute").isNotNull();
    return sample;
  }

  @Test
  void twoHundredWatchesNeedTheThreadsOfOneRuntime() throws Exception {
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    List<CrossComClient> clients = new ArrayList<>();
    AtomicIntegerArray counts = new AtomicIntegerArray(CLIENTS);
    CountDownLatch all = new CountDownLatch(CLIENTS);
    try (MockServer many = MockServer.start(cfg -> cfg.server(server).maxClients(CLIENTS))) {
      for (int i = 0; i < CLIENTS; i++) {
        int number = i;
        CrossComClient its = clientOf(many);
        clients.add(its);
        its.watch(
            Duration.ofMillis(50),
            sample -> {
              if (counts.incrementAndGet(number) == 3) {
                all.countDown();
              }
            },
            "$AXIS_ACT",
            "$OV_PRO");
      }
      assertThat(all.await(60, TimeUnit.SECONDS)).isTrue();
      long threads =
          Thread.getAllStackTraces().keySet().stream()
              .filter(t -> t.getName().startsWith("crosscom-") && !before.contains(t))
              .count();

      assertThat(threads)
          .as("a timer, a selector, two samplers and listeners")
          .isLessThanOrEqualTo(4 + LISTENER_THREADS);
    } finally {
      for (CrossComClient its : clients) {
        its.close();
      }
    }
  }

  @Test
  void serversThatNeverAnswerDelayNoOther() throws Exception {
    List<CrossComClient> clients = new ArrayList<>();
    AtomicInteger ofSilent = new AtomicInteger();
    try (MockServer silent = MockServer.start(cfg -> cfg.server(server).maxClients(50))) {
      silent.fault(request -> true, Fault.dropAnswer());
      for (int i = 0; i < 50; i++) {
        CrossComClient its = clientOf(silent);
        clients.add(its);
        its.watch(PERIOD, sample -> ofSilent.incrementAndGet(), "$OV_PRO");
      }
      while (silent.requestCount() < 50) {
        Thread.onSpinWait();
      }
      try (CrossComClient its = clientOf(robot);
          Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO")) {
        for (int i = 0; i < 20; i++) {
          assertThat(next().value("$OV_PRO")).isEqualTo(new KrlInt(100));
        }
        assertThat(watch.failedPolls()).isZero();
      }
      assertThat(ofSilent).hasValue(0);
    } finally {
      for (CrossComClient its : clients) {
        its.close();
      }
    }
  }

  /** Starts watches whose listeners are blocked until the latch opens. */
  private void block(CrossComClient its, int watches, CountDownLatch release) throws Exception {
    CountDownLatch blocked = new CountDownLatch(watches);
    for (int i = 0; i < watches; i++) {
      its.watch(
          PERIOD,
          sample -> {
            blocked.countDown();
            try {
              release.await();
            } catch (InterruptedException e) {
              Thread.currentThread().interrupt();
            }
          },
          "$OV_PRO");
    }
    assertThat(blocked.await(60, TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void blockedListenersStopNoOtherWatch() throws Exception {
    CountDownLatch release = new CountDownLatch(1);
    try (ClientRuntime growing = ClientRuntime.create(cfg -> {});
        CrossComClient its = client(cfg -> cfg.runtime(growing))) {
      block(its, 40, release);
      its.watch(PERIOD, samples::add, "$OV_PRO");
      for (int i = 1; i <= 20; i++) {
        assertThat(next().number()).isEqualTo(i);
      }
      release.countDown();
    }
  }

  @Test
  @SuppressWarnings("try") // closed while in use
  void ifAllListenersAreBlockedIteratorsAndFuturesGoOn() throws Exception {
    CountDownLatch release = new CountDownLatch(1);
    try (ClientRuntime one = ClientRuntime.create(cfg -> cfg.listenerThreads(1));
        CrossComClient its = client(cfg -> cfg.runtime(one))) {
      block(its, 1, release);
      Watch watch = its.watch(WatchConfig.create(List.of("$OV_PRO"), cfg -> cfg.period(PERIOD)));
      Iterator<Sample> iterator = watch.iterator();
      for (int i = 1; i <= 20; i++) {
        assertThat(iterator.next().number()).isEqualTo(i);
      }
      try (CrossComClient lazy = CrossComClient.lazy(its.getConfig())) {
        lazy.connected().get(60, TimeUnit.SECONDS);
      }
      its.close();
      while (iterator.hasNext()) {
        iterator.next();
      }
      release.countDown();
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  @SuppressWarnings("try") // closed while in use
  void noListenerGetsAWaitingSampleAfterTheWatchOrItsClientIsClosed(boolean closesClient)
      throws Exception {
    CountDownLatch called = new CountDownLatch(1);
    CountDownLatch release = new CountDownLatch(1);
    AtomicInteger calls = new AtomicInteger();
    try (ClientRuntime one = ClientRuntime.create(cfg -> cfg.listenerThreads(1));
        CrossComClient other = client(cfg -> cfg.runtime(one));
        CrossComClient its = client(cfg -> cfg.runtime(one))) {
      Watch watch =
          its.watch(
              PERIOD,
              sample -> {
                calls.incrementAndGet();
                called.countDown();
                try {
                  release.await();
                } catch (InterruptedException e) {
                  Thread.currentThread().interrupt();
                }
              },
              "$OV_PRO");
      called.await();
      Iterator<Sample> iterator = watch.iterator();
      for (int i = 0; i < 5; i++) {
        iterator.next(); // waits for the listener too
      }
      if (closesClient) {
        its.close();
      } else {
        watch.close();
      }
      release.countDown();
      other.watch(PERIOD, samples::add, "$OV_PRO");
      next(); // so the only thread has done what waited

      assertThat(calls).hasValue(1);
    }
  }

  static List<Fault> faults() {
    return FailureTest.breaks().toList();
  }

  @ParameterizedTest
  @MethodSource("faults")
  void callsNextToAWatchHaveTheRightValuesAndNoWriteIsRepeatedThoughConnectionsBreak(Fault fault)
      throws Exception {
    detectServer();
    Random random = new Random(1);
    robot.faults(request -> random.nextInt(20) == 0 ? Optional.of(fault) : Optional.empty());
    Duration tiny = Duration.ofMillis(1);
    int failures = 0;
    try (CrossComClient its = client(cfg -> cfg.runtime(runtime).reconnectBackoff(tiny, tiny));
        Watch watch = its.watch(tiny, samples::add, "MYINT", "$OV_PRO")) {
      for (int i = 1; i <= 300; i++) {
        int value = i;
        try {
          its.writeInt("MYINT", value);
          assertThat(its.readInt("MYINT")).isEqualTo(value);
        } catch (CrossComException e) {
          failures++;
        }
      }
      robot.clearFaults();
      Sample sample;
      do {
        sample = next();
        KrlInt seen = (KrlInt) sample.value("MYINT");
        assertThat(seen.value()).isBetween(0, 300);
        assertThat(sample.value("$OV_PRO")).isEqualTo(new KrlInt(100));
      } while (!samples.isEmpty());
      assertThat(watch.failedPolls()).isLessThan(watch.polls());
    }
    assertThat(failures).isPositive();
    List<String> writes =
        robot.requests().stream()
            .filter(RecordedRequest::isWrite)
            .map(RecordedRequest::value)
            .toList();
    assertThat(writes).doesNotHaveDuplicates();
  }

  static Stream<Fault> wrongAnswers() {
    return FailureTest.lies();
  }

  @ParameterizedTest
  @MethodSource("wrongAnswers")
  void aWrongAnswerIsAFailedReadingAndNoValue(Fault lie) throws Exception {
    Duration tiny = Duration.ofMillis(1);
    try (CrossComClient its = client(cfg -> cfg.runtime(runtime).reconnectBackoff(tiny, tiny));
        Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO", "MYINT")) {
      next();
      robot.enqueue(lie);
      Sample sample;
      do {
        sample = next();
        assertThat(sample.value("$OV_PRO")).isEqualTo(new KrlInt(100));
        assertThat(sample.value("MYINT")).isEqualTo(new KrlInt(0));
      } while (!sample.hasGapBefore());
      assertThat(watch.failedPolls()).isEqualTo(1);
    }
  }

  @Test
  void aReadingIsRepeatedOnceOnANewConnection() throws Exception {
    try (CrossComClient its = client(cfg -> cfg.runtime(runtime));
        Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO", "MYINT")) {
      next();
      robot.disconnectClients();
      while (its.statistics().reconnects() == 0) {
        next();
      }
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void noSampleMixesTheValuesOfTwoConnections() throws Exception {
    assumeThat(server).as("reads one by one").isEqualTo(ServerType.KUKAVARPROXY);
    AtomicInteger reads = new AtomicInteger();
    robot.faults(
        request -> {
          if (!request.names().contains("MYINT") || reads.getAndIncrement() > 0) {
            return Optional.empty();
          }
          robot.variables().set("$OV_PRO", "50");
          return Optional.of(Fault.closeBefore());
        });
    try (CrossComClient its = client(cfg -> cfg.runtime(runtime));
        Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO", "MYINT")) {
      Sample first = next();
      assertThat(first.value("$OV_PRO")).isEqualTo(new KrlInt(50));
      assertThat(first.value("MYINT")).isEqualTo(new KrlInt(0));
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void aTextThatWasChangedToNonAsciiIsReadAgainWithItsCharset() throws Exception {
    robot.variables().declare("MYTEXT[20]", "CHAR", "\"plain\"");
    try (CrossComClient its = client(cfg -> cfg.runtime(runtime));
        Watch watch =
            its.watch(
                WatchConfig.create(
                    List.of("MYTEXT[]"), cfg -> cfg.period(PERIOD).changesOnly(true)),
                samples::add)) {
      assertThat(next().value("MYTEXT[]")).isEqualTo(new KrlString("plain"));
      robot.variables().set("MYTEXT[]", "\"gr\u00fcn\"");
      assertThat(next().value("MYTEXT[]")).isEqualTo(new KrlString("gr\u00fcn"));
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void aValueTooLongForAnAnswerFailsAlone() throws Exception {
    assumeThat(server).isEqualTo(ServerType.C3_BRIDGE);
    robot.variables().declare("LONGTEXT[40000]", "CHAR", "\"" + "x".repeat(40_000) + "\"");
    try (CrossComClient its = client(cfg -> cfg.runtime(runtime));
        Watch watch = its.watch(PERIOD, samples::add, "LONGTEXT[]")) {
      Sample sample = next();
      assertThatExceptionOfType(CrossComValueException.class)
          .isThrownBy(() -> sample.value("LONGTEXT[]"))
          .withMessageContaining("too long for an answer");
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void aRuntimeThatIsClosedEndsItsWatches() throws Exception {
    CountDownLatch ended = new CountDownLatch(2);
    CrossComClient its = client(cfg -> cfg.runtime(runtime));
    Watch busy = its.watch(PERIOD, samples::add, "$OV_PRO");
    Watch idle = its.watch(Duration.ofDays(1), samples::add, "$OV_PRO");
    busy.subscribe(WatchTest.ending(ended));
    idle.subscribe(WatchTest.ending(ended));
    next();
    runtime.close();

    assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
    assertThat(its.isClosed()).isTrue();
  }

  @Test
  void closingTheClientEndsAWatchThatConnects() throws Exception {
    try (ServerSocket full = withFullBacklog(0)) {
      CountDownLatch ended = new CountDownLatch(1);
      CrossComClient its =
          CrossComClient.lazy(
              ClientConfig.create(
                  "127.0.0.1",
                  cfg -> cfg.port(full.getLocalPort()).connectTimeout(LONG).runtime(runtime)));
      Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO");
      watch.subscribe(WatchTest.ending(ended));
      while (watch.polls() == 0) {
        Thread.onSpinWait();
      }
      its.close();

      assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
    }
  }

  /** The requests of the steps of a reading: of the detection, of one or of several variables. */
  static List<String> steps() {
    return List.of("@PROXY_TYPE", "$OV_PRO", "NOSUCHVAR");
  }

  @ParameterizedTest
  @MethodSource("steps")
  void closingTheClientEndsAWatchInEachStep(String name) throws Exception {
    CountDownLatch asked = new CountDownLatch(1);
    CountDownLatch ended = new CountDownLatch(1);
    robot.faults(
        request -> {
          if (!request.names().contains(name)) {
            return Optional.empty();
          }
          asked.countDown();
          return Optional.of(Fault.dropAnswer());
        });
    CrossComClient its = client(cfg -> cfg.runtime(runtime));
    Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO", "NOSUCHVAR");
    watch.subscribe(WatchTest.ending(ended));
    asked.await();
    its.close();

    assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
    assertThat(samples).isEmpty();
    assertThat(runtime.timer().getQueue()).isEmpty();
  }

  @Test
  void aReadingThatTimesOutIsCountedAndTheNextOneConnectsAgain() throws Exception {
    detectServer();
    try (CrossComClient its = client(cfg -> cfg.runtime(runtime).requestTimeout(SHORT));
        Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO")) {
      next();
      robot.enqueue(Fault.dropAnswer());
      Sample sample;
      do {
        sample = next();
      } while (!sample.hasGapBefore());
      assertThat(watch.failedPolls()).isPositive();
      assertThat(its.statistics().timeouts()).isPositive();
      assertThat(its.statistics().reconnects()).isPositive();
    }
  }
}
