package no.hials.crosscom.kafka.cluster;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Measures the CPU time and memory of a worker and a broker for some robots at 10 Hz, two
 * structures each. {@code src/bench/run.sh kafka} runs it; a build does not.
 */
@Timeout(300)
class ClusterLoad {
  private static final int ROBOTS = Integer.getInteger("load.robots", 100);
  private static final Duration WARM_UP = Duration.ofSeconds(20);
  private static final Duration TIME = Duration.ofSeconds(Integer.getInteger("load.seconds", 30));

  @TempDir private Path folder;

  @Test
  void aWorkerStreamsRobots() throws Exception {
    try (Robots robots =
            new Robots(
                folder,
                ROBOTS,
                """
                [groups.motion]
                variables = ["$POS_ACT", "$AXIS_ACT"]
                period = "100ms"
                """);
        Broker broker = new Broker(folder)) {
      broker.createTopic("robots");
      broker.createTopic("robots-leases");
      try (Worker worker = new Worker(folder, "w1", broker.port()).awaitStart();
          KafkaConsumer<String, String> consumer = broker.consumer("robots")) {
        worker.read("robots", robots, 4);
        while (!robots.areReadSince(Instant.EPOCH)) {
          worker.await(50);
        }
        List<Arrival> unused = consume(consumer, WARM_UP);
        Map<String, JavaProcess> processes = new LinkedHashMap<>();
        processes.put("worker", worker.process());
        processes.put("broker", broker.process());
        measure(consumer, processes);
      }
    }
  }

  private static void measure(
      KafkaConsumer<String, String> consumer, Map<String, JavaProcess> processes) throws Exception {
    Map<String, Duration> before = new LinkedHashMap<>();
    processes.forEach((name, process) -> before.put(name, process.cpu()));
    long start = System.nanoTime();
    List<Arrival> arrivals = consume(consumer, TIME);
    double seconds = (System.nanoTime() - start) / 1e9;
    List<Long> ages = arrivals.stream().map(Arrival::millis).sorted().toList();
    System.out.printf(
        Locale.ROOT,
        "%d robots, %.1f s: %d records of %.0f, %.0f bytes each%n",
        ROBOTS,
        seconds,
        ages.size(),
        ROBOTS * 20 * seconds,
        arrivals.stream().mapToInt(Arrival::bytes).average().orElseThrow());
    System.out.printf(
        "from the reading to a consumer: median %d ms, 99 %% within %d ms, longest %d ms%n",
        ages.get(ages.size() / 2), ages.get(ages.size() * 99 / 100), ages.get(ages.size() - 1));
    for (Map.Entry<String, JavaProcess> one : processes.entrySet()) {
      Duration used = one.getValue().cpu().minus(before.get(one.getKey()));
      System.out.printf(
          Locale.ROOT,
          "%s %.2f cores, %d MB resident%n",
          one.getKey(),
          used.toNanos() / 1e9 / seconds,
          one.getValue().residentMegabytes());
    }
  }

  /** How old a record was when it arrived, and the size of its value. */
  private record Arrival(long millis, int bytes) {}

  private static List<Arrival> consume(KafkaConsumer<String, String> consumer, Duration time) {
    List<Arrival> arrivals = new ArrayList<>();
    long end = System.nanoTime() + time.toNanos();
    while (System.nanoTime() < end) {
      for (ConsumerRecord<String, String> record : consumer.poll(Duration.ofMillis(100))) {
        arrivals.add(
            new Arrival(
                System.currentTimeMillis() - record.timestamp(), record.serializedValueSize()));
      }
    }
    return arrivals;
  }
}
