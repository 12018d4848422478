package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Flow;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.Sample.Reading;
import no.hials.crosscom.Sample.ReadingStatus;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.value.KrlInt;
import org.junit.jupiter.api.Test;

/** Reads variables again and again. */
class WatchTest extends RobotTest {
  private static final Duration PERIOD = Duration.ofMillis(5);

  private final BlockingQueue<Sample> samples = new LinkedBlockingQueue<>();

  private Sample next() throws InterruptedException {
    Sample sample = samples.poll(60, TimeUnit.SECONDS);
    assertThat(sample).as("a sample within a minute").isNotNull();
    return sample;
  }

  private static WatchConfig changes(double deadBand, String... names) {
    return WatchConfig.create(
        List.of(names), cfg -> cfg.period(PERIOD).changesOnly(true).deadBand(deadBand));
  }

  @Test
  void samplesHaveTheValuesTheTimeAndCountUp() throws Exception {
    try (Watch watch = client.watch(PERIOD, samples::add, "$OV_PRO", "NOSUCHVAR")) {
      for (int i = 1; i <= 5; i++) {
        Sample sample = next();
        assertThat(sample.number()).isEqualTo(i);
        assertThat(sample.readings().keySet()).containsExactly("$OV_PRO", "NOSUCHVAR");
        assertThat(sample.value("$OV_PRO")).isEqualTo(new KrlInt(100));
        assertThat(sample.duration()).isPositive();
        assertThat(sample.hasGapBefore()).isFalse();
        assertThatExceptionOfType(CrossComAccessException.class)
            .isThrownBy(() -> sample.value("NOSUCHVAR"));
        assertThatIllegalArgumentException()
            .isThrownBy(() -> sample.value("OTHER"))
            .withMessageContaining("not OTHER");
      }
      assertThat(watch.polls()).isGreaterThanOrEqualTo(5);
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void onlyChangesAreGivenIfAskedFor() throws Exception {
    try (Watch watch = client.watch(changes(0, "MYINT", "MYBOOL"), samples::add)) {
      assertThat(next().changed()).containsExactlyInAnyOrder("MYINT", "MYBOOL");
      robot.variables().set("MYINT", "1");
      Sample second = next();
      assertThat(second.changed()).containsExactly("MYINT");
      assertThat(second.value("MYINT")).isEqualTo(new KrlInt(1));
      robot.variables().set("MYBOOL", "TRUE");
      assertThat(next().changed()).containsExactly("MYBOOL");
      assertThat(watch.polls()).isGreaterThanOrEqualTo(3);
    }
  }

  @Test
  void aReadingShowsWhetherItsValueIsFreshAndWhenItWasRead() throws Exception {
    try (Watch watch = client.watch(PERIOD, samples::add, "MYINT", "NOSUCHVAR")) {
      Sample first = next();
      Reading read = first.readings().get("MYINT");
      assertThat(read.status()).isEqualTo(ReadingStatus.FRESH);
      assertThat(read.time()).isBetween(first.time(), first.time().plus(first.duration()));
      assertThat(read.accessTime()).isPositive().isLessThanOrEqualTo(first.duration());
      assertThat(first.readings().get("NOSUCHVAR").status()).isEqualTo(ReadingStatus.FAILED);
      assertThat(next().readings().get("MYINT").status()).isEqualTo(ReadingStatus.REPEATED);
      robot.variables().set("MYINT", "1");
      Sample changed;
      do {
        changed = next();
      } while (changed.changed().isEmpty());
      assertThat(changed.readings().get("MYINT").status()).isEqualTo(ReadingStatus.FRESH);
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void aReadingThatFailsIsASampleWithoutValuesIfAskedFor() throws Exception {
    WatchConfig config =
        WatchConfig.create(List.of("$OV_PRO"), cfg -> cfg.period(PERIOD).missedSamples(true));
    Duration tiny = Duration.ofMillis(1);
    try (CrossComClient its = client(cfg -> cfg.reconnectBackoff(tiny, tiny));
        Watch watch = its.watch(config, samples::add)) {
      next();
      robot.refuseConnections();
      robot.disconnectClients();
      Sample missed;
      do {
        missed = next();
      } while (missed.readings().get("$OV_PRO").status() != ReadingStatus.MISSED);
      assertThat(missed.failedPolls()).isPositive();
      assertThat(missed.changed()).isEmpty();
      assertThatExceptionOfType(CrossComException.class)
          .isThrownBy(missed.readings().get("$OV_PRO")::orThrow);
      robot.acceptConnections();
      Sample read;
      do {
        read = next();
      } while (read.readings().get("$OV_PRO").status() == ReadingStatus.MISSED);
      assertThat(read.readings().get("$OV_PRO").status()).isEqualTo(ReadingStatus.REPEATED);
      assertThat(read.hasGapBefore()).as("the gap is in the samples").isFalse();
      assertThat(watch.failedPolls()).isPositive();
    }
  }

  @Test
  void ifOnlyChangesAreWantedOneSampleIsMissedForAWholeGap() throws Exception {
    WatchConfig config =
        WatchConfig.create(
            List.of("MYINT"), cfg -> cfg.period(PERIOD).changesOnly(true).missedSamples(true));
    Duration tiny = Duration.ofMillis(1);
    try (CrossComClient its = client(cfg -> cfg.reconnectBackoff(tiny, tiny));
        Watch watch = its.watch(config, samples::add)) {
      next();
      robot.refuseConnections();
      robot.disconnectClients();
      while (watch.failedPolls() < 5) {
        Thread.onSpinWait();
      }
      robot.variables().set("MYINT", "1");
      robot.acceptConnections();
      assertThat(next().readings().get("MYINT").status()).isEqualTo(ReadingStatus.MISSED);
      Sample changed = next();
      assertThat(changed.value("MYINT")).isEqualTo(new KrlInt(1));
      assertThat(changed.failedPolls()).isGreaterThanOrEqualTo(4);
    }
  }

  private record Height(double z) {}

  @Test
  void samplesOfHandlesHaveJavaValues() throws Exception {
    robot.variables().declare("MYTEXT[20]", "CHAR", "\"gr\u00fcn\"");
    Handle.OfInt override = client.intHandle("$OV_PRO");
    Handle<Height> base = client.handle("$BASE", Height.class);
    Handle<String> text = client.handle("MYTEXT[]", String.class);
    Handle<Integer> unknown = client.handle("NOSUCHVAR", Integer.class);
    Handle<Boolean> wrong = client.handle("MYINT", Boolean.class);
    robot.variables().set("$BASE", "{Z 4.5}");
    WatchConfig config =
        WatchConfig.ofHandles(
            List.of(override, base, text, unknown, wrong), cfg -> cfg.period(PERIOD));
    try (Watch watch = client.watch(config, samples::add)) {
      for (int i = 0; i < 3; i++) {
        Sample sample = next();
        assertThat(sample.get(override)).isEqualTo(100);
        assertThat(sample.get(base)).isEqualTo(new Height(4.5));
        assertThat(sample.get(text)).isEqualTo("gr\u00fcn");
        assertThat(sample.value("$OV_PRO")).isEqualTo(new KrlInt(100));
        assertThatExceptionOfType(CrossComAccessException.class)
            .isThrownBy(() -> sample.get(unknown));
        assertThatExceptionOfType(CrossComValueException.class).isThrownBy(() -> sample.get(wrong));
        assertThat(sample.readings().get("MYINT").status()).isEqualTo(ReadingStatus.FAILED);
        assertThat(sample.get(client.intHandle("$OV_PRO"))).isEqualTo(100);
        assertThatIllegalArgumentException()
            .isThrownBy(() -> sample.get(client.realHandle("$OV_PRO")))
            .withMessageContaining("not Handle{$OV_PRO, Double}");
      }
      assertThat(watch.failedPolls()).isZero();
    }
  }

  private record Strict(double z) {
    @SuppressWarnings("UnusedMethod") // called by the client
    Strict {
      assertThat(z).isZero(); // throws an error
    }
  }

  @Test
  void anErrorOfARecordsConstructorIsTheFailureOfItsReading() throws Exception {
    Handle<Strict> strict = client.handle("$BASE", Strict.class);
    Handle.OfInt override = client.intHandle("$OV_PRO");
    robot.variables().set("$BASE", "{Z 4.5}");
    assertThat(client.read(strict, override).failures()).containsOnlyKeys(strict);
    WatchConfig config =
        WatchConfig.ofHandles(List.of(strict, override), cfg -> cfg.period(PERIOD));
    try (Watch watch = client.watch(config, samples::add)) {
      Sample sample = next();
      assertThat(sample.get(override)).isEqualTo(100);
      assertThatExceptionOfType(CrossComValueException.class)
          .isThrownBy(() -> sample.get(strict))
          .withMessageContaining("$BASE is refused by")
          .satisfies(
              e -> assertThat(e.getCause()).isExactlyInstanceOf(IllegalArgumentException.class))
          .withRootCauseInstanceOf(AssertionError.class);
      robot.variables().set("$BASE", "{Z 0}");
      while (!next().results().failures().isEmpty()) {
        assertThat(watch.failedPolls()).isZero();
      }
    }
  }

  @Test
  void aWatchHasHandlesOfItsClientOnlyAndOneForAVariable() throws Exception {
    Handle<Integer> own = client.intHandle("MYINT");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> WatchConfig.ofHandles(List.of(own, client.realHandle("MYINT")), c -> {}))
        .withMessage("a variable can be watched only once: MYINT is repeated");
    try (CrossComClient other = client(LONG)) {
      WatchConfig config = WatchConfig.ofHandles(List.of(own), cfg -> {});
      assertThatIllegalArgumentException()
          .isThrownBy(() -> other.watch(config, samples::add))
          .withMessageStartingWith(own + " is a handle of " + client);
    }
  }

  @Test
  void aLoopOverAWatchGetsEachSampleFromTheFirstOne() throws Exception {
    long expected = 1;
    try (Watch watch =
        client.watch(WatchConfig.create(List.of("$OV_PRO"), cfg -> cfg.period(PERIOD)))) {
      assertThat(watch.polls()).isZero();
      for (Sample sample : watch) {
        assertThat(sample.number()).isEqualTo(expected);
        assertThat(sample.value("$OV_PRO")).isEqualTo(new KrlInt(100));
        if (++expected > 5) {
          break;
        }
      }
    }
    assertThat(expected).isEqualTo(6);
  }

  @Test
  void aLoopOverAWatchEndsAfterTheLastSampleWhenTheClientIsClosed() throws Exception {
    CrossComClient its = client(cfg -> {});
    Watch watch = its.watch(WatchConfig.create(List.of("$OV_PRO"), cfg -> cfg.period(PERIOD)));
    Iterator<Sample> iterator = watch.iterator();
    assertThat(iterator.next().number()).isEqualTo(1);
    its.close();
    long last = 1;
    while (iterator.hasNext()) {
      last = iterator.next().number();
    }

    assertThat(last).isBetween(1L, watch.polls());
    assertThat(iterator.hasNext()).isFalse();
    assertThatExceptionOfType(NoSuchElementException.class).isThrownBy(iterator::next);
    assertThat(watch.iterator().hasNext()).as("of a watch that has ended").isFalse();
  }

  @Test
  void anInterruptedLoopEndsAndTheFlagStaysSet() throws Exception {
    WatchConfig config = WatchConfig.create(List.of("$OV_PRO"), c -> c.period(Duration.ofDays(1)));
    try (Watch watch = client.watch(config)) {
      Iterator<Sample> iterator = watch.iterator();
      assertThat(iterator.next().number()).isEqualTo(1);
      Thread.currentThread().interrupt();

      assertThatExceptionOfType(UncheckedIOException.class)
          .isThrownBy(iterator::hasNext)
          .withCauseInstanceOf(InterruptedIOException.class);
      assertThat(Thread.interrupted()).isTrue();
    }
  }

  @Test
  void aSlowLoopLosesWhatDoesNotFitIntoTheBuffer() throws Exception {
    WatchConfig config =
        WatchConfig.create(
            List.of("$OV_PRO"), cfg -> cfg.period(Duration.ofMillis(1)).bufferSize(4));
    try (Watch watch = client.watch(config)) {
      Iterator<Sample> iterator = watch.iterator();
      while (watch.droppedSamples() == 0) {
        Thread.onSpinWait();
      }
      long before = 0;
      long number = iterator.next().number();
      while (number == before + 1) {
        before = number;
        number = iterator.next().number();
      }
      assertThat(number).as("after a gap").isGreaterThan(before + 1);
    }
  }

  @Test
  void aRealThatStaysInTheDeadBandHasNotChanged() throws Exception {
    try (Watch watch = client.watch(changes(0.5, "MYFRAME", "MYINT"), samples::add)) {
      next();
      robot.variables().set("MYFRAME", "{X 0.4}");
      long polls = watch.polls();
      while (watch.polls() < polls + 3) {
        Thread.onSpinWait();
      }
      robot.variables().set("MYINT", "1");
      assertThat(next().changed()).as("X moved by 0.4 only").containsExactly("MYINT");
      robot.variables().set("MYFRAME", "{X 1.0}");
      assertThat(next().changed()).as("by 0.6 since the last sample").containsExactly("MYFRAME");
    }
  }

  @Test
  void aRealPrintedAsAnIntHasChangedOnlyBeyondTheDeadBand() throws Exception {
    detectServer();
    assertIntsCountAsReals("MYREAL", "1.2", "1", "2.0");
    assertIntsCountAsReals("MYFRAME", "{X 1.2}", "{X 1, Y 0, Z 0, A 0, B 0, C 0}", "{X 2.0}");
  }

  @Test
  void aRealOfAHandleIsARealEvenIfItIsAlwaysPrintedAsAnInt() throws Exception {
    detectServer();
    assertIntsCountAsReals(client.realHandle("MYREAL"), "0", "1", "5.0");
    robot.variables().declare("TWOREALS[2]", "REAL", null);
    assertIntsCountAsReals(client.handle("TWOREALS[]", double[].class), "0 0", "1 0", "5.0 0.0");
  }

  private void assertIntsCountAsReals(Handle<?> handle, String first, String second, String last)
      throws Exception {
    robot.variables().set(handle.name(), last);
    robot.enqueue(Fault.answer(first, Tail.SUCCESS), Fault.answer(second, Tail.SUCCESS));
    WatchConfig config =
        WatchConfig.ofHandles(
            List.of(handle), cfg -> cfg.period(PERIOD).changesOnly(true).deadBand(1.5));
    try (Watch watch = client.watch(config, samples::add)) {
      next();
      assertThat(next().value(handle.name()).print()).as("not the second").startsWith("5.0");
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void eachChangeOfAnIntCounts() throws Exception {
    detectServer();
    robot.enqueue(Fault.answer("0", Tail.SUCCESS));
    robot.variables().set("MYINT", "1");
    try (Watch watch = client.watch(changes(1.5, "MYINT"), samples::add)) {
      next();
      assertThat(next().value("MYINT").print()).isEqualTo("1");
      assertThat(watch.failedPolls()).isZero();
    }
  }

  private void assertIntsCountAsReals(String name, String first, String ints, String last)
      throws Exception {
    robot.variables().set(name, first);
    try (Watch watch = client.watch(changes(0.5, name), samples::add)) {
      next();
      robot.enqueue(Fault.answer(ints, Tail.SUCCESS));
      robot.variables().set(name, last);
      assertThat(next().value(name).print()).as("not the INT").contains("2.0");
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void periodsThatAReadingMissesAreCountedAndNotMadeUpFor() throws Exception {
    robot.enqueue(Fault.none(), Fault.delay(Duration.ofMillis(100)));
    try (Watch watch = client.watch(PERIOD, samples::add, "$OV_PRO")) {
      assertThat(next().number()).isEqualTo(1);
      next(); // the delayed one
      Sample after = next();
      assertThat(after.missedPeriods()).isGreaterThanOrEqualTo(10);
      assertThat(watch.missedPeriods()).isGreaterThanOrEqualTo(after.missedPeriods());
    }
  }

  @Test
  void aSlowListenerDoesNotDelayTheReadingAndLosesWhatDoesNotFit() throws Exception {
    CountDownLatch never = new CountDownLatch(1);
    WatchConfig config =
        WatchConfig.create(
            List.of("$OV_PRO"), cfg -> cfg.period(Duration.ofMillis(1)).bufferSize(4));
    try (Watch watch =
        client.watch(
            config,
            sample -> {
              try {
                never.await();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            })) {
      watch.addListener(samples::add);
      for (int i = 0; i < 20; i++) {
        next();
      }
      assertThat(watch.droppedSamples()).isPositive();
      never.countDown();
    }
  }

  @Test
  void aListenerThatThrowsIsReportedAndGoesOnGettingSamples() throws Exception {
    AtomicInteger calls = new AtomicInteger();
    AssertionError thrown = new AssertionError("on purpose"); // worse than an exception
    try (Watch watch =
        client.watch(
            PERIOD,
            sample -> {
              samples.add(sample);
              if (calls.getAndIncrement() == 0) {
                throw thrown;
              }
            },
            "$OV_PRO")) {
      next();
      assertThat(next().number()).isEqualTo(2);
      assertThat(watch.droppedSamples()).isZero();
      assertThat(watch.listenerFailures()).isEqualTo(1);
      assertThat(watch.listenerFailure()).isSameAs(thrown);
    }
  }

  @Test
  void aSubscriberThatThrowsIsCountedAndEndsNoOther() throws Exception {
    CompletableFuture<Throwable> told = new CompletableFuture<>();
    IllegalStateException thrown = new IllegalStateException("on purpose");
    Flow.Subscriber<Sample> throwing =
        new Flow.Subscriber<>() {
          @Override
          public void onSubscribe(Flow.Subscription subscription) {
            subscription.request(Long.MAX_VALUE);
          }

          @Override
          public void onNext(Sample sample) {
            throw thrown;
          }

          @Override
          public void onError(Throwable failure) {
            told.complete(failure);
          }

          @Override
          public void onComplete() {}
        };
    try (Watch watch = client.watch(PERIOD, samples::add, "$OV_PRO")) {
      watch.subscribe(throwing);
      assertThat(told.get(60, TimeUnit.SECONDS)).isSameAs(thrown);
      long last = next().number();
      assertThat(watch.listenerFailures()).isEqualTo(1);
      assertThat(watch.listenerFailure()).isSameAs(thrown);
      for (int i = 0; i < 5; i++) {
        assertThat(next().number()).isEqualTo(++last);
      }
    }
  }

  @Test
  void aClosedClientStartsNoWatch() throws Exception {
    client.close();

    assertThatExceptionOfType(CrossComClosedException.class)
        .isThrownBy(() -> client.watch(PERIOD, samples::add, "$OV_PRO"));
  }

  @Test
  void aWatchSurvivesALossOfTheConnectionAndMarksTheGap() throws Exception {
    try (CrossComClient its =
            client(cfg -> cfg.reconnectBackoff(Duration.ofMillis(1), Duration.ofMillis(5)));
        Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO")) {
      assertThat(next().hasGapBefore()).isFalse();
      robot.refuseConnections();
      robot.disconnectClients();
      while (watch.failedPolls() < 3) {
        Thread.onSpinWait();
      }
      robot.acceptConnections();
      Sample sample;
      do {
        sample = next();
      } while (!sample.hasGapBefore());
      assertThat(sample.failedPolls()).isGreaterThanOrEqualTo(3);
      assertThat(sample.value("$OV_PRO")).isEqualTo(new KrlInt(100));
      assertThat(next().hasGapBefore()).isFalse();
    }
  }

  @Test
  void aWatchWithALongPeriodReadsAtOnceWhenThereIsAConnectionAgain() throws Exception {
    Duration tiny = Duration.ofMillis(1);
    try (CrossComClient its = client(cfg -> cfg.reconnectBackoff(tiny, tiny));
        Watch slow = its.watch(Duration.ofHours(1), samples::add, "$OV_PRO");
        Watch fast = its.watch(PERIOD, sample -> {}, "MYINT")) {
      next();
      robot.variables().set("$OV_PRO", "50");
      robot.disconnectClients();

      assertThat(next().value("$OV_PRO")).isEqualTo(new KrlInt(50));
      assertThat(samples.poll(300, TimeUnit.MILLISECONDS)).isNull();
      assertThat(slow.missedPeriods() + slow.failedPolls()).isZero();
      assertThat(fast.polls()).isPositive();
    }
  }

  @Test
  void aReadingThatConnectsIsNotRepeated() throws Exception {
    ClientConfig config = ClientConfig.create(robot.host(), cfg -> cfg.port(robot.port()));
    try (CrossComClient lazy = CrossComClient.lazy(config);
        Watch watch = lazy.watch(Duration.ofHours(1), samples::add, "$OV_PRO")) {
      assertThat(next().value("$OV_PRO")).isEqualTo(new KrlInt(100));
      assertThat(samples.poll(300, TimeUnit.MILLISECONDS)).isNull();
      assertThat(watch.polls()).isOne();
      assertThat(watch.missedPeriods()).isZero();
    }
  }

  @Test
  void subscribersGetAsManySamplesAsTheyAskForAndAreToldTheEnd() throws Exception {
    CountDownLatch ended = new CountDownLatch(1);
    List<Sample> got = new ArrayList<>();
    Watch watch = client.watch(PERIOD, samples::add, "$OV_PRO");
    watch.subscribe(
        new Flow.Subscriber<>() {
          @Override
          public void onSubscribe(Flow.Subscription subscription) {
            subscription.request(2);
          }

          @Override
          public void onNext(Sample sample) {
            got.add(sample);
          }

          @Override
          public void onError(Throwable failure) {
            throw new AssertionError(failure);
          }

          @Override
          public void onComplete() {
            ended.countDown();
          }
        });
    for (int i = 0; i < 5; i++) {
      next();
    }
    assertThat(got).hasSizeLessThanOrEqualTo(2);
    watch.close();
    // completion follows the waiting samples, so it arrives only after they are requested
    assertThat(watch.polls()).isGreaterThanOrEqualTo(5);
    assertThat(ended.getCount()).isBetween(0L, 1L);
  }

  @Test
  void closingTheClientEndsTheWatchAndTellsItsSubscribers() throws Exception {
    CountDownLatch ended = new CountDownLatch(1);
    CrossComClient its = client(cfg -> {});
    Watch watch = its.watch(PERIOD, samples::add, "$OV_PRO");
    watch.subscribe(ending(ended));
    next();
    its.close();

    assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void aSlowListenerEndsUpWithTheLastValue() throws Exception {
    CountDownLatch go = new CountDownLatch(1);
    WatchConfig config =
        WatchConfig.create(
            List.of("MYINT"),
            cfg -> cfg.period(Duration.ofMillis(1)).changesOnly(true).bufferSize(1));
    try (Watch watch =
        client.watch(
            config,
            sample -> {
              try {
                go.await();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
              samples.add(sample);
            })) {
      for (int i = 1; watch.droppedSamples() == 0; i++) {
        robot.variables().set("MYINT", String.valueOf(i));
      }
      robot.variables().set("MYINT", "-1");
      go.countDown();
      Sample sample;
      do {
        sample = next();
      } while (!sample.value("MYINT").equals(new KrlInt(-1)));
    }
  }

  @Test
  void aSlowDriftIsToldOnceItLeavesTheDeadBand() throws Exception {
    // MYINT is read first and set last: with its new value, that of MYREAL is new too
    try (Watch watch = client.watch(changes(1, "MYINT", "MYREAL"), samples::add)) {
      next();
      for (int i = 1; i <= 3; i++) {
        robot.variables().set("MYREAL", String.valueOf(i * 0.5));
        robot.variables().set("MYINT", String.valueOf(i));
        // a reading may fall between the two, and then tells of the first alone
        Set<String> told = new HashSet<>();
        Sample sample;
        do {
          sample = next();
          told.addAll(sample.changed());
        } while (!sample.value("MYINT").equals(new KrlInt(i)));
        assertThat(told.contains("MYREAL")).as("at %s", i * 0.5).isEqualTo(i == 3);
      }
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void whatWaitsForASubscriberCanBeAskedForAfterTheEnd() throws Exception {
    BlockingQueue<Flow.Subscription> subscriptions = new LinkedBlockingQueue<>();
    BlockingQueue<Long> got = new LinkedBlockingQueue<>();
    CountDownLatch ended = new CountDownLatch(1);
    Watch watch = client.watch(PERIOD, samples::add, "$OV_PRO");
    watch.subscribe(
        new Flow.Subscriber<>() {
          @Override
          public void onSubscribe(Flow.Subscription subscription) {
            subscriptions.add(subscription);
          }

          @Override
          public void onNext(Sample sample) {
            got.add(sample.number());
          }

          @Override
          public void onError(Throwable failure) {
            throw new AssertionError(failure);
          }

          @Override
          public void onComplete() {
            ended.countDown();
          }
        });
    Flow.Subscription subscription = subscriptions.take();
    for (int i = 0; i < 5; i++) {
      next();
    }
    watch.close();
    assertThat(got).isEmpty();
    subscription.request(Long.MAX_VALUE);

    assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
    assertThat(got).hasSizeGreaterThanOrEqualTo(4);
    watch.addListener(samples::add); // comes too late, and does no harm
  }

  @Test
  void closingTheClientEndsAWatchWithALongPeriodAtOnce() throws Exception {
    CountDownLatch ended = new CountDownLatch(1);
    CrossComClient its = client(cfg -> {});
    Watch watch = its.watch(Duration.ofDays(1), samples::add, "$OV_PRO");
    watch.subscribe(ending(ended));
    next();
    its.close();

    assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void aWatchEndsWhenItsConnectionIsLostForGood() throws Exception {
    CountDownLatch ended = new CountDownLatch(1);
    // the client of the base class does not connect again
    Watch watch = client.watch(PERIOD, samples::add, "$OV_PRO");
    watch.subscribe(ending(ended));
    next();
    robot.disconnectClients();

    assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
  }

  @Test
  void aNameThatTheServerCannotTakeFailsAloneAndNotTheWatch() throws Exception {
    try (Watch watch = client.watch(PERIOD, samples::add, "\u03a9X", "$OV_PRO")) {
      Sample sample = next();
      assertThat(sample.value("$OV_PRO")).isEqualTo(new KrlInt(100));
      assertThatExceptionOfType(CrossComException.class)
          .isThrownBy(() -> sample.value("\u03a9X"))
          .isInstanceOf(
              server == ServerType.C3_BRIDGE
                  ? CrossComAccessException.class
                  : CrossComUnsupportedException.class);
      assertThat(watch.failedPolls()).isZero();
    }
  }

  @Test
  void subscribersGetTheFailureThatEndsAWatch() throws Exception {
    assumeThat(server).isEqualTo(ServerType.C3_BRIDGE);
    CompletableFuture<Throwable> failure = new CompletableFuture<>();
    Watch watch =
        client.watch(Duration.ofDays(1), samples::add, "$OV_PRO", "\u20ac".repeat(32_768));
    watch.subscribe(
        new Flow.Subscriber<>() {
          @Override
          public void onSubscribe(Flow.Subscription subscription) {
            subscription.request(Long.MAX_VALUE);
          }

          @Override
          public void onNext(Sample sample) {}

          @Override
          public void onError(Throwable cause) {
            failure.complete(cause);
          }

          @Override
          public void onComplete() {
            failure.completeExceptionally(new AssertionError("the watch must fail"));
          }
        });

    assertThat(failure.get(60, TimeUnit.SECONDS)).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void aWatchOfACancelledCallReadsAllTheSame() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch cancelled = new CountDownLatch(1);
    CompletableFuture<Void> call =
        client.asyncRun(
            c -> {
              begun.countDown();
              cancelled.await();
              c.watch(PERIOD, samples::add, "$OV_PRO");
            });
    begun.await();
    assertThat(call.cancel(false)).isTrue();
    cancelled.countDown();

    assertThat(next().value("$OV_PRO")).isEqualTo(new KrlInt(100));
  }

  static Flow.Subscriber<Sample> ending(CountDownLatch ended) {
    return new Flow.Subscriber<>() {
      @Override
      public void onSubscribe(Flow.Subscription subscription) {
        subscription.request(Long.MAX_VALUE);
      }

      @Override
      public void onNext(Sample sample) {}

      @Override
      public void onError(Throwable failure) {
        throw new AssertionError(failure);
      }

      @Override
      public void onComplete() {
        ended.countDown();
      }
    };
  }

  @Test
  void configurationsAreChecked() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> WatchConfig.create(List.of(), cfg -> {}))
        .withMessage("name at least one variable to watch");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> WatchConfig.create(List.of("X"), cfg -> cfg.period(Duration.ZERO)));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> WatchConfig.create(List.of("X"), cfg -> cfg.deadBand(Double.NaN)));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> WatchConfig.create(List.of("X"), cfg -> cfg.bufferSize(0)));
    assertThatIllegalArgumentException().isThrownBy(() -> client.watch(PERIOD, s -> {}, " "));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> WatchConfig.create(List.of(" "), cfg -> {}))
        .withMessage("a variable's name must not be blank");
    assertThatNullPointerException()
        .isThrownBy(() -> WatchConfig.create(Collections.singletonList(null), cfg -> {}))
        .withMessage("name");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> WatchConfig.create(List.of("MYINT", "Myint"), cfg -> {}))
        .withMessage("a variable can be watched only once: Myint is repeated");
  }
}
