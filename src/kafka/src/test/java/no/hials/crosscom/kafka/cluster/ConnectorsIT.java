package no.hials.crosscom.kafka.cluster;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.RecordedRequest;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.consumer.OffsetAndMetadata;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.TopicPartition;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.MethodOrderer.OrderAnnotation;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInfo;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The connectors on one worker: samples arrive, and each command is written at most once. */
@Timeout(120)
@TestMethodOrder(OrderAnnotation.class)
class ConnectorsIT {
  private static final String TABLES =
      """
      [groups.motion]
      variables = ["$POS_ACT", "$OV_PRO", "$MODE_OP", "$IN[1]"]
      period = "100ms"

      [variables."$OV_PRO"]
      write = true
      range = [0, 100]
      """;

  @TempDir private static Path folder;
  private static Robots robots;
  private static Broker broker;
  private static Worker worker;
  private static KafkaProducer<String, String> producer;
  private KafkaConsumer<String, String> dead;

  /** The name of the test, its connector and its topic. */
  private String name;

  @BeforeAll
  static void startAll() throws Exception {
    robots = new Robots(folder, 2, TABLES);
    broker = new Broker(folder);
    broker.createTopic("robots");
    broker.createTopic("robots-leases");
    producer = broker.producer();
    worker = new Worker(folder, "w1", broker.port()).awaitStart();
  }

  @AfterAll
  static void stopAll() throws Exception {
    Closing.all(producer, worker, broker, robots);
  }

  @BeforeEach
  void createTopics(TestInfo test) throws Exception {
    name = test.getTestMethod().orElseThrow().getName();
    broker.createTopic(name, 2);
    broker.createTopic(name + "-dead");
    dead = broker.consumer(name + "-dead");
    robots.names().forEach(robot -> robots.get(robot).clearRequests());
  }

  @AfterEach
  void deleteConnector() throws Exception {
    robots.names().forEach(robot -> robots.get(robot).clearFaults());
    dead.close();
    worker.delete(name);
  }

  private Map<String, String> sink(String... more) {
    Map<String, String> sink = new HashMap<>();
    sink.put("connector.class", "no.hials.crosscom.kafka.RobotSinkConnector");
    sink.put("tasks.max", "1");
    sink.put("topics", name);
    sink.put("plant", robots.file().toString());
    sink.put("bootstrap.servers", broker.address());
    sink.put("audit.folder", folder.toString());
    sink.put("errors.tolerance", "all");
    sink.put("errors.deadletterqueue.topic.name", name + "-dead");
    sink.put("errors.deadletterqueue.topic.replication.factor", "1");
    sink.put("errors.deadletterqueue.context.headers.enable", "true");
    sink.put("producer.override.delivery.timeout.ms", "20000");
    sink.put("producer.override.acks", "all");
    sink.put("producer.override.request.timeout.ms", "10000");
    for (int i = 0; i < more.length; i += 2) {
      sink.put(more[i], more[i + 1]);
    }
    return sink;
  }

  private void send(String robot, String variable, String value) throws Exception {
    send(0, robot, variable, value);
  }

  private void send(int partition, String robot, String variable, String value) throws Exception {
    String text =
        "{\"robot\":\"" + robot + "\",\"variable\":\"" + variable + "\",\"value\":" + value + "}";
    producer.send(new ProducerRecord<>(name, partition, null, text)).get();
  }

  /** Waits for the next dead letter and returns it with its reason. */
  private String deadLetter() {
    StringBuilder letter = new StringBuilder();
    String value =
        Broker.await(
            dead,
            record -> {
              letter.append(reason(record));
              return true;
            });
    return value + " " + letter;
  }

  private static String reason(ConsumerRecord<String, String> record) {
    return new String(
        record.headers().lastHeader("__connect.errors.exception.message").value(), UTF_8);
  }

  private List<RecordedRequest> writes(String robot) {
    return robots.get(robot).requests().stream().filter(RecordedRequest::isWrite).toList();
  }

  private void awaitWrite(String robot) throws Exception {
    while (writes(robot).isEmpty()) {
      var unused = robots.get(robot).takeRequest(Duration.ofSeconds(1));
    }
  }

  @Test
  void writingIsOffUntilItIsSwitchedOnAndHasADeadLetterTopic() {
    assertThatThrownBy(() -> worker.put(name, sink())).hasMessageContaining("must be true");
    assertThatThrownBy(
            () -> worker.put(name, sink("writes.enabled", "true", "errors.tolerance", "none")))
        .hasMessageContaining("errors.tolerance");
  }

  @Test
  void aCommandIsWrittenOnceAndARefusedOneGoesToTheDeadLetters() throws Exception {
    worker.put(name, sink("writes.enabled", "true", "consumer.override.max.poll.records", "2"));
    send("r1", "$OV_PRO", "40");
    send("r1", "$OV_PRO", "140");
    send("r2", "$POS_ACT.X", "1");
    send("r2", "$OV_PRO", "30");
    send("r9", "$OV_PRO", "20");
    assertThat(deadLetter()).contains("140", "must be 0.0 to 100.0");
    assertThat(deadLetter()).contains("$POS_ACT.X", "does not allow it");
    assertThat(deadLetter()).contains("no robot is named r9");
    assertThat(writes("r1")).extracting(RecordedRequest::value).containsExactly("40");
    assertThat(writes("r2")).extracting(RecordedRequest::value).containsExactly("30");
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("kafka:" + name + "-0@0", "\"after\":\"40\"", "\"result\":\"done\"");
  }

  @Test
  void aCommandForAnotherRobotIsWrittenWhileThoseOfASlowOneWait() throws Exception {
    int commands = 8;
    robots.get("r1").fault(RecordedRequest::isWrite, Fault.delay(Duration.ofMillis(700)));
    for (int i = 0; i < commands; i++) {
      send("r1", "$OV_PRO", String.valueOf(i));
    }
    worker.put(name, sink("writes.enabled", "true"));
    awaitWrite("r1");
    send("r2", "$OV_PRO", "30");
    awaitWrite("r2");
    assertThat(writes("r1")).hasSizeLessThan(commands);
  }

  @Test
  void afterAStartWithAnInvalidFileNothingIsWrittenUntilItIsValidAgain() throws Exception {
    worker.put(name, sink("writes.enabled", "true"));
    send("r1", "$OV_PRO", "40");
    awaitWrite("r1");
    String text = Files.readString(robots.file());
    Files.writeString(robots.file(), text + "[half");
    worker.restart(name);
    while (!taskState().equals("FAILED")) {
      JavaProcess.pause(50);
    }
    send("r1", "$OV_PRO", "41");
    Files.writeString(robots.file(), text.replace("write = true", "write = false"));
    assertThat(deadLetter()).contains("41", "does not allow it");
    assertThat(writes("r1")).extracting(RecordedRequest::value).containsExactly("40");
    Files.writeString(robots.file(), text);
  }

  @Test
  void afterAPauseNothingIsWrittenThatTheFileForbidsByThen() throws Exception {
    worker.put(name, sink("writes.enabled", "true"));
    send("r1", "$OV_PRO", "40");
    awaitWrite("r1");
    worker.setPaused(name, true);
    while (!taskState().equals("PAUSED")) {
      JavaProcess.pause(50);
    }
    String text = Files.readString(robots.file());
    Files.writeString(robots.file(), text.replace("write = true", "write = false"));
    send("r1", "$OV_PRO", "41");
    worker.setPaused(name, false);
    assertThat(deadLetter()).contains("41", "does not allow it");
    assertThat(writes("r1")).extracting(RecordedRequest::value).containsExactly("40");
    Files.writeString(robots.file(), text);
  }

  @Test
  void aDeadLetterThatIsRefusedFailsTheTaskAndIsThereAfterItsRestart() throws Exception {
    Map<String, String> right = sink("writes.enabled", "true");
    // too small for the stack trace in the headers
    worker.put(name, sink("writes.enabled", "true", "producer.override.max.request.size", "1000"));
    send("r1", "$POS_ACT.X", "40");
    while (!taskState().equals("FAILED")) {
      JavaProcess.pause(50);
    }
    assertThat(worker.get("/connectors/" + name + "/status"))
        .contains("the dead-letter topic " + name + "-dead has refused a record");
    worker.put(name, right);
    assertThat(deadLetter()).contains("$POS_ACT.X", "outcome unknown");
    assertThat(writes("r1")).isEmpty();
  }

  @Test
  void aTaskFailsIfItsDeadLetterTopicIsDeletedAndTheLetterIsThereAfterItsRestart()
      throws Exception {
    worker.put(
        name,
        sink(
            "writes.enabled",
            "true",
            "producer.override.delivery.timeout.ms",
            "3000",
            "producer.override.request.timeout.ms",
            "2000"));
    send("r1", "$POS_ACT.X", "40");
    assertThat(deadLetter()).contains("does not allow it");
    try (Admin admin = broker.admin()) {
      admin.deleteTopics(List.of(name + "-dead")).all().get();
    }
    send("r1", "$POS_ACT.X", "41");
    while (!taskState().equals("FAILED")) {
      JavaProcess.pause(50);
    }
    assertThat(worker.get("/connectors/" + name + "/status"))
        .contains("the dead-letter topic " + name + "-dead did not take a record");
    broker.createTopic(name + "-dead");
    dead.close();
    dead = broker.consumer(name + "-dead");
    worker.put(name, sink("writes.enabled", "true"));
    assertThat(deadLetter()).contains("41", "outcome unknown");
  }

  private String taskState() throws Exception {
    JsonNode status = new ObjectMapper().readTree(worker.get("/connectors/" + name + "/status"));
    return status.path("tasks").path(0).path("state").asText();
  }

  @Test
  void theReasonOfADeadLetterIsShortened() throws Exception {
    worker.put(name, sink("writes.enabled", "true"));
    producer
        .send(new ProducerRecord<>(name, 0, null, "{\"x\":\"" + "9".repeat(60_000) + "\"}"))
        .get();
    List<Integer> lengths = new ArrayList<>();
    String unused =
        Broker.await(
            dead,
            record -> {
              record.headers().forEach(header -> lengths.add(header.value().length));
              return true;
            });
    assertThat(lengths).isNotEmpty().allMatch(length -> length < 10_000);
  }

  @Test
  void aRecordThatHasWaitedForLongIsNotWritten() throws Exception {
    send("r1", "$OV_PRO", "40");
    worker.put(name, sink("writes.enabled", "true", "max.age.ms", "1"));
    assertThat(deadLetter()).contains("older than 1 ms");
    assertThat(writes("r1")).isEmpty();
  }

  @Test
  void aWriteWithoutAnAnswerIsNotRepeated() throws Exception {
    worker.put(name, sink("writes.enabled", "true"));
    robots.get("r1").fault(RecordedRequest::isWrite, Fault.dropAnswer());
    send("r1", "$OV_PRO", "40");
    assertThat(deadLetter()).contains("40", "outcome");
    assertThat(writes("r1")).hasSize(1);
  }

  @Test
  void aWriteWhoseOutcomeIsUnknownStaysUnknownWhileAnotherPartitionIsCommitted() throws Exception {
    // the claim of a task that ended: it ends after the last record, so that it stays open
    String claim = "jopenshowvar another from 0 to 2";
    try (Admin admin = broker.admin()) {
      admin
          .alterConsumerGroupOffsets(
              "connect-" + name,
              Map.of(new TopicPartition(name, 0), new OffsetAndMetadata(2, claim)))
          .all()
          .get();
    }
    send(0, "r1", "$OV_PRO", "40");
    worker.put(name, sink("writes.enabled", "true"));
    assertThat(deadLetter()).contains("40", "outcome unknown");
    send(1, "r2", "$OV_PRO", "30");
    awaitWrite("r2");
    worker.delete(name);
    worker.put(name, sink("writes.enabled", "true"));
    send(0, "r1", "$OV_PRO", "41");
    assertThat(deadLetter()).contains("41", "outcome unknown");
    assertThat(writes("r1")).isEmpty();
  }

  @Test
  @Order(Integer.MAX_VALUE)
  void aWriteOfAKilledWorkerIsNotRepeatedByTheNextOne() throws Exception {
    worker.put(name, sink("writes.enabled", "true"));
    robots.get("r1").fault(RecordedRequest::isWrite, Fault.dropAnswer());
    send("r1", "$OV_PRO", "40");
    awaitWrite("r1");
    worker.close();
    robots.get("r1").clearFaults();
    worker = new Worker(folder, "w2", broker.port()).awaitStart();
    assertThat(deadLetter()).contains("40", "outcome unknown");
    send("r2", "$OV_PRO", "30");
    send("r9", "$OV_PRO", "20");
    assertThat(deadLetter()).contains("r9");
    assertThat(writes("r1")).hasSize(1);
    assertThat(writes("r2")).hasSize(1);
  }

  @Test
  void samplesArriveWithTheirFieldsAndUnitsAndAGapIsToldAfterAChange() throws Exception {
    worker.read(name, robots, 2);
    try (KafkaConsumer<String, String> samples = broker.consumer("robots");
        KafkaConsumer<String, String> leases = broker.consumer("robots-leases")) {
      assertThat(Broker.await(samples, it -> isOf(it, "r2", "$POS_ACT")))
          .contains("\"quality\":\"good\"", "\"X\":525.0", "\"X\":\"mm\"", "\"A\":\"°\"");
      assertThat(Broker.await(samples, it -> isOf(it, "r1", "$MODE_OP")))
          .contains("\"texts\":{\"value\":\"#T1\"}", "\"gap\":null");
      assertThat(Broker.await(samples, it -> isOf(it, "r1", "$IN[1]")))
          .contains("\"flags\":{\"value\":false}");
      assertThat(Broker.await(leases, it -> it.value().contains("\"held\":true")))
          .contains("\"connector\":\"" + name);
      Files.writeString(robots.file(), Files.readString(robots.file()).replace("100ms", "50ms"));
      assertThat(Broker.await(samples, it -> it.value().contains("a task has started")))
          .contains("\"quality\":\"gap\"", "\"variable\":null", "\"sequence\":1,");
    }
  }

  private static boolean isOf(
      ConsumerRecord<String, String> record, String robot, String variable) {
    return record.key().equals(robot)
        && record.value().contains("\"variable\":\"" + variable + "\"");
  }
}
