package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import no.hials.crosscom.cell.AuditLog;
import no.hials.crosscom.cell.Moment;
import no.hials.crosscom.cell.feed.Writes;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import org.apache.kafka.common.record.TimestampType;
import org.apache.kafka.connect.sink.SinkRecord;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The writes of claimed records, with two robots. */
@Timeout(60)
class CommandWriterTest {
  private static final Duration MAX_AGE = Duration.ofMinutes(1);

  @KukaController private MockServer first;
  @KukaController private MockServer second;
  @TempDir private Path folder;
  private final Lease lease = new Lease(Duration.ofHours(1));
  private CommandWriter writer;
  private long offset;

  @BeforeEach
  void open() throws Exception {
    String text =
        """
        [robots.r1]
        host = "%s"
        port = %d
        [robots.r2]
        host = "%s"
        port = %d
        [variables."$OV_PRO"]
        write = true
        range = [0, 100]
        """
            .formatted(first.host(), first.port(), second.host(), second.port());
    lease.renew(Moment.now());
    writer = writer(text, lease);
  }

  private Path file() {
    return folder.resolve("plant.toml");
  }

  private CommandWriter writer(String text, Lease own) throws Exception {
    Files.writeString(file(), text);
    return new CommandWriter(
        new TaskPlant(file().toString(), text), new Writes(new AuditLog(folder)), own, MAX_AGE);
  }

  @AfterEach
  void close() {
    writer.close();
  }

  private CommandWriter writer(String robot, int port, Lease own) throws Exception {
    String text =
        "[robots.%s]\nhost = \"127.0.0.1\"\nport = %d\ntimeout = \"3s\"\n".formatted(robot, port);
    return writer(text, own);
  }

  private CommandWriter writer(Duration maxAge, Duration limit) throws Exception {
    return writer(maxAge, limit, System::currentTimeMillis);
  }

  private CommandWriter writer(Duration maxAge, Duration limit, LongSupplier clock)
      throws Exception {
    TaskPlant plant = new TaskPlant(file().toString(), Files.readString(file()));
    Writes writes = new Writes(new AuditLog(folder));
    return new CommandWriter(plant, writes, lease, maxAge, limit, clock);
  }

  private String audit() throws Exception {
    return Files.readString(folder.resolve("audit.jsonl"));
  }

  private SinkRecord record(String robot, long value, Duration age) {
    return record(Map.of("robot", robot, "variable", "$OV_PRO", "value", value), age);
  }

  private SinkRecord record(Map<String, ?> command, Duration age) {
    long time = System.currentTimeMillis() - age.toMillis();
    return new SinkRecord(
        "commands", 0, null, null, null, command, offset++, time, TimestampType.CREATE_TIME);
  }

  private SinkRecord record(String robot, long value) {
    return record(robot, value, Duration.ZERO);
  }

  private static List<String> written(MockServer robot) {
    return robot.requests().stream()
        .filter(RecordedRequest::isWrite)
        .map(RecordedRequest::value)
        .toList();
  }

  private String failure(SinkRecord record) {
    return writer.write(List.of(record)).get(record).orElseThrow().getMessage();
  }

  @Test
  void aRobotThatDoesNotAnswerDelaysNoOther() throws Exception {
    CountDownLatch answer = new CountDownLatch(1);
    first.fault(RecordedRequest::isWrite, Fault.hold(answer));
    SinkRecord slow = record("r1", 40);
    SinkRecord quick = record("r2", 30);
    CompletableFuture<Map<SinkRecord, Optional<Exception>>> outcomes =
        CompletableFuture.supplyAsync(() -> writer.write(List.of(slow, quick)));
    while (written(second).isEmpty()) {
      var unused = second.takeRequest(Duration.ofSeconds(1));
    }
    answer.countDown();
    assertThat(outcomes.get()).containsEntry(slow, Optional.empty());
    assertThat(outcomes.get()).containsEntry(quick, Optional.empty());
  }

  @Test
  void afterAWriteWithoutAnAnswerNoFurtherOneOfTheBatchIsSent() {
    first.fault(RecordedRequest::isWrite, Fault.dropAnswer());
    SinkRecord one = record("r1", 40);
    SinkRecord two = record("r1", 41);
    var outcomes = writer.write(List.of(one, two));
    assertThat(outcomes.get(one).orElseThrow()).hasMessageContaining("the outcome is unknown");
    assertThat(outcomes.get(two).orElseThrow())
        .hasMessage("not written: r1 has not answered the command before");
    assertThat(written(first)).containsExactly("40");
    first.clearFaults();
    assertThat(writer.write(List.of(record("r1", 42))).values()).containsExactly(Optional.empty());
    assertThat(written(first)).containsExactly("40", "42");
  }

  @Test
  void aRobotThatCannotBeReachedIsToldEvenIfTheLeaseEndsMeanwhile() throws Exception {
    Lease brief = new Lease(Duration.ofSeconds(2));
    // a full backlog makes the system drop the request to connect
    try (ServerSocket full = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        Socket accepted = new Socket(full.getInetAddress(), full.getLocalPort());
        Socket waiting = new Socket(full.getInetAddress(), full.getLocalPort());
        CommandWriter impatient = writer("r3", full.getLocalPort(), brief)) {
      SinkRecord one = record("r3", 40);
      SinkRecord two = record("r3", 41);
      brief.renew(Moment.now());
      var outcomes = impatient.write(List.of(one, two));
      assertThat(brief.isHeld()).isFalse();
      assertThat(outcomes.get(one).orElseThrow()).hasMessageContaining("no answer within 3000 ms");
      assertThat(outcomes.get(two).orElseThrow())
          .hasMessage("not written: r3 has not answered the command before");
      assertThat(List.of(accepted, waiting)).allMatch(Socket::isConnected);
    }
  }

  @Test
  void aConnectionThatBreaksBeforeTheWriteSaysThatNothingWasWritten() throws Exception {
    AtomicInteger asked = new AtomicInteger();
    try (ServerSocket full = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      String text =
          Files.readString(file())
              .replace("port = " + first.port(), "port = " + full.getLocalPort());
      Files.writeString(file(), text);
      // the time is asked for before the connection is made, and then before the write
      LongSupplier clock =
          () -> {
            if (asked.incrementAndGet() == 2) {
              close(full);
            }
            return System.currentTimeMillis();
          };
      try (CommandWriter other = writer(MAX_AGE, Duration.ofHours(1), clock)) {
        SinkRecord command = record("r1", 40);
        assertThat(other.write(List.of(command)).get(command).orElseThrow())
            .hasMessageStartingWith("not written: ")
            .hasMessageContaining("broke");
      }
    }
  }

  /** Closes the next connection, as a server that has too many clients. */
  private static void close(ServerSocket server) {
    try {
      server.accept().close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aRecordThatBecomesTooOldWhileTheTaskConnectsIsNotWritten() throws Exception {
    SinkRecord command = record("r1", 40);
    AtomicLong time = new AtomicLong(command.timestamp());
    LongSupplier clock = () -> time.getAndAdd(MAX_AGE.toMillis() + 1);
    try (CommandWriter slow = writer(MAX_AGE, Duration.ofHours(1), clock)) {
      assertThat(slow.write(List.of(command)).get(command).orElseThrow())
          .hasMessage(
              "r1: $OV_PRO was not written: it waited too long for the connection to the robot");
    }
    assertThat(written(first)).isEmpty();
  }

  @Test
  void afterTheTimeLimitOnlyTheFirstRecordOfEachRobotIsSent() throws Exception {
    try (CommandWriter brief = writer(MAX_AGE, Duration.ZERO)) {
      SinkRecord one = record("r1", 1);
      SinkRecord two = record("r1", 2);
      SinkRecord old = record("r1", 3, MAX_AGE.plusMinutes(1));
      SinkRecord four = record("r2", 4);
      SinkRecord five = record("r2", 5);
      assertThat(brief.write(List.of(one, two, old, four, five)))
          .containsOnlyKeys(one, old, four)
          .containsEntry(one, Optional.empty())
          .containsEntry(four, Optional.empty());
      assertThat(brief.write(List.of(two, five))).hasSize(2);
    }
    assertThat(written(first)).containsExactly("1", "2");
    assertThat(written(second)).containsExactly("4", "5");
  }

  @Test
  void aFaultOfThisProgramIsTheOutcomeOfOneRecord() throws Exception {
    Duration tooLong = Duration.ofMillis(Long.MAX_VALUE);
    try (CommandWriter faulty = writer(tooLong, Duration.ofHours(1))) {
      SinkRecord fault = record("r1", 1);
      SinkRecord right = record("r1", 2, tooLong.minusMinutes(1));
      SinkRecord other = record("r2", 3, tooLong.minusMinutes(1));
      var outcomes = faulty.write(List.of(fault, right, other));
      assertThat(outcomes.get(fault).orElseThrow())
          .hasMessage("outcome unknown: java.lang.ArithmeticException: long overflow");
      assertThat(outcomes)
          .containsEntry(right, Optional.empty())
          .containsEntry(other, Optional.empty());
    }
    assertThat(audit())
        .contains("\"after\":\"1\",\"result\":\"java.lang.ArithmeticException: long overflow\"");
  }

  @Test
  void aCommandForARobotThatIsNotInTheFileHasALineInTheAuditLog() throws Exception {
    assertThat(failure(record("r9", 40))).isEqualTo("no robot is named r9");
    assertThat(audit())
        .contains("\"who\":\"kafka:commands-0@0\"", "\"robot\":\"r9\"", "\"after\":\"40\"")
        .contains("\"result\":\"no robot is named r9\"");
  }

  @Test
  void theRecordsOfARobotAreWrittenInTheirOrder() {
    var unused = writer.write(List.of(record("r1", 1), record("r2", 2), record("r1", 3)));
    assertThat(written(first)).containsExactly("1", "3");
    assertThat(written(second)).containsExactly("2");
  }

  @Test
  void withoutTheLeaseNothingIsSentAndNothingIsDone() {
    lease.end();
    assertThat(writer.write(List.of(record("r1", 40)))).isEmpty();
    assertThat(first.requests()).isEmpty();
  }

  @Test
  void whileTheFileDiffersNothingIsSentAndNothingIsDone() throws Exception {
    String text = Files.readString(file());
    SinkRecord command = record("r1", 40);
    for (String other : List.of(text.replace("write = true", "write = false"), text + "[half")) {
      Files.writeString(file(), other);
      assertThat(writer.isCurrent()).isFalse();
      assertThat(writer.write(List.of(command))).isEmpty();
    }
    Files.delete(file());
    assertThat(writer.write(List.of(command))).isEmpty();
    assertThat(first.requests()).isEmpty();
    Files.writeString(file(), text);
    assertThat(writer.isCurrent()).isTrue();
    assertThat(writer.write(List.of(command))).containsEntry(command, Optional.empty());
  }

  @Test
  void nothingIsWrittenIfTheFileForbidsItWhileTheServerIsDetected() throws Exception {
    String text =
        """
        [robots.r1]
        host = "%s"
        port = %d
        [variables."TASK[]"]
        write = true
        values = ["Home"]
        """
            .formatted(first.host(), first.port());
    Map<String, ?> value = Map.of("robot", "r1", "variable", "TASK[]", "value", "\"Home\"");
    SinkRecord command = record(value, Duration.ZERO);
    first.variables().declare("TASK[8]", "CHAR", "\"Away\"");
    CountDownLatch answer = new CountDownLatch(1);
    // a text has limits that depend on the server
    first.fault(request -> request.name().equals("@PROXY_TYPE"), Fault.hold(answer));
    try (CommandWriter own = writer(text, lease)) {
      CompletableFuture<Map<SinkRecord, Optional<Exception>>> outcomes =
          CompletableFuture.supplyAsync(() -> own.write(List.of(command)));
      assertThat(first.takeRequest(Duration.ofSeconds(30)).orElseThrow().name())
          .isEqualTo("@PROXY_TYPE");
      Files.writeString(file(), text.replace("write = true", "write = false"));
      answer.countDown();
      assertThat(outcomes.get()).isEmpty();
      assertThat(written(first)).isEmpty();
      Files.writeString(file(), text);
      assertThat(own.write(List.of(command))).containsEntry(command, Optional.empty());
    }
  }

  @Test
  void aRecordWhoseTimeIsFarAwayIsNotWritten() {
    Duration far = MAX_AGE.plusMinutes(1);
    assertThat(failure(record("r1", 40, far))).contains("older than 60000 ms");
    assertThat(failure(record("r1", 40, far.negated()))).contains("ms ahead (max.age.ms)");
    assertThat(written(first)).isEmpty();
  }
}
