package no.hials.crosscom.gateway.internal.opcua;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import no.hials.crosscom.cell.Moment;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PlantFile;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.gateway.Health;
import no.hials.crosscom.gateway.Latches;
import no.hials.crosscom.gateway.OneRobotContext;
import no.hials.crosscom.gateway.internal.writing.Pauses;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Tail;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class RobotWritesTest {
  /** The common pool may have one thread only. */
  private static final Executor THREADS = task -> new Thread(task).start();

  private static final User ANNA = new User("anna", User.Role.OPERATOR, null, null);

  @KukaController private MockServer server;
  @TempDir private Path folder;
  private final AtomicLong now = new AtomicLong();

  /** The time for the detection of pauses of the gateway. */
  private final AtomicLong pause = new AtomicLong();

  /** The ms of the other clock, which goes on while the machine is suspended. */
  private final AtomicLong wall = new AtomicLong();

  private final AtomicBoolean wanted = new AtomicBoolean(true);
  private final CountDownLatch released = new CountDownLatch(1);
  private final Health health = new Health();
  private RobotFeed feed;
  private RobotWrites writes;

  @BeforeEach
  void open() throws Exception {
    String text =
        """
        [robots.cell1]
        host = "%s:%d"
        timeout = "50s"
        [variables.MYINT]
        range = [0, 10]
        write = true
        """
            .formatted(server.host(), server.port());
    Plant plant = PlantFile.read(TomlTable.parse(Path.of("plant.toml"), text), Map.of());
    feed = RobotFeed.open(plant.plans().get(0), RobotConnection::open, (one, updates) -> {});
    writes =
        new RobotWrites(
            new OneRobotContext(plant, feed, folder, health),
            now::get,
            new Pauses(() -> new Moment(pause.get(), wall.get())));
    server.variables().set("MYINT", "1");
  }

  @AfterEach
  void close() throws Exception {
    released.countDown();
    writes.close();
    feed.close();
  }

  private RobotWrites.Request request() {
    return RobotWrites.request(writes.arrival(), ANNA, Duration.ZERO, wanted::get);
  }

  private CompletableFuture<Long> write(RobotWrites.Request request, String value) {
    return CompletableFuture.supplyAsync(
        () -> writes.write(request, "cell1", "MYINT", value), THREADS);
  }

  /** Begins a write that the robot answers when it is released. */
  private CompletableFuture<Long> beginSlowWrite() {
    CountDownLatch arrived = Latches.holdWrites(server, released);
    CompletableFuture<Long> slow = write(request(), "2");
    Latches.await(arrived);
    return slow;
  }

  @Test
  void aWriteThatWaitedTooLongIsRefusedWithALineInTheAuditLog() throws Exception {
    CompletableFuture<Long> slow = beginSlowWrite();
    CompletableFuture<Long> next = write(request(), "3");

    now.set(Duration.ofSeconds(5).toNanos() + 1);
    CompletableFuture<Long> later = write(request(), "4");
    released.countDown();

    assertThat(slow.join()).isEqualTo(StatusCodes.Good);
    assertThat(next.join()).isEqualTo(StatusCodes.Bad_TooManyOperations);
    assertThat(later.join()).isEqualTo(StatusCodes.Good);
    assertThat(server.variables().get("MYINT")).isEqualTo("4");
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).hasSize(2);
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains(
            "\"who\":\"opcua:anna\"",
            "\"after\":\"3\",\"result\":\"not written: it waited more than 5 s for others to end\"");
  }

  @Test
  void aWriteToARobotThatIsGoneIsRefusedWithALineInTheAuditLog() throws Exception {
    assertThat(writes.write(request(), "cell9", "MYINT", "3"))
        .isEqualTo(StatusCodes.Bad_NodeIdUnknown);

    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains(
            "\"robot\":\"cell9\"",
            "\"after\":\"3\",\"result\":\"not written: its connection was closed\"");
  }

  @Test
  void aWriteWhoseRobotIsClosedInTheMeantimeIsNoRefusalOfTheController() throws Exception {
    feed.close();

    assertThat(write(request(), "3").join()).isEqualTo(StatusCodes.Bad_NodeIdUnknown);

    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).isEmpty();
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("\"after\":\"3\",\"result\":\"the client is closed\"");
  }

  @Test
  void aWriteAfterTheEndIsRefusedWithALineInTheAuditLog() throws Exception {
    assertThat(write(request(), "2").join()).isEqualTo(StatusCodes.Good);
    writes.close();

    assertThat(write(request(), "3").join()).isEqualTo(StatusCodes.Bad_Shutdown);

    assertThat(server.variables().get("MYINT")).isEqualTo("2");
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("\"after\":\"3\",\"result\":\"not written: the gateway ends\"");
  }

  @Test
  void aWriteWhoseSessionHasEndedIsRefusedWithALineInTheAuditLog() throws Exception {
    CompletableFuture<Long> slow = beginSlowWrite();
    CompletableFuture<Long> next = write(request(), "3");

    wanted.set(false);
    released.countDown();

    assertThat(slow.join()).isEqualTo(StatusCodes.Good);
    assertThat(next.join()).isEqualTo(StatusCodes.Bad_SessionClosed);
    assertThat(server.variables().get("MYINT")).isEqualTo("2");
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains(
            "\"after\":\"3\",\"result\":\"not written: the session of the client has ended\"");
  }

  @Test
  void aWriteThatItsClientNoLongerWaitsForIsRefusedWithALineInTheAuditLog() throws Exception {
    CompletableFuture<Long> slow = beginSlowWrite();
    CompletableFuture<Long> next =
        write(RobotWrites.request(writes.arrival(), ANNA, Duration.ofSeconds(1), wanted::get), "3");
    CompletableFuture<Long> patient =
        write(RobotWrites.request(writes.arrival(), ANNA, Duration.ofSeconds(4), wanted::get), "4");

    now.set(Duration.ofSeconds(1).toNanos() + 1);
    released.countDown();

    assertThat(slow.join()).isEqualTo(StatusCodes.Good);
    assertThat(next.join()).isEqualTo(StatusCodes.Bad_RequestTimeout);
    assertThat(patient.join()).isEqualTo(StatusCodes.Good);
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("\"after\":\"3\",\"result\":\"not written: the client no longer waits for it\"");
  }

  @Test
  void aWriteThatArrivesAfterAPauseOfTheGatewayIsRefusedWithALineInTheAuditLog() throws Exception {
    pause.set(Duration.ofMillis(600).toNanos());
    RobotWrites.Request hasty =
        RobotWrites.request(writes.arrival(), ANNA, Duration.ofMillis(600), wanted::get);
    assertThat(write(hasty, "3").join()).isEqualTo(StatusCodes.Bad_RequestTimeout);
    assertThat(write(request(), "4").join()).isEqualTo(StatusCodes.Good);

    pause.addAndGet(Duration.ofMillis(4400).toNanos());

    assertThat(write(request(), "5").join()).isEqualTo(StatusCodes.Bad_RequestTimeout);
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains(
            "\"after\":\"3\",\"result\":\"not written: the gateway was frozen for 0.6 s",
            "\"after\":\"5\",\"result\":\"not written: the gateway was frozen for 5.0 s");
  }

  @Test
  void aWriteThatTheControllerAnswersWithAnotherValueHasAnUnknownOutcome() throws Exception {
    server.fault(RecordedRequest::isWrite, Fault.answer("7", Tail.SUCCESS));

    assertThat(write(request(), "3").join()).isEqualTo(StatusCodes.Bad_CommunicationError);

    assertThat(health.counter("opcua_writes", "", "result").labelValues("unknown").get()).isOne();
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains("3 was sent, but the answer to the write is 7");
  }

  @Test
  void aWriteThatOnlyWaitedForAReadingIsNoRefusalOfTheController() throws Exception {
    CompletableFuture<String> reading = beginSlowReading();
    feed.client().setSoTimeout(100); // of calls from now on

    assertThat(write(request(), "3").join()).isEqualTo(StatusCodes.Bad_ResourceUnavailable);

    released.countDown();
    assertThat(reading.join()).isEqualTo("100");
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).isEmpty();
  }

  @Test
  void aWriteThatWaitsForAReadingLongerThanItsClientWaitsIsNotSent() throws Exception {
    CompletableFuture<String> reading = beginSlowReading();
    RobotWrites.Request request =
        RobotWrites.request(writes.arrival(), ANNA, Duration.ofMillis(20), wanted::get);

    assertThat(write(request, "3").join()).isEqualTo(StatusCodes.Bad_RequestTimeout);

    assertNotSent(reading);
  }

  @Test
  void aWriteThatWaitsForAReadingLongerThanTheLimitIsNotSent() throws Exception {
    CompletableFuture<String> reading = beginSlowReading();
    RobotWrites.Request request =
        RobotWrites.request(writes.arrival(), ANNA, Duration.ofSeconds(9), wanted::get);
    now.set(Duration.ofSeconds(5).minusMillis(20).toNanos());

    assertThat(write(request, "3").join()).isEqualTo(StatusCodes.Bad_TooManyOperations);

    assertNotSent(reading);
  }

  private void assertNotSent(CompletableFuture<String> reading) throws Exception {
    released.countDown();
    assertThat(reading.join()).isEqualTo("100");
    assertThat(write(request(), "4").join()).isEqualTo(StatusCodes.Good);
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
    assertThat(server.variables().get("MYINT")).isEqualTo("4");
    assertThat(Files.readString(folder.resolve("audit.jsonl")))
        .contains(
            "\"after\":\"3\",\"result\":\"cell1: MYINT was not written: it waited too long for the"
                + " connection to the robot\"");
  }

  /** Begins a reading that the robot answers when it is released. */
  private CompletableFuture<String> beginSlowReading() {
    CountDownLatch arrived = new CountDownLatch(1);
    server.fault(
        it -> {
          boolean slow = it.name().equals("$OV_PRO");
          if (slow) {
            arrived.countDown();
          }
          return slow;
        },
        Fault.hold(released));
    // without async, which would also wait for the write of another async
    CompletableFuture<String> reading =
        CompletableFuture.supplyAsync(() -> readText("$OV_PRO"), THREADS);
    Latches.await(arrived);
    return reading;
  }

  private String readText(String name) {
    try {
      return feed.client().readText(name);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aWriteThatArrivesAfterTheMachineWasSuspendedIsRefused() {
    wall.set(5_001);

    assertThat(write(request(), "3").join()).isEqualTo(StatusCodes.Bad_RequestTimeout);
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).isEmpty();
  }
}
