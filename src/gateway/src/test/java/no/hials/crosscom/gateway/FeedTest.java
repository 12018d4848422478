package no.hials.crosscom.gateway;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.ClientRuntime;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cell.TomlTable;
import no.hials.crosscom.cell.feed.Plant;
import no.hials.crosscom.cell.feed.PlantFile;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.RefusedWriteException;
import no.hials.crosscom.cell.feed.RobotFeed;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.cell.feed.Writes;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlValue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The readings of one robot, and the writes to it. */
@Timeout(60)
class FeedTest {
  private static final String WRITABLE =
      """
      [variables.MYINT]
      write = true
      range = [0, 100]

      [variables."$OUT[4]"]
      write = true
      values = ["TRUE", "FALSE"]

      [variables."$MODE_OP"]
      write = true
      values = ["#T1"]

      [variables."TASK[]"]
      write = true
      values = ["Home"]

      [variables.MYFRAME]
      write = true
      range = [0, 1]
      """;

  private static final String FAST =
      """
      [groups.fast]
      variables = ["MYINT"]
      period = "1ms"
      """;

  @KukaController private MockServer robot;
  @TempDir private Path folder;
  private final BlockingQueue<Update> updates = new LinkedBlockingQueue<>();
  private Plant plant;
  private RobotFeed feed;

  @AfterEach
  void close() throws IOException {
    feed.close();
  }

  private void start(String group, String more) throws IOException {
    start(group, more, RobotConnection::openLazily);
  }

  private void start(String group, String more, RobotConnection.Opener opener) throws IOException {
    String text =
        """
        [robots.cell1]
        host = "%s:%d"
        timeout = "10s"
        [limits]
        load = 100
        [groups.all]
        period = "20ms"
        %s
        %s
        """
            .formatted(robot.host(), robot.port(), group, more);
    plant = PlantFile.read(TomlTable.parse(Path.of("plant.toml"), text), Map.of());
    feed = RobotFeed.open(plant.plans().get(0), opener, (source, some) -> updates.addAll(some));
    feed.start();
  }

  /** Returns the next update of a kind. */
  private Update next(Predicate<Update> kind) throws InterruptedException {
    Update update = updates.take();
    while (!kind.test(update)) {
      update = updates.take();
    }
    return update;
  }

  private static Predicate<Update> is(String variable, double value) {
    return update -> update.variable().name().equals(variable) && number(update) == value;
  }

  private static double number(Update update) {
    KrlValue value = update.value();
    return value == null || update.quality() != Quality.GOOD ? Double.NaN : value.asDouble();
  }

  @Test
  void onlyChangesBeyondTheDeadBandArePassedOn() throws Exception {
    robot.variables().set("MYREAL", "1.0");
    robot.variables().set("MYINT", "1");
    start("variables = [\"MYREAL\", \"MYINT\"]\non-change = true\ndead-band = 0.5", "");
    next(is("MYINT", 1));
    robot.variables().set("MYREAL", "1.4");
    robot.variables().set("MYINT", "2");
    next(is("MYINT", 2));
    robot.variables().set("MYREAL", "1.6");
    robot.variables().set("MYINT", "3");

    List<Double> seen = new ArrayList<>();
    for (Update update = updates.take(); !is("MYREAL", 1.6).test(update); update = updates.take()) {
      seen.add(number(update));
    }

    assertThat(seen).isSubsetOf(2.0, 3.0);
  }

  @Test
  void aFieldIsReadByItsStructureAndPassedOnAlone() throws Exception {
    robot.variables().set("MYFRAME", "{X 1.5,Y 2.5,Z 3.5,A 0.0,B 0.0,C 0.0}");
    start("variables = [\"MYFRAME.X\", \"MYFRAME.Y\"]", "");

    next(is("MYFRAME.X", 1.5));
    next(is("MYFRAME.Y", 2.5));

    assertThat(robot.requests())
        .flatExtracting(RecordedRequest::names)
        .contains("MYFRAME")
        .doesNotContain("MYFRAME.X");
  }

  @Test
  void aStructureWithEverNewFieldsIsBadAndGoodAgainWithThoseThatAreKnown() throws Exception {
    AtomicReference<String> fields = new AtomicReference<>("A");
    robot.faults(
        request ->
            request.name().equals("MYS")
                ? Optional.of(Fault.answer(structure(fields.get()), Tail.SUCCESS))
                : Optional.empty());
    start("variables = [\"MYS\"]", "");
    Update good = next(update -> update.quality() == Quality.GOOD);

    fields.set("B");

    Update bad = next(update -> update.quality() == Quality.BAD);
    assertThat(bad.value()).isNull();
    assertThat(bad.reason())
        .isEqualTo("MYS has more than 1000 fields, with those of earlier readings");

    fields.set("A");

    assertThat(updates.take().value()).isEqualTo(good.value());
  }

  /** Returns a structure with 600 fields. */
  private static String structure(String prefix) {
    return IntStream.range(0, 600)
        .mapToObj(i -> prefix + i + " 1")
        .collect(Collectors.joining(", ", "{MYS: ", "}"));
  }

  @Test
  void anUnknownVariableIsBadAndTheOthersAreGood() throws Exception {
    start("variables = [\"NOSUCH\", \"$OV_PRO\"]", "");

    Update bad = next(update -> update.quality() == Quality.BAD);

    assertThat(bad.variable().name()).isEqualTo("NOSUCH");
    assertThat(bad.value()).isNull();
    assertThat(bad.reason()).contains("NOSUCH");
    next(is("$OV_PRO", 100));
    next(is("$OV_PRO", 100));
    assertThat(updates).noneMatch(update -> update.quality() == Quality.BAD);
  }

  @Test
  void valuesAreStaleOnceWhileTheRobotIsOffAndGoodAgainAfterwards() throws Exception {
    start("variables = [\"$OV_PRO\"]\non-change = true", "");
    Update good = next(is("$OV_PRO", 100));

    robot.refuseConnections();
    robot.disconnectClients();

    Update stale = next(update -> update.quality() == Quality.STALE);
    assertThat(stale.value()).isEqualTo(good.value());
    assertThat(stale.time()).isAfterOrEqualTo(good.time());
    assertThat(stale.reason()).isNotEmpty();
    assertThat(feed.isConnected()).isFalse();

    robot.acceptConnections();

    Update next = updates.take();
    assertThat(next.quality()).isEqualTo(Quality.GOOD);
    assertThat(feed.isConnected()).isTrue();
  }

  @Test
  void valuesAreStaleWhileTheRobotKeepsAReadingWaiting() throws Exception {
    start("variables = [\"$OV_PRO\"]", "");
    next(is("$OV_PRO", 100));
    CountDownLatch released = new CountDownLatch(1);
    robot.fault(request -> true, Fault.hold(released));

    Update stale = null;
    while (stale == null) {
      feed.checkAges();
      stale = updates.poll(10, TimeUnit.MILLISECONDS);
      stale = stale != null && stale.quality() == Quality.STALE ? stale : null;
    }
    released.countDown();

    assertThat(stale.value()).isEqualTo(new KrlInt(100));
  }

  @Test
  void aValueThatWaitedTooLongForTheRestOfItsReadingIsStale() throws Exception {
    robot.variables().set("MYREAL", "1.0");
    robot.variables().set("MYINT", "1");
    start("variables = [\"MYREAL\", \"MYINT\"]", "");
    next(is("MYINT", 1));
    CountDownLatch arrived = new CountDownLatch(1);
    CountDownLatch released = new CountDownLatch(1);
    robot.fault(
        request -> {
          boolean second = request.name().equals("MYINT");
          if (second) {
            arrived.countDown();
          }
          return second;
        },
        Fault.hold(released));
    Latches.await(arrived);
    long read = System.nanoTime();
    Duration limit = Duration.ofMillis(2 * 20 + 1000);
    while (System.nanoTime() - read < limit.toNanos()) {
      var unused = updates.poll(10, TimeUnit.MILLISECONDS);
    }
    released.countDown();

    Update late = next(update -> update.quality() == Quality.STALE);
    assertThat(late.variable().name()).isEqualTo("MYREAL");
    assertThat(late.value()).isEqualTo(KrlValue.parse("1.0"));
    assertThat(late.reason()).isEqualTo("the controller has not answered in time");
  }

  @Test
  void aValueThatWaitedTooLongForAThreadIsStale() throws Exception {
    robot.variables().set("MYINT", "1");
    CountDownLatch blocked = new CountDownLatch(1);
    CountDownLatch released = new CountDownLatch(1);
    try (ClientRuntime runtime = ClientRuntime.create(cfg -> cfg.listenerThreads(1));
        CrossComClient other =
            new CrossComClient(
                ClientConfig.create(
                    robot.host(), cfg -> cfg.port(robot.port()).runtime(runtime)))) {
      other.watch(
          Duration.ofMillis(20),
          sample -> {
            blocked.countDown();
            Latches.await(released);
          },
          "MYINT");
      Latches.await(blocked);
      start(
          "variables = [\"MYINT\"]",
          "",
          (one, settings) ->
              RobotConnection.open(one, settings.andThen(cfg -> cfg.runtime(runtime))));
      while (feed.polls() == 0) {
        Thread.onSpinWait();
      }
      LockSupport.parkNanos(Duration.ofMillis(2 * 20 + 1100).toNanos());
      released.countDown();

      assertThat(updates.take().quality()).isEqualTo(Quality.STALE);
      next(is("MYINT", 1));
    }
  }

  @Test
  void repeatPassesOnAllThatIsKnown() throws Exception {
    start("variables = [\"$OV_PRO\", \"NOSUCH\"]\non-change = true", "");
    next(update -> update.quality() == Quality.BAD); // the last of its sample
    updates.clear();

    feed.repeat();

    assertThat(updates)
        .extracting(update -> update.variable().name())
        .containsExactlyInAnyOrder("$OV_PRO", "NOSUCH");
  }

  // writes

  private static final Duration SOON = Duration.ofSeconds(50);

  private Writes writes() {
    return new Writes(new AuditLog(folder));
  }

  private String lastAudit() throws IOException {
    List<String> lines = Files.readAllLines(folder.resolve("audit.jsonl"));
    return lines.get(lines.size() - 1);
  }

  @Test
  void anAllowedWriteIsSentOnceWithALineInTheAuditLog() throws Exception {
    robot.variables().set("MYINT", "3");
    start("variables = [\"MYINT\"]", WRITABLE);
    next(is("MYINT", 3));

    writes().write("mqtt:plc", plant, feed, "myint", " 42 ", SOON);

    assertThat(robot.variables().get("MYINT")).isEqualTo("42");
    assertThat(robot.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
    assertThat(lastAudit())
        .contains("\"who\":\"mqtt:plc\"")
        .contains("\"robot\":\"cell1\"")
        .contains("\"before\":\"3\",\"after\":\"42\",\"result\":\"done\"");
  }

  @Test
  void theAuditLogHasNoNewValueAsTheOneBefore() throws Exception {
    start("variables = [\"$OV_PRO\"]", WRITABLE + FAST);
    next(is("MYINT", 0));
    Writes writes = writes();

    for (int value = 1; value <= 100; value++) {
      writes.write("mqtt:plc", plant, feed, "MYINT", String.valueOf(value), SOON);

      assertThat(lastAudit()).doesNotContain("\"before\":\"" + value + "\"");
    }
  }

  @Test
  void aListedTextOrConstantIsWritten() throws Exception {
    robot.variables().declare("TASK[8]", "CHAR", "\"Away\"");
    start("variables = [\"$OV_PRO\"]", WRITABLE);

    writes().write("mqtt", plant, feed, "TASK[]", "\"Home\"", SOON);
    writes().write("mqtt", plant, feed, "$OUT[4]", "true", SOON);

    assertThat(robot.variables().get("TASK[]")).isEqualTo("\"Home\"");
    assertThat(robot.requests()).filteredOn(RecordedRequest::isWrite).hasSize(2);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "$OV_PRO | 50 | the configuration does not allow it",
        "MYREAL | 5 | the configuration does not allow it",
        "MYINT | 101 | must be 0.0 to 100.0, is 101",
        "MYINT | -1 | must be 0.0 to 100.0, is -1",
        "MYINT | 1E400 | was not written",
        "MYINT | TRUE | must be a number of 0.0 to 100.0, is TRUE",
        "MYINT | {X 1} | a field or an element can be written",
        "MYINT | ] | the value is not one of KRL",
        "TASK[] | \"hOmE\" | must be one of Home, is \"hOmE\"",
        "TASK[] | \"Home \" | must be one of Home, is \"Home \"",
        "$MODE_OP | #T2 | must be one of #T1, is #T2",
        "$OUT[4] | 1 | must be one of TRUE, FALSE, is 1",
        "MYFRAME | {X 1} | a field or an element can be written",
      })
  void aWriteThatIsNotAllowedIsNotSent(String name, String text, String reason) throws Exception {
    start("variables = [\"$OV_PRO\"]", WRITABLE);

    assertThatThrownBy(() -> writes().write("mqtt", plant, feed, name, text, SOON))
        .isInstanceOf(RefusedWriteException.class)
        .hasMessageContaining("cell1: " + name)
        .hasMessageContaining(reason);

    assertThat(robot.requests()).noneMatch(RecordedRequest::isWrite);
    assertThat(lastAudit()).contains("was not written");
  }

  @Test
  void aWriteWithoutAnAnswerHasAnUnknownOutcomeAndIsNotRepeated() throws Exception {
    start("variables = [\"$OV_PRO\"]", WRITABLE);
    robot.fault(RecordedRequest::isWrite, Fault.dropAnswer());

    assertThatThrownBy(() -> writes().write("mqtt", plant, feed, "MYINT", "7", SOON))
        .isInstanceOf(CrossComException.class)
        .hasMessageContaining("unknown");

    assertThat(robot.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
    assertThat(lastAudit()).contains("unknown");
  }

  @Test
  void aWriteThatWaitsForTheConnectionIsNotSentAfterTheEnd() throws Exception {
    robot.variables().set("MYINT", "3");
    start("variables = [\"$OV_PRO\"]", WRITABLE);
    CountDownLatch released = new CountDownLatch(1);
    CountDownLatch arrived = Latches.holdWrites(robot, released);
    Writes writes = writes();
    CompletableFuture<Void> running = write(writes, "7");
    arrived.await();
    CompletableFuture<Void> waiting = write(writes, "8");

    writes.end();
    released.countDown();

    running.get();
    assertThatThrownBy(waiting::get)
        .hasRootCauseInstanceOf(RefusedWriteException.class)
        .hasMessageContaining("was not written: the gateway ends");
    assertThat(robot.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
  }

  private CompletableFuture<Void> write(Writes writes, String value) {
    return CompletableFuture.runAsync(
        () -> {
          try {
            writes.write("mqtt", plant, feed, "MYINT", value, SOON);
          } catch (IOException e) {
            throw new CompletionException(e);
          }
        },
        task -> new Thread(task).start());
  }

  @Test
  void aReadOnlyRobotIsNotWritten() throws Exception {
    start("variables = [\"$OV_PRO\"]", WRITABLE);
    feed.close();
    String text = "[robots.cell1]\nhost = \"%s:%d\"\nread-only = true\n%s";
    plant =
        PlantFile.read(
            TomlTable.parse(
                Path.of("plant.toml"), text.formatted(robot.host(), robot.port(), WRITABLE)),
            Map.of());
    feed = RobotFeed.open(plant.plans().get(0), RobotConnection::openLazily, (source, some) -> {});

    assertThatThrownBy(() -> writes().write("mqtt", plant, feed, "MYINT", "7", SOON))
        .hasMessage("cell1: MYINT was not written: read-only = true in plant.toml:3");
    assertThat(robot.requests()).noneMatch(RecordedRequest::isWrite);
    assertThat(KrlValue.parse(robot.variables().get("MYINT"))).isNotNull();
  }

  @Test
  void aLineThatTheDiskDoesNotTakeIsLogged() throws Exception {
    start("variables = [\"MYINT\"]", WRITABLE);
    Path noFolder = Files.writeString(folder.resolve("file"), "");
    try (LogLines lines = LogLines.of(AuditLog.class)) {
      new Writes(new AuditLog(noFolder)).write("mqtt:plc", plant, feed, "MYINT", "42", SOON);

      assertThat(lines.get())
          .singleElement()
          .asString()
          .contains("\"who\":\"mqtt:plc\"", "\"after\":\"42\",\"result\":\"done\"");
    }
  }
}
