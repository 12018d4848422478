package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.errors.DataException;
import org.apache.kafka.connect.sink.ErrantRecordReporter;
import org.apache.kafka.connect.sink.SinkRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Dead letters, with the ways in which Connect answers a report. */
@Timeout(60)
class DeadLettersTest {
  private static final Duration LONG = Duration.ofSeconds(50);

  /** Returns some records, whose offsets count from 0. */
  private static Map<SinkRecord, Exception> letters(int number) {
    Map<SinkRecord, Exception> letters = new LinkedHashMap<>();
    for (int offset = 0; offset < number; offset++) {
      letters.put(
          new SinkRecord("commands", 0, null, null, null, "x", offset),
          new DataException("not written"));
    }
    return letters;
  }

  private static void put(int number, ErrantRecordReporter reporter, Duration patience) {
    try (DeadLetters dead = new DeadLetters(reporter, "dead", patience)) {
      assertThat(dead.put(letters(number), LONG)).hasSize(number);
    }
  }

  private static void put(ErrantRecordReporter reporter) {
    put(1, reporter, LONG);
  }

  private static Future<Void> acknowledged() {
    return acknowledgedAfter(new CountDownLatch(0));
  }

  private static Future<Void> acknowledgedAfter(CountDownLatch reports) {
    return CompletableFuture.runAsync(
        () -> {
          try {
            reports.await();
          } catch (InterruptedException e) {
            throw new CompletionException(e);
          }
        },
        CompletableFuture.delayedExecutor(50, TimeUnit.MILLISECONDS));
  }

  @Test
  void aRecordThatTheBrokerAcknowledgesIsReportedOnce() {
    AtomicInteger reports = new AtomicInteger();
    put(
        (record, why) -> {
          reports.incrementAndGet();
          return acknowledged();
        });
    assertThat(reports).hasValue(1);
  }

  @Test
  void recordsWaitForTheirAcknowledgementsTogether() {
    List<Long> reported = new ArrayList<>();
    CountDownLatch many = new CountDownLatch(5);
    put(
        25,
        (record, why) -> {
          reported.add(record.originalKafkaOffset());
          many.countDown();
          return acknowledgedAfter(many);
        },
        LONG);
    assertThat(reported).doesNotHaveDuplicates().hasSize(25).isSorted();
  }

  @Test
  void noMoreRecordsWaitTogetherThanASlowBrokerTakesInTime() {
    AtomicInteger waiting = new AtomicInteger();
    List<Integer> numbers = new ArrayList<>();
    put(
        25,
        (record, why) -> {
          numbers.add(waiting.incrementAndGet());
          return CompletableFuture.runAsync(
              waiting::decrementAndGet,
              CompletableFuture.delayedExecutor(50, TimeUnit.MILLISECONDS));
        },
        LONG);
    assertThat(numbers).hasSize(25).allMatch(number -> number <= 10);
  }

  @Test
  void afterTheTimeNoMoreRecordsArePut() {
    List<Long> reported = new ArrayList<>();
    Map<SinkRecord, Exception> letters = letters(25);
    try (DeadLetters dead =
        new DeadLetters(
            (record, why) -> {
              reported.add(record.originalKafkaOffset());
              return acknowledged();
            },
            "dead",
            LONG)) {
      assertThat(dead.put(letters, Duration.ZERO))
          .isEqualTo(List.copyOf(letters.keySet()).subList(0, 10));
    }
    assertThat(reported).hasSize(10);
  }

  @Test
  void onlyTheUncertainRecordsAreReportedAgain() {
    List<Long> reported = new ArrayList<>();
    put(
        2,
        (record, why) -> {
          reported.add(record.originalKafkaOffset());
          return reported.size() == 2 ? CompletableFuture.completedFuture(null) : acknowledged();
        },
        LONG);
    assertThat(reported).containsExactly(0L, 1L, 1L);
  }

  @Test
  void aReportThatIsDoneAtOnceIsNoProof() {
    assertThatThrownBy(() -> put((record, why) -> CompletableFuture.completedFuture(null)))
        .isInstanceOf(ConnectException.class)
        .hasMessageContaining("the dead-letter topic dead has refused a record");
  }

  @Test
  void aRecordIsReportedAgainIfTheFirstAnswerCameTooQuicklyToBeAProof() {
    AtomicInteger reports = new AtomicInteger();
    put(
        (record, why) ->
            reports.getAndIncrement() == 0
                ? CompletableFuture.completedFuture(null)
                : acknowledged());
    assertThat(reports).hasValue(2);
  }

  @Test
  void theReasonOfARefusalByTheBrokerIsTold() {
    assertThatThrownBy(
            () ->
                put(
                    (record, why) ->
                        CompletableFuture.failedFuture(new IllegalStateException("disk full"))))
        .hasMessageContaining("did not take a record")
        .hasMessageContaining("disk full");
  }

  @Test
  void aReportThatNeverReturnsEndsWithTheReason() {
    CountDownLatch never = new CountDownLatch(1);
    assertThatThrownBy(
            () ->
                put(
                    1,
                    (record, why) -> {
                      try {
                        never.await();
                      } catch (InterruptedException e) {
                        throw new ConnectException("closed", e);
                      }
                      return acknowledged();
                    },
                    Duration.ofMillis(50)))
        .hasMessageContaining("dead did not take a record within 50 ms")
        .hasMessageContaining("does not exist");
  }
}
