package no.hials.crosscom.kafka.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import no.hials.crosscom.kafka.RobotSinkTask;
import no.hials.crosscom.kafka.SinkTasks;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.consumer.OffsetAndMetadata;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.metrics.PluginMetrics;
import org.apache.kafka.common.record.TimestampType;
import org.apache.kafka.connect.sink.ErrantRecordReporter;
import org.apache.kafka.connect.sink.SinkRecord;
import org.apache.kafka.connect.sink.SinkTaskContext;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The calls that Connect makes to a sink task, one after the other. */
@Timeout(120)
class SinkTaskIT {
  private static final TopicPartition COMMANDS = new TopicPartition("commands", 0);

  @TempDir private static Path folder;
  private static Robots robots;
  private static Broker broker;
  private static Admin admin;
  private final Connect connect = new Connect();
  private RobotSinkTask task;

  /** The end of the records that tasks have got. */
  private long position;

  /** The requests of a task to Connect. */
  private static final class Connect implements SinkTaskContext {
    private final Set<TopicPartition> paused = new HashSet<>();
    private final List<String> deadLetters = new ArrayList<>();
    private final Map<TopicPartition, Long> seeks = new HashMap<>();
    private boolean commitRequested;

    @Override
    public Map<String, String> configs() {
      return Map.of();
    }

    @Override
    public void offset(Map<TopicPartition, Long> offsets) {
      seeks.putAll(offsets);
    }

    @Override
    public void offset(TopicPartition partition, long offset) {
      seeks.put(partition, offset);
    }

    @Override
    public void timeout(long timeoutMs) {}

    @Override
    public Set<TopicPartition> assignment() {
      return Set.of(COMMANDS);
    }

    @Override
    public void pause(TopicPartition... partitions) {
      paused.addAll(Arrays.asList(partitions));
    }

    @Override
    public void resume(TopicPartition... partitions) {
      paused.removeAll(Arrays.asList(partitions));
    }

    @Override
    public void requestCommit() {
      commitRequested = true;
    }

    @Override
    public PluginMetrics pluginMetrics() {
      throw new UnsupportedOperationException();
    }

    @Override
    public ErrantRecordReporter errantRecordReporter() {
      return (record, error) -> {
        deadLetters.add(record.value() + ": " + error.getMessage());
        // a report that is done at once is repeated
        return CompletableFuture.runAsync(
            () -> {}, CompletableFuture.delayedExecutor(20, TimeUnit.MILLISECONDS));
      };
    }
  }

  @BeforeAll
  static void startAll() throws Exception {
    String tables = "[variables.\"$OV_PRO\"]\nwrite = true\nrange = [0, 1000]\n";
    robots = new Robots(folder, 2, tables);
    broker = new Broker(folder);
    broker.createTopic("commands");
    admin = broker.admin();
  }

  @AfterAll
  static void stopAll() throws Exception {
    Closing.all(admin, broker, robots);
  }

  @BeforeEach
  void startTask() throws Exception {
    commit(new OffsetAndMetadata(0));
    task = start();
    robots.names().forEach(robot -> robots.get(robot).clearRequests());
    robots.get("r1").fault(RecordedRequest::isWrite, Fault.delay(Duration.ofMillis(700)));
  }

  @AfterEach
  void stopTask() {
    task.stop();
    robots.names().forEach(robot -> robots.get(robot).clearFaults());
  }

  private RobotSinkTask start() throws Exception {
    return start(new RobotSinkTask());
  }

  private RobotSinkTask start(RobotSinkTask started) throws Exception {
    started.initialize(connect);
    started.start(
        Map.of(
            "name",
            "writes",
            "plant",
            robots.file().toString(),
            "task.plant",
            Files.readString(robots.file()),
            "writes.enabled",
            "true",
            "bootstrap.servers",
            broker.address(),
            "audit.folder",
            folder.toString(),
            "errors.tolerance",
            "all",
            "errors.deadletterqueue.topic.name",
            "dead",
            "producer.override.delivery.timeout.ms",
            "20000",
            "producer.override.acks",
            "all"));
    started.open(List.of(COMMANDS));
    return started;
  }

  private static void commit(OffsetAndMetadata offset) throws Exception {
    admin.alterConsumerGroupOffsets("connect-writes", Map.of(COMMANDS, offset)).all().get();
  }

  private static SinkRecord record(long offset, String robot, int value) {
    Map<String, ?> command = Map.of("robot", robot, "variable", "$OV_PRO", "value", value);
    long now = System.currentTimeMillis();
    return new SinkRecord(
        "commands", 0, null, null, null, command, offset, now, TimestampType.CREATE_TIME);
  }

  private void put(SinkRecord... records) {
    task.put(List.of(records));
    position += records.length;
  }

  /** Commits as Connect does before it closes partitions, and at other times. */
  private long commit() throws Exception {
    connect.commitRequested = false;
    OffsetAndMetadata offset =
        task.preCommit(Map.of(COMMANDS, new OffsetAndMetadata(position))).get(COMMANDS);
    commit(offset);
    return offset.offset();
  }

  /** Commits until the task has written what it could. */
  private void commitWhileRequested() throws Exception {
    while (connect.commitRequested) {
      var unused = commit();
      put();
    }
  }

  /** Replaces the task, as a rebalance does. */
  private void replaceTask() throws Exception {
    position = commit();
    task.close(List.of(COMMANDS));
    task.stop();
    task = start();
    position = connect.seeks.getOrDefault(COMMANDS, position);
  }

  private List<String> written(String robot) {
    return robots.get(robot).requests().stream()
        .filter(RecordedRequest::isWrite)
        .map(RecordedRequest::value)
        .toList();
  }

  @Test
  void aCommandThatComesLaterIsWrittenBeforeThoseThatWaitForASlowRobot() throws Exception {
    put(record(0, "r1", 1), record(1, "r1", 2), record(2, "r1", 3));
    var unused = commit();
    put();
    assertThat(written("r1")).containsExactly("1");
    assertThat(connect.paused).isEmpty();
    put(record(3, "r2", 30));
    while (written("r2").isEmpty()) {
      unused = commit();
      put();
    }
    assertThat(written("r1")).containsExactly("1", "2");
    commitWhileRequested();
    assertThat(written("r1")).containsExactly("1", "2", "3");
    assertThat(written("r2")).containsExactly("30");
    assertThat(connect.deadLetters).isEmpty();
  }

  @Test
  void theNextTaskWritesWhatWaitedForASlowRobotAndNothingTwice() throws Exception {
    SinkRecord three = record(3, "r1", 3);
    put(record(0, "r1", 1), record(1, "r1", 2), record(2, "r2", 30), three);
    var unused = commit();
    put();
    assertThat(written("r1")).containsExactly("1");
    assertThat(written("r2")).containsExactly("30");
    replaceTask();
    put(record(1, "r1", 2), record(2, "r2", 30), three);
    commitWhileRequested();
    assertThat(written("r1")).containsExactly("1", "2", "3");
    assertThat(written("r2")).containsExactly("30");
    assertThat(connect.deadLetters).isEmpty();
  }

  @Test
  void aClaimThatIsNotUsedYetIsGivenUpWhenATaskEnds() throws Exception {
    put(record(0, "r2", 30));
    var unused = commit();
    replaceTask();
    put(record(0, "r2", 30));
    commitWhileRequested();
    assertThat(written("r2")).containsExactly("30");
    assertThat(connect.deadLetters).isEmpty();
  }

  @Test
  void commitsThatNobodyAskedForDelayAClaimOnlyOnceAndLeaveSettledRecordsSettled()
      throws Exception {
    put(record(0, "r1", 1), record(1, "r1", 2), record(2, "r2", 30));
    var unused = commit();
    put();
    assertThat(written("r2")).containsExactly("30");
    // claimed and given up, then claimed and kept
    for (int i = 0; i < 2; i++) {
      put();
      unused = commit();
      unused = commit();
    }
    replaceTask();
    assertThat(position).isEqualTo(1);
    put(record(1, "r1", 2), record(2, "r2", 30));
    commitWhileRequested();
    assertThat(connect.deadLetters).singleElement().asString().contains("value=2", "unknown");
    assertThat(written("r1")).containsExactly("1");
    assertThat(written("r2")).containsExactly("30");
  }

  @Test
  void aClaimIsGivenUpWhileTheFileDiffers() throws Exception {
    put(record(0, "r2", 30));
    var unused = commit();
    String text = Files.readString(robots.file());
    Files.writeString(robots.file(), text + "# changed");
    put();
    assertThat(connect.paused).containsExactly(COMMANDS);
    replaceTask();
    put(record(0, "r2", 30));
    commitWhileRequested();
    Files.writeString(robots.file(), text);
    assertThat(written("r2")).containsExactly("30");
    assertThat(connect.deadLetters).isEmpty();
  }

  @Test
  void aPartitionThatHolds500CommandsIsPausedUntilSomeAreWritten() throws Exception {
    put(IntStream.range(0, 500).mapToObj(i -> record(i, "r2", i % 100)).toArray(SinkRecord[]::new));
    assertThat(connect.paused).containsExactly(COMMANDS);
    var unused = commit();
    put();
    assertThat(connect.paused).isEmpty();
    commitWhileRequested();
    assertThat(written("r2")).hasSize(500);
    assertThat(connect.deadLetters).isEmpty();
  }

  @Test
  void manyUnknownRecordsAreReportedInStepsAndNotAgainByTheNextTask() throws Exception {
    SinkRecord[] records =
        IntStream.range(0, 26).mapToObj(i -> record(i, "r2", i)).toArray(SinkRecord[]::new);
    put(Arrays.copyOf(records, 25));
    var unused = commit(); // the claim of a task that ends then
    task.stop();
    task = start(SinkTasks.reportingLittle());
    position = connect.seeks.get(COMMANDS);
    put(records);
    assertThat(connect.deadLetters).hasSize(10);
    replaceTask();
    assertThat(position).isEqualTo(10);
    put(Arrays.copyOfRange(records, 10, 26));
    commitWhileRequested();
    assertThat(connect.deadLetters).hasSize(25).doesNotHaveDuplicates();
    assertThat(written("r2")).containsExactly("25");
  }

  @Test
  void theFailuresOfABatchAreReportedInSteps() throws Exception {
    task.stop();
    task = start(SinkTasks.reportingLittle());
    SinkRecord[] records =
        IntStream.range(0, 26)
            .mapToObj(i -> record(i, "r2", i < 25 ? 2000 + i : i))
            .toArray(SinkRecord[]::new);
    put(records);
    var unused = commit();
    put();
    assertThat(written("r2")).containsExactly("25");
    assertThat(connect.deadLetters).hasSize(10);
    put();
    unused = commit(); // as Connect does at any time
    put();
    assertThat(connect.deadLetters).hasSize(25).doesNotHaveDuplicates();
    commitWhileRequested();
    assertThat(commit()).isEqualTo(26);
    assertThat(written("r2")).containsExactly("25");
  }

  @Test
  void failuresThatWereNotReportedYetAreUnknownToTheNextTask() throws Exception {
    task.stop();
    task = start(SinkTasks.reportingLittle());
    put(IntStream.range(0, 25).mapToObj(i -> record(i, "r2", 2000 + i)).toArray(SinkRecord[]::new));
    var unused = commit();
    put();
    replaceTask();
    assertThat(position).isEqualTo(10);
    put(
        IntStream.range(10, 25)
            .mapToObj(i -> record(i, "r2", 2000 + i))
            .toArray(SinkRecord[]::new));
    commitWhileRequested();
    assertThat(connect.deadLetters).hasSize(25).doesNotHaveDuplicates();
    assertThat(connect.deadLetters.subList(10, 25)).allMatch(it -> it.contains("unknown"));
    assertThat(written("r2")).isEmpty();
  }
}
