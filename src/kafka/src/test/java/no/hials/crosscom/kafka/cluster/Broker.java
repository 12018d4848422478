package no.hials.crosscom.kafka.cluster;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Predicate;
import kafka.tools.StorageTool;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.NewTopic;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.Uuid;
import org.apache.kafka.common.serialization.StringDeserializer;
import org.apache.kafka.common.serialization.StringSerializer;

/** A broker that is its own controller, with a listener for the test and one for each relay. */
final class Broker implements AutoCloseable {
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final JavaProcess process;
  private final int port;

  Broker(Path folder, Relay... relays) throws Exception {
    port = JavaProcess.freePort();
    int controller = JavaProcess.freePort();
    List<String> listeners = new ArrayList<>(List.of("TEST://127.0.0.1:" + port));
    List<String> advertised = new ArrayList<>(listeners);
    List<String> protocols = new ArrayList<>(List.of("CONTROLLER:PLAINTEXT", "TEST:PLAINTEXT"));
    for (int i = 0; i < relays.length; i++) {
      int own = JavaProcess.freePort();
      listeners.add("R" + i + "://127.0.0.1:" + own);
      advertised.add("R" + i + "://127.0.0.1:" + relays[i].port());
      protocols.add("R" + i + ":PLAINTEXT");
      relays[i].to(own);
    }
    listeners.add("CONTROLLER://127.0.0.1:" + controller);
    Path config = folder.resolve("broker.properties");
    Files.writeString(
        config,
        String.join(
            "\n",
            "process.roles=broker,controller",
            "node.id=1",
            "controller.quorum.voters=1@127.0.0.1:" + controller,
            "controller.listener.names=CONTROLLER",
            "inter.broker.listener.name=TEST",
            "listeners=" + String.join(",", listeners),
            "advertised.listeners=" + String.join(",", advertised),
            "listener.security.protocol.map=" + String.join(",", protocols),
            "log.dirs=" + folder.resolve("data"),
            "offsets.topic.replication.factor=1",
            "offsets.topic.num.partitions=1",
            "transaction.state.log.replication.factor=1",
            "transaction.state.log.min.isr=1",
            "transaction.state.log.num.partitions=1",
            "group.initial.rebalance.delay.ms=0",
            "auto.create.topics.enable=false",
            ""));
    int code =
        StorageTool.execute(
            new String[] {"format", "-t", Uuid.randomUuid().toString(), "-c", config.toString()},
            new PrintStream(Files.newOutputStream(folder.resolve("format.log"))));
    if (code != 0) {
      throw new IOException(Files.readString(folder.resolve("format.log")));
    }
    process = new JavaProcess(folder, "broker", "kafka.Kafka", config.toString());
    awaitStart();
  }

  private void awaitStart() throws Exception {
    long end = System.nanoTime() + PATIENCE.toNanos();
    try (Admin admin = admin()) {
      while (true) {
        try {
          admin.describeCluster().nodes().get(1, TimeUnit.SECONDS);
          return;
        } catch (ExecutionException | TimeoutException e) {
          if (System.nanoTime() - end > 0) {
            throw e;
          }
          process.await(50);
        }
      }
    }
  }

  int port() {
    return port;
  }

  String address() {
    return "127.0.0.1:" + port;
  }

  Admin admin() {
    return Admin.create(Map.of("bootstrap.servers", address()));
  }

  void createTopic(String name) throws Exception {
    createTopic(name, 1);
  }

  void createTopic(String name, int partitions) throws Exception {
    try (Admin admin = admin()) {
      admin.createTopics(List.of(new NewTopic(name, partitions, (short) 1))).all().get();
    }
  }

  /** Returns a consumer of a whole topic with one partition. */
  KafkaConsumer<String, String> consumer(String topic) {
    KafkaConsumer<String, String> consumer =
        new KafkaConsumer<>(
            Map.of(
                ConsumerConfig.BOOTSTRAP_SERVERS_CONFIG,
                address(),
                ConsumerConfig.AUTO_OFFSET_RESET_CONFIG,
                "earliest"),
            new StringDeserializer(),
            new StringDeserializer());
    consumer.assign(List.of(new TopicPartition(topic, 0)));
    return consumer;
  }

  /** Waits for a record, and returns its value. */
  static String await(
      KafkaConsumer<String, String> consumer, Predicate<ConsumerRecord<String, String>> wanted) {
    while (true) {
      for (ConsumerRecord<String, String> record : consumer.poll(Duration.ofSeconds(1))) {
        if (wanted.test(record)) {
          // the next call begins after it, and not after all that was read with it
          consumer.seek(
              new TopicPartition(record.topic(), record.partition()), record.offset() + 1);
          return record.value();
        }
      }
    }
  }

  KafkaProducer<String, String> producer() {
    return new KafkaProducer<>(
        Map.of("bootstrap.servers", address()), new StringSerializer(), new StringSerializer());
  }

  JavaProcess process() {
    return process;
  }

  @Override
  public void close() {
    process.close();
  }
}
