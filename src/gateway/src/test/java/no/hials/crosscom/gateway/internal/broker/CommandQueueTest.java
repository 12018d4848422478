package no.hials.crosscom.gateway.internal.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.Moment;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PlantFile;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Writes;
import no.hials.crosscom.gateway.GatewayContext;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.Latches;
import no.hials.crosscom.gateway.OneRobotContext;
import no.hials.crosscom.gateway.internal.writing.Pauses;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class CommandQueueTest {
  @KukaController private MockServer server;
  @TempDir private Path folder;

  private Plant plant() throws Exception {
    String text =
        """
        [robots.cell1]
        host = "%s:%d"
        timeout = "50s"
        [groups.texts]
        variables = ["MYSTRING[]"]
        period = "100ms"
        [variables.MYINT]
        range = [0, 10]
        write = true
        [variables."MYSTRING[]"]
        values = ["abc"]
        write = true
        """
            .formatted(server.host(), server.port());
    return PlantFile.read(TomlTable.parse(Path.of("plant.toml"), text), Map.of());
  }

  @Test
  void aCommandThatWaitedTooLongIsNotExecuted() throws Exception {
    server.variables().set("MYINT", "1");
    Plant plant = plant();
    AtomicLong now = new AtomicLong();
    CountDownLatch released = new CountDownLatch(1);
    BlockingQueue<String> results = new LinkedBlockingQueue<>();
    try (RobotFeed feed =
            RobotFeed.open(plant.plans().get(0), RobotConnection::open, (one, updates) -> {});
        CommandQueue queue =
            new CommandQueue(
                new OneRobotContext(plant, feed, folder, new Health()),
                now::get,
                new Pauses(() -> new Moment(0, 0)))) {
      executeAndLetTheNextWait(queue, results, released);

      now.set(Duration.ofSeconds(5).toNanos() + 1);
      released.countDown();

      assertThat(results.take())
          .isEqualTo("not executed: it waited more than 5 s for others to end");
      queue.execute("test", "cell1", "MYINT", "4", null, results::add);
      assertThat(results.take()).isEqualTo("done");
    }
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).hasSize(2);
    assertThat(server.variables().get("MYINT")).isEqualTo("4");
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("\"after\":\"3\",\"result\":\"not executed: it waited more than 5 s");
  }

  @Test
  void aCommandThatExpiresWhileItWaitsIsNotExecuted() throws Exception {
    server.variables().set("MYINT", "1");
    Plant plant = plant();
    AtomicLong now = new AtomicLong();
    CountDownLatch released = new CountDownLatch(1);
    BlockingQueue<String> results = new LinkedBlockingQueue<>();
    try (RobotFeed feed =
            RobotFeed.open(plant.plans().get(0), RobotConnection::open, (one, updates) -> {});
        CommandQueue queue =
            new CommandQueue(
                new OneRobotContext(plant, feed, folder, new Health()),
                now::get,
                new Pauses(() -> new Moment(0, 0)))) {
      executeAndLetTheNextWait(queue, results, released);
      queue.execute("test", "cell1", "MYINT", "4", Duration.ofSeconds(2), results::add);

      now.set(Duration.ofSeconds(2).toNanos() + 1);
      released.countDown();

      assertThat(results.take()).isEqualTo("done");
      assertThat(results.take())
          .isEqualTo("not executed: it expired while it waited for others to end");
    }
    assertThat(server.variables().get("MYINT")).isEqualTo("3");
  }

  @Test
  void aCommandThatHadExpiredWhenItArrivedIsRefusedForThisReason() throws Exception {
    Plant plant = plant();
    BlockingQueue<String> results = new LinkedBlockingQueue<>();
    try (RobotFeed feed =
            RobotFeed.open(plant.plans().get(0), RobotConnection::open, (one, updates) -> {});
        CommandQueue queue =
            new CommandQueue(new OneRobotContext(plant, feed, folder, new Health()))) {
      queue.execute("test", "cell1", "MYINT", "3", Duration.ZERO, results::add);

      assertThat(results.take()).isEqualTo("not executed: it had expired");
    }
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void aCommandThatExpiresWhileItWaitsForAReadingIsNotSent() throws Exception {
    server.variables().set("MYINT", "1");
    Plant plant = plant();
    Health health = new Health();
    CountDownLatch arrived = new CountDownLatch(1);
    CountDownLatch released = new CountDownLatch(1);
    server.fault(
        it -> {
          boolean slow = it.name().equals("$OV_PRO");
          if (slow) {
            arrived.countDown();
          }
          return slow;
        },
        Fault.hold(released));
    BlockingQueue<String> results = new LinkedBlockingQueue<>();
    String late =
        "cell1: MYINT was not written: it waited too long for the connection to the robot";
    try (RobotFeed feed =
            RobotFeed.open(plant.plans().get(0), RobotConnection::open, (one, updates) -> {});
        CommandQueue queue =
            new CommandQueue(
                new OneRobotContext(plant, feed, folder, health),
                () -> 0,
                new Pauses(() -> new Moment(0, 0)))) {
      FutureTask<String> reading = new FutureTask<>(() -> feed.client().readText("$OV_PRO"));
      new Thread(reading).start();
      arrived.await();

      queue.execute("test", "cell1", "MYINT", "3", Duration.ofMillis(20), results::add);

      assertThat(results.take()).isEqualTo(late);
      released.countDown();
      assertThat(reading.get()).isEqualTo("100");
      queue.execute("test", "cell1", "MYINT", "4", null, results::add);
      assertThat(results.take()).isEqualTo("done");
    }
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
    assertThat(server.variables().get("MYINT")).isEqualTo("4");
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("\"after\":\"3\",\"result\":\"" + late);
  }

  @Test
  void aCommandThatArrivesAfterAPauseOfTheGatewayIsNotExecuted() throws Exception {
    server.variables().set("MYINT", "1");
    Plant plant = plant();
    AtomicLong now = new AtomicLong();
    BlockingQueue<String> results = new LinkedBlockingQueue<>();
    try (RobotFeed feed =
            RobotFeed.open(plant.plans().get(0), RobotConnection::open, (one, updates) -> {});
        CommandQueue queue =
            new CommandQueue(
                new OneRobotContext(plant, feed, folder, new Health()),
                now::get,
                new Pauses(() -> new Moment(now.get(), 0)))) {
      // the queue was created before this time, as if it had been frozen since then
      now.addAndGet(Duration.ofMillis(600).toNanos());
      queue.execute("test", "cell1", "MYINT", "2", Duration.ofMillis(600), results::add);
      queue.execute("test", "cell1", "MYINT", "3", null, results::add);
      String reason =
          "not executed: the gateway was frozen for 0.6 s just before it arrived, so that it can be"
              + " too old";
      assertThat(results.take()).isEqualTo(reason);
      assertThat(results.take()).isEqualTo("done");

      now.addAndGet(Duration.ofMillis(4400).toNanos());
      queue.execute("test", "cell1", "MYINT", "4", null, results::add);

      assertThat(results.take()).contains("frozen for 5.0 s");
      assertThat(Files.readString(folder.resolve("audit.jsonl")))
          .contains("\"after\":\"2\",\"result\":\"" + reason);
    }
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
    assertThat(server.variables().get("MYINT")).isEqualTo("3");
  }

  @Test
  void aTextWithAQuoteIsRefusedWithALineInTheAuditLog() throws Exception {
    server.variables().set("MYSTRING[]", "\"x\"");
    Plant plant = plant();
    CountDownLatch read = new CountDownLatch(1);
    BlockingQueue<String> results = new LinkedBlockingQueue<>();
    try (RobotFeed feed =
            RobotFeed.open(
                plant.plans().get(0), RobotConnection::open, (one, updates) -> read.countDown());
        CommandQueue queue =
            new CommandQueue(new OneRobotContext(plant, feed, folder, new Health()))) {
      feed.start();
      read.await();
      queue.execute("test", "cell1", "MYSTRING[]", "a\"b", null, results::add);
      queue.execute("test", "cell1", "MYSTRING[]", "abc", null, results::add);

      String reason = "not executed: a CHAR array cannot hold a double quote";
      assertThat(results.take()).startsWith(reason);
      assertThat(results.take()).isEqualTo("done");
      assertThat(Files.readString(folder.resolve("audit.jsonl")))
          .contains("\"after\":\"a\\\"b\",\"result\":\"" + reason);
    }
    assertThat(server.variables().get("MYSTRING[]")).isEqualTo("\"abc\"");
  }

  @Test
  void twoPausesCountTogether() {
    AtomicLong now = new AtomicLong();
    Pauses pauses = new Pauses(() -> new Moment(now.get(), 0));

    now.addAndGet(Duration.ofMillis(500).toNanos());
    assertThat(pauses.justOver()).isZero();
    now.addAndGet(Duration.ofMillis(501).toNanos());
    assertThat(pauses.justOver()).hasMillis(501);
    now.addAndGet(Duration.ofSeconds(1).toNanos());
    assertThat(pauses.justOver()).hasMillis(1501);
    now.addAndGet(Duration.ofMillis(2001).toNanos());
    assertThat(pauses.justOver()).hasMillis(3502);
    for (int i = 0; i < 3; i++) {
      now.addAndGet(Duration.ofMillis(500).toNanos());
      assertThat(pauses.justOver()).hasMillis(3502);
    }
    now.addAndGet(Duration.ofMillis(500).toNanos());
    assertThat(pauses.justOver()).isZero();
  }

  /** The parts of a gateway that has not started its robots yet. */
  private record StartingContext(Plant plant, Path folder, Health health)
      implements GatewayContext {
    @Override
    public @Nullable RobotFeed robot(String name) {
      return null;
    }

    @Override
    public Writes writes() {
      return new Writes(new AuditLog(folder));
    }
  }

  @Test
  void aCommandForARobotThatIsBeingStartedIsRefusedForThisReason() throws Exception {
    BlockingQueue<String> results = new LinkedBlockingQueue<>();
    try (CommandQueue queue =
        new CommandQueue(new StartingContext(plant(), folder, new Health()))) {
      queue.execute("test", "cell1", "MYINT", "2", null, results::add);
      queue.execute("test", "cell2", "MYINT", "2", null, results::add);
    }

    assertThat(results)
        .containsExactly(
            "not executed: the gateway is starting the robot", "no robot is named cell2");
  }

  @Test
  void aCommandThatWaitsWhenTheGatewayEndsIsRefused() throws Exception {
    server.variables().set("MYINT", "1");
    Plant plant = plant();
    CountDownLatch released = new CountDownLatch(1);
    BlockingQueue<String> results = new LinkedBlockingQueue<>();
    try (RobotFeed feed =
        RobotFeed.open(plant.plans().get(0), RobotConnection::open, (one, updates) -> {})) {
      CommandQueue queue = new CommandQueue(new OneRobotContext(plant, feed, folder, new Health()));
      executeAndLetTheNextWait(queue, results, released);

      Thread closing = new Thread(queue::close);
      closing.start();
      String refused;
      do {
        BlockingQueue<String> other = new LinkedBlockingQueue<>();
        queue.execute("test", "cell9", "MYINT", "9".repeat(5000), null, other::add);
        refused = other.take();
      } while (!refused.endsWith("the gateway ends"));
      released.countDown();

      assertThat(results.take()).isEqualTo("not executed: the gateway ends");
      closing.join();
    }
    assertThat(server.variables().get("MYINT")).isEqualTo("2");
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("\"after\":\"3\",\"result\":\"not executed: the gateway ends\"");
  }

  /** Executes a command that ends when it is released, and submits another one. */
  private static void executeAndLetTheNextWait(
      CommandQueue queue, BlockingQueue<String> results, CountDownLatch released)
      throws InterruptedException {
    queue.execute(
        "test",
        "cell1",
        "MYINT",
        "2",
        null,
        result -> {
          results.add(result);
          Latches.await(released);
        });
    assertThat(results.take()).isEqualTo("done");
    queue.execute("test", "cell1", "MYINT", "3", null, results::add);
  }
}
