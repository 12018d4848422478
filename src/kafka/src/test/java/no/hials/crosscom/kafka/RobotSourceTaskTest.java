package no.hials.crosscom.kafka;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.apache.kafka.clients.producer.RecordMetadata;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.metrics.PluginMetrics;
import org.apache.kafka.connect.data.Struct;
import org.apache.kafka.connect.source.SourceRecord;
import org.apache.kafka.connect.source.SourceTaskContext;
import org.apache.kafka.connect.storage.OffsetStorageReader;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A task that is called as Connect calls it, with and without acknowledged records. */
@Timeout(60)
class RobotSourceTaskTest {
  @KukaController private MockServer robot;
  @TempDir private Path folder;
  private final RobotSourceTask task = new RobotSourceTask();
  private boolean acknowledged = true;

  /** No offset is stored. */
  private static final class NoOffsets implements OffsetStorageReader, SourceTaskContext {
    @Override
    public <T> Map<String, Object> offset(Map<String, T> partition) {
      return Map.of();
    }

    @Override
    public <T> Map<Map<String, T>, Map<String, Object>> offsets(
        Collection<Map<String, T>> partitions) {
      return Map.of();
    }

    @Override
    public Map<String, String> configs() {
      return Map.of();
    }

    @Override
    public OffsetStorageReader offsetStorageReader() {
      return this;
    }

    @Override
    public PluginMetrics pluginMetrics() {
      throw new UnsupportedOperationException();
    }
  }

  @BeforeEach
  void start() throws Exception {
    Path plant = folder.resolve("plant.toml");
    Files.writeString(
        plant,
        """
        [robots.r1]
        host = "%s"
        port = %d
        [groups.all]
        variables = ["$OV_PRO"]
        period = "10ms"
        """
            .formatted(robot.host(), robot.port()));
    RobotSourceConnector connector = new RobotSourceConnector();
    connector.start(
        Map.of(
            "name",
            "robots",
            "plant",
            plant.toString(),
            "lease.ms",
            "1000",
            "lease.recovery.ms",
            "0"));
    task.initialize(new NoOffsets());
    task.start(connector.taskConfigs(1).get(0));
    connector.stop();
  }

  @AfterEach
  void stop() {
    task.stop();
  }

  /** Calls the task until it returns a wanted sample or gap. */
  private Struct await(Predicate<Struct> wanted) throws InterruptedException {
    while (true) {
      List<SourceRecord> records = task.poll();
      for (SourceRecord record : records == null ? List.<SourceRecord>of() : records) {
        if (acknowledged) {
          task.commitRecord(
              record, new RecordMetadata(new TopicPartition(record.topic(), 0), 0, 0, 0, 0, 0));
        }
        Struct value = (Struct) record.value();
        if (record.topic().equals("robots") && wanted.test(value)) {
          return value;
        }
      }
    }
  }

  /** Returns the reason of the next record with a quality that the task itself has caused. */
  private String reason(String quality) throws InterruptedException {
    // a busy computer adds gaps because it is too slow
    Predicate<String> ofTask = reason -> reason != null && reason.startsWith("the task");
    return await(
            sample ->
                sample.getString("quality").equals(quality)
                    && ofTask.test(sample.getString("reason")))
        .getString("reason");
  }

  @Test
  void theGapAfterAPauseSaysThatTheTaskWasNotCalled() throws Exception {
    var unused = await(sample -> sample.getString("quality").equals("good"));
    while (robot.clientCount() > 0) {
      Thread.onSpinWait();
    }
    assertThat(reason("gap"))
        .isEqualTo(
            "the task had not been called: it was paused, frozen, or blocked by the broker, or"
                + " the clock was set");
  }

  @Test
  void theGapAfterRecordsThatWereNotAcknowledgedSaysThatTheBrokerWasNotReached() throws Exception {
    var unused = await(sample -> sample.getString("quality").equals("good"));
    acknowledged = false;
    while (robot.clientCount() > 0) {
      var ignored = task.poll();
    }
    acknowledged = true;
    assertThat(reason("stale")).isEqualTo("the task does not use the robot: it has no lease");
    assertThat(reason("gap")).isEqualTo("the task had not reached the broker");
  }

  @Test
  void withoutTheLeaseNoRecordOfARobotIsSent() throws Exception {
    var unused = await(sample -> sample.getString("quality").equals("good"));
    while (robot.clientCount() > 0) {
      Thread.onSpinWait();
    }
    // as after a freeze: the samples before it wait, and a beat can be acknowledged
    for (int calls = 0; calls < 10; calls++) {
      List<SourceRecord> records = task.poll();
      assertThat(records == null ? List.<SourceRecord>of() : records)
          .extracting(SourceRecord::topic)
          .doesNotContain("robots");
    }
    assertThat(reason("stale")).isEqualTo("the task does not use the robot: it has no lease");
  }

  @Test
  void aTransformationThatLeavesOutTheRecordsOfTheLeaseIsToldOnce() throws Exception {
    assertThat(logOfSixBeats(null)).containsOnlyOnce("left out a record of robots-leases");
    assertThat(robot.clientCount()).isZero();
  }

  @Test
  void aProducerThatWaitsForNoAnswerRenewsNoLeaseAndIsToldOnce() throws Exception {
    // with acks=0 the producer itself completes a record, without an offset
    RecordMetadata own =
        new RecordMetadata(new TopicPartition("robots-leases", 0), -1, -1, 0, 0, 0);
    assertThat(logOfSixBeats(own)).containsOnlyOnce("with acks=0 it confirms none");
    assertThat(robot.clientCount()).isZero();
  }

  /** Answers six records of the lease, which are more than one lease, and returns the log. */
  private String logOfSixBeats(@Nullable RecordMetadata answer) throws InterruptedException {
    PrintStream before = System.err;
    ByteArrayOutputStream log = new ByteArrayOutputStream();
    System.setErr(new PrintStream(log, true, UTF_8));
    try {
      for (int beats = 0; beats < 6; ) {
        List<SourceRecord> records = task.poll();
        for (SourceRecord record : records == null ? List.<SourceRecord>of() : records) {
          assertThat(record.topic()).isEqualTo("robots-leases");
          task.commitRecord(record, answer);
          beats++;
        }
      }
    } finally {
      System.setErr(before);
    }
    return log.toString(UTF_8);
  }
}
