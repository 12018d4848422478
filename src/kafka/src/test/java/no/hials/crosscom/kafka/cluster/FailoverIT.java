package no.hials.crosscom.kafka.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.ConsumerRecords;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer.OrderAnnotation;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Two workers, of which one is frozen, cut off or killed. */
@Timeout(120)
@TestMethodOrder(OrderAnnotation.class)
class FailoverIT {
  private static final int ROBOTS = 20;
  private static final ObjectMapper JSON = new ObjectMapper();

  /** The longest wait for a failover. The time it takes is printed, not asserted. */
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /** Longer than a lease: a robot that is read after this time has an owner again. */
  private static final Duration AFTER_LEASE = Duration.ofSeconds(4);

  /** Longer than offset.flush.interval.ms: without an offset, no gap can be reported. */
  private static final Duration OFFSETS_STORED = Duration.ofSeconds(3);

  /** The period of the readings, in ms. */
  private static final long PERIOD = 100;

  /**
   * Periods by which a reading can be late although none is left out: it begins before the next
   * one, and ends before the one after that.
   */
  private static final long LATE = 2;

  /** Readings in the time from the last stored offset, which is up to 1 s old, to the fault. */
  private static final long NOT_STORED = 20;

  /** Readings that a run tries while it connects, after its gap has ended. */
  private static final long CONNECTING = 12;

  @TempDir private static Path folder;
  private static Robots robots;
  private static Broker broker;
  private static Relay relay1;
  private static Relay relay2;
  private static Worker one;
  private static Worker two;

  @BeforeAll
  static void start() throws Exception {
    robots =
        new Robots(
            folder,
            ROBOTS,
            """
            [groups.motion]
            variables = ["$POS_ACT", "$OV_PRO"]
            period = "100ms"
            """);
    relay1 = new Relay();
    relay2 = new Relay();
    broker = new Broker(folder, relay1, relay2);
    broker.createTopic("robots");
    broker.createTopic("robots-leases");
    one = new Worker(folder, "w1", relay1.port());
    two = new Worker(folder, "w2", relay2.port());
    one.awaitStart();
    two.awaitStart();
    one.read("robots", robots, 4);
    awaitBothWorkersHaveTasks();
  }

  @AfterAll
  static void stop() throws Exception {
    Closing.all(one, two, broker, relay1, relay2, robots);
  }

  /** Waits until all tasks run, on two workers, and all robots are read. */
  private static void awaitBothWorkersHaveTasks() throws Exception {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (true) {
      JsonNode status = status();
      Set<String> workers = new HashSet<>();
      int running = 0;
      for (JsonNode task : status.path("tasks")) {
        workers.add(task.path("worker_id").asText());
        running += task.path("state").asText().equals("RUNNING") ? 1 : 0;
      }
      if (running == 4 && workers.size() == 2) {
        break;
      }
      assertThat(System.nanoTime()).as(status.toString()).isLessThan(end);
      two.await(100);
    }
    awaitAllRead(Instant.now().plus(OFFSETS_STORED));
  }

  private static JsonNode status() throws IOException, InterruptedException {
    try {
      return JSON.readTree(two.get("/connectors/robots/status"));
    } catch (IOException e) {
      // there is no status before the first task
      return JSON.createObjectNode();
    }
  }

  private static void awaitAllRead(Instant since) throws Exception {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!robots.areReadSince(since)) {
      assertThat(System.nanoTime()).isLessThan(end);
      JavaProcess.pause(50);
    }
  }

  /** Waits until all robots have an owner again after a fault, and prints the times. */
  private static void awaitOwners(String fault, Instant time) throws Exception {
    awaitAllRead(time.plus(AFTER_LEASE));
    System.out.printf(
        "%s: all %d robots are back after %d ms, the longest time without an access is %d ms%n",
        fault, ROBOTS, robots.back(time).toMillis(), robots.longestSilence(time).toMillis());
  }

  @Test
  @Order(1)
  void aFrozenWorkerDoesNotReadItsRobotsWhenItGoesOn() throws Exception {
    Instant fault = Instant.now();
    one.signal("STOP");
    awaitOwners("frozen (SIGSTOP)", fault);
    awaitAllRead(fault.plusSeconds(30));
    one.signal("CONT");
    awaitBothWorkersHaveTasks();
    robots.assertOneAtATime();
    checkRecords();
  }

  @Test
  @Order(2)
  void aWorkerThatIsFrozenForLessThanTheSessionReadsItsRobotsAgain() throws Exception {
    Instant fault = Instant.now();
    one.signal("STOP");
    // longer than the lease
    JavaProcess.pause(4500);
    one.signal("CONT");
    awaitOwners("frozen for 4.5 s", fault);
    awaitAllRead(Instant.now().plus(OFFSETS_STORED));
    robots.assertOneAtATime();
    checkRecords();
  }

  @Test
  @Order(3)
  void aWorkerThatIsCutOffFromTheBrokerStopsReading() throws Exception {
    Instant fault = Instant.now();
    relay1.cut();
    awaitOwners("cut off", fault);
    awaitAllRead(fault.plusSeconds(15));
    relay1.restore();
    awaitBothWorkersHaveTasks();
    robots.assertOneAtATime();
    checkRecords();
  }

  @Test
  @Order(4)
  void theRobotsOfAKilledWorkerAreTakenOver() throws Exception {
    Instant fault = Instant.now();
    one.close();
    awaitOwners("killed (SIGKILL)", fault);
    robots.assertOneAtATime();
    checkRecords();
  }

  /** The records of one run of a robot. */
  private static final class Run {
    private long next = 1;
  }

  /** The readings of a robot, and those that its gaps report. */
  private static final class Readings {
    private long runs;
    private long gaps;
    private long missed;
    private long replaced;
    private long read;
    private long first;
    private long last;

    void add(JsonNode value, boolean beginsRun) {
      long time = value.path("time").asLong();
      if (value.path("quality").asText().equals("gap")) {
        long from = value.path("gap").path("from").asLong();
        long readings = value.path("gap").path("missed").asLong();
        if (beginsRun && read > 0) {
          // a worker that was frozen can replace the stored offset by its own
          // (docs/concepts/kafka-failover.md#what-remains)
          replaced += Math.max(0, (last - from) / PERIOD);
        } else if (from < first) { // the first reading was late
          first = Math.max(from, first - readings * PERIOD);
        }
        gaps++;
        missed += readings;
      } else if (value.path("quality").asText().equals("good")
          && value.path("variable").asText().equals("$OV_PRO")) {
        first = read == 0 ? time : first;
        last = time;
        read++;
      }
    }

    /** Checks that the gaps report each reading that was left out once. */
    void check(String robot) {
      long unread = (last - first) / PERIOD + 1 - read;
      String what =
          robot + ": missed in " + gaps + " gaps of " + runs + " runs, " + unread + " are";
      // the first or the last reading can be late, and the ends of each gap be rounded
      assertThat(missed).as(what).isGreaterThanOrEqualTo(unread - LATE - gaps - CONNECTING * runs);
      assertThat(missed)
          .as(what + ", " + replaced + " read ones before their offsets were stored")
          .isLessThanOrEqualTo(unread + LATE + gaps + NOT_STORED * (runs - 1) + replaced);
    }
  }

  /**
   * Checks that the sequence of each run has no hole, that each run after the first one of a robot
   * begins with a gap, and that the gaps report what was not read.
   */
  private static void checkRecords() throws Exception {
    Map<String, Run> runs = new HashMap<>();
    Map<String, Readings> readings = new TreeMap<>();
    long records = 0;
    try (KafkaConsumer<String, String> consumer = broker.consumer("robots")) {
      long end = consumer.endOffsets(consumer.assignment()).values().iterator().next();
      while (records < end) {
        ConsumerRecords<String, String> some = consumer.poll(Duration.ofSeconds(1));
        for (ConsumerRecord<String, String> record : some) {
          records++;
          JsonNode value = JSON.readTree(record.value());
          String robot = record.key();
          Run run = runs.get(robot + "/" + value.path("run").asLong());
          boolean isGap = value.path("quality").asText().equals("gap");
          boolean beginsRun = run == null;
          if (run == null) {
            run = new Run();
            runs.put(robot + "/" + value.path("run").asLong(), run);
            Readings own = readings.computeIfAbsent(robot, name -> new Readings());
            assertThat(isGap).as(record.value()).isEqualTo(own.runs++ > 0);
          }
          assertThat(value.path("sequence").asLong()).as(record.value()).isEqualTo(run.next++);
          readings.get(robot).add(value, beginsRun);
        }
      }
    }
    readings.forEach((robot, own) -> own.check(robot));
    System.out.printf(
        "%d records of %d robots in %d runs, %d gaps with %d missed readings, really %d%n",
        records,
        readings.size(),
        runs.size(),
        readings.values().stream().mapToLong(one -> one.gaps).sum(),
        readings.values().stream().mapToLong(one -> one.missed).sum(),
        readings.values().stream()
            .mapToLong(one -> (one.last - one.first) / PERIOD + 1 - one.read)
            .sum());
  }
}
