package no.hials.crosscom.kafka.cluster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Predicate;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The connectors on one worker. */
@Timeout(180)
class SourceIT {
  private static final String TABLES =
      """
      [groups.motion]
      variables = ["$POS_ACT", "$OV_PRO", "$MODE_OP", "$IN[1]"]
      period = "100ms"

      [variables."$OV_PRO"]
      write = true
      range = [0, 100]
      """;

  @TempDir private Path folder;
  private Robots robots;
  private Broker broker;
  private Worker worker;

  @BeforeEach
  void start() throws Exception {
    robots = new Robots(folder, 3, TABLES);
    broker = new Broker(folder);
    broker.createTopic("robots");
    broker.createTopic("robots-leases");
    broker.createTopic("commands");
    broker.createTopic("dead");
    worker = new Worker(folder, "w1", broker.port()).awaitStart();
  }

  @AfterEach
  void stop() throws IOException {
    if (worker != null) {
      System.out.println(Files.readString(worker.log()));
      worker.close();
    }
    if (broker != null) {
      broker.close();
    }
    robots.close();
  }

  private Map<String, String> source() {
    return Map.of(
        "connector.class",
        "no.hials.crosscom.kafka.RobotSourceConnector",
        "tasks.max",
        "2",
        "plant",
        robots.file().toString());
  }

  private static String await(
      KafkaConsumer<String, String> consumer, Predicate<ConsumerRecord<String, String>> wanted) {
    while (true) {
      for (ConsumerRecord<String, String> record : consumer.poll(Duration.ofSeconds(1))) {
        if (wanted.test(record)) {
          return record.value();
        }
      }
    }
  }

  @Test
  void samplesArriveWithTheirFieldsAndUnitsAndAGapIsToldAfterARestart() throws Exception {
    worker.put("robots", source());
    try (KafkaConsumer<String, String> samples = broker.consumer("robots");
        KafkaConsumer<String, String> leases = broker.consumer("robots-leases")) {
      String position =
          await(samples, it -> it.key().equals("r3") && it.value().contains("$POS_ACT"));
      assertThat(position)
          .contains("\"quality\":\"good\"", "\"X\":525.0", "\"X\":\"mm\"", "\"A\":\"°\"");
      String mode = await(samples, it -> it.value().contains("$MODE_OP"));
      assertThat(mode).contains("\"texts\":{\"value\":\"#T1\"}", "\"gap\":null");
      assertThat(await(samples, it -> it.value().contains("$IN[1]")))
          .contains("\"flags\":{\"value\":false}");
      assertThat(await(leases, it -> it.value().contains("\"held\":true")))
          .contains("\"connector\":\"robots\"");
      Files.writeString(robots.file(), Files.readString(robots.file()).replace("100ms", "50ms"));
      String gap = await(samples, it -> it.value().contains("\"quality\":\"gap\""));
      assertThat(gap).contains("\"variable\":null", "a task has started", "\"sequence\":1,");
    }
  }

  @Test
  void aCommandIsWrittenOnceAndAFailureGoesToTheDeadLetters() throws Exception {
    Map<String, String> sink =
        Map.ofEntries(
            Map.entry("connector.class", "no.hials.crosscom.kafka.RobotSinkConnector"),
            Map.entry("tasks.max", "1"),
            Map.entry("topics", "commands"),
            Map.entry("plant", robots.file().toString()),
            Map.entry("bootstrap.servers", broker.address()),
            Map.entry("audit.folder", folder.toString()),
            Map.entry("errors.tolerance", "all"),
            Map.entry("errors.deadletterqueue.topic.name", "dead"),
            Map.entry("errors.deadletterqueue.topic.replication.factor", "1"),
            Map.entry("errors.deadletterqueue.context.headers.enable", "true"));
    assertThatThrownBy(() -> worker.put("writes", sink)).hasMessageContaining("must be true");
    Map<String, String> enabled = new HashMap<>(sink);
    enabled.put("writes.enabled", "true");
    worker.put("writes", enabled);
    try (KafkaProducer<String, String> producer = broker.producer();
        KafkaConsumer<String, String> dead = broker.consumer("dead")) {
      producer.send(command("r1", "$OV_PRO", "40")).get();
      producer.send(command("r1", "$OV_PRO", "140")).get();
      producer.send(command("r2", "$POS_ACT.X", "1")).get();
      producer.send(command("r2", "$OV_PRO", "30")).get();
      producer.send(command("r9", "$OV_PRO", "20")).get();
      assertThat(await(dead, it -> true)).contains("140");
      assertThat(await(dead, it -> true)).contains("$POS_ACT.X");
      assertThat(await(dead, it -> true)).contains("r9");
    }
    assertThat(robots.get("r1").requests()).filteredOn(it -> it.isWrite()).hasSize(1);
    assertThat(robots.get("r2").requests()).filteredOn(it -> it.isWrite()).hasSize(1);
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("kafka:commands-0@0", "\"after\":\"40\"", "\"result\":\"done\"");
  }

  private static ProducerRecord<String, String> command(
      String robot, String variable, String value) {
    return new ProducerRecord<>(
        "commands",
        robot,
        "{\"robot\":\"" + robot + "\",\"variable\":\"" + variable + "\",\"value\":" + value + "}");
  }
}
