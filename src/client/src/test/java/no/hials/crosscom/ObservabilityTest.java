package no.hials.crosscom;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;
import no.hials.crosscom.mock.Fault;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Counts and times the exchanges, for the program and for the flight recorder. */
class ObservabilityTest extends RobotTest {
  @Test
  void exchangesAreCountedByTheirResult() throws Exception {
    try (CrossComClient its = client(cfg -> cfg.reconnectBackoff(SHORT, SHORT))) {
      its.readText("$OV_PRO");
      its.writeText("MYINT", "4");
      assertThatExceptionOfType(CrossComAccessException.class)
          .isThrownBy(() -> its.readText("NOSUCHVAR"));
      robot.enqueue(Fault.closeBefore());
      its.readText("$OV_PRO");
      its.setSoTimeout((int) SHORT.toMillis());
      robot.enqueue(Fault.drop());
      assertThatExceptionOfType(CrossComTimeoutException.class)
          .isThrownBy(() -> its.readText("$OV_PRO"));

      ClientStatistics statistics = its.statistics();
      assertThat(statistics.refusals()).isEqualTo(1);
      assertThat(statistics.losses()).isEqualTo(1);
      assertThat(statistics.reconnects()).isEqualTo(1);
      assertThat(statistics.timeouts()).isEqualTo(1);
      // the server may have been asked for its type
      assertThat(statistics.accesses()).isGreaterThanOrEqualTo(4);
      assertThat(statistics.accessTimes().count()).isEqualTo(statistics.accesses());
      assertThat(statistics.queueTimes().count()).isEqualTo(statistics.accesses());
    }
  }

  @Test
  void eachTimeoutOfThreadsThatWaitForTheirTurnIsCounted() throws Exception {
    robot.faults(request -> Optional.of(Fault.drop()));
    AtomicInteger timeouts = new AtomicInteger();
    try (CrossComClient its = client(cfg -> cfg.requestTimeout(SHORT).server(server))) {
      List<Thread> threads = new ArrayList<>();
      for (int i = 0; i < 50; i++) {
        threads.add(
            new Thread(
                () -> {
                  try {
                    its.readText("$OV_PRO");
                  } catch (CrossComTimeoutException e) {
                    timeouts.incrementAndGet();
                  } catch (IOException e) {
                    // not connected again yet: no time-out
                  }
                }));
      }
      threads.forEach(Thread::start);
      for (Thread thread : threads) {
        thread.join();
      }
      assertThat(timeouts).hasPositiveValue();
      assertThat(its.statistics().timeouts()).isEqualTo(timeouts.get());
    }
  }

  @Test
  void theExchangesOfAWatchAreCountedAndRecordedToo(@TempDir Path folder) throws Exception {
    try (Recording recording = new Recording();
        CrossComClient its = client(cfg -> {})) {
      recording.enable("no.hials.crosscom.Exchange").withoutThreshold();
      recording.start();
      CountDownLatch read = new CountDownLatch(3);
      try (Watch watch =
          its.watch(Duration.ofMillis(5), s -> read.countDown(), "$OV_PRO", "NOSUCHVAR")) {
        read.await();
        assertThat(watch.failedPolls()).isZero();
      }
      recording.stop();
      Path file = folder.resolve("watch.jfr");
      recording.dump(file);

      assertThat(its.statistics().accesses()).isGreaterThanOrEqualTo(3);
      assertThat(its.statistics().refusals()).isGreaterThanOrEqualTo(3);
      assertThat(RecordingFile.readAllEvents(file))
          .filteredOn(e -> e.getString("request").startsWith("read of $OV_PRO"))
          .hasSizeGreaterThanOrEqualTo(3)
          .allMatch(e -> e.getBoolean("answered"));
    }
  }

  @Test
  void theHistogramHasTheTimesOfTheExchanges() throws Exception {
    for (int i = 0; i < 9; i++) {
      client.readText("$OV_PRO");
    }
    robot.enqueue(Fault.delay(Duration.ofMillis(300)));
    client.readText("$OV_PRO");

    ClientStatistics.Histogram times = client.statistics().accessTimes();
    assertThat(times.percentile(100)).isGreaterThanOrEqualTo(Duration.ofMillis(300));
    assertThat(times.percentile(0)).isLessThanOrEqualTo(times.percentile(50));
    assertThat(times.toString()).matches("Histogram\\[count=\\d+, median=\\S+ ms, 99%=\\S+ ms]");
    List<Long> counts = new ArrayList<>();
    times.forEach((upTo, count) -> counts.add(count));
    assertThat(counts.stream().mapToLong(Long::longValue).sum()).isEqualTo(times.count());
    assertThatIllegalArgumentException().isThrownBy(() -> times.percentile(101));
  }

  @Test
  void theFlightRecorderHasAnEventForEachExchange(@TempDir Path folder) throws Exception {
    try (Recording recording = new Recording()) {
      recording.enable("no.hials.crosscom.Exchange").withoutThreshold();
      recording.start();
      client.readText("$OV_PRO");
      client.writeText("MYINT", "3");
      recording.stop();
      Path file = folder.resolve("exchanges.jfr");
      recording.dump(file);
      List<RecordedEvent> events = RecordingFile.readAllEvents(file);
      assertThat(events)
          .extracting(e -> e.getString("request"))
          .contains("read of $OV_PRO", "write of MYINT");
      assertThat(events).allMatch(e -> e.getBoolean("answered"));
      assertThat(events).allMatch(e -> e.getString("server").endsWith(":" + robot.port()));
    }
  }
}
