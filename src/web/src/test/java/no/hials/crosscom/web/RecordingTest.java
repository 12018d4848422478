package no.hials.crosscom.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.StringJoiner;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.cell.recording.RecordedData;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class RecordingTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final int ROWS = 5;
  private static final String FIRST = "2026-05-04T10:15:30.000000Z";

  @TempDir private Path folder;

  private TestPages pages(ServerType type) throws IOException {
    return TestPages.start(type, folder, cfg -> {});
  }

  private static JsonNode start(TestSocket socket, String name, String format, String names)
      throws InterruptedException {
    return socket.call(
        "record-start",
        "robot",
        "'mock'",
        "name",
        "'" + name + "'",
        "names",
        names,
        "period",
        "20",
        "format",
        "'" + format + "'");
  }

  /** Stops a recording that has some rows; returns its state. */
  private static JsonNode stop(TestSocket socket, String file) throws InterruptedException {
    socket.await(
        it ->
            it.path("event").asText().equals("recording")
                && it.path("file").asText().equals(file)
                && it.path("rows").asInt() >= ROWS);
    return socket.call("record-stop", "file", "'" + file + "'").path("ok");
  }

  private static List<String> files(TestSocket socket) throws InterruptedException {
    List<String> names = new ArrayList<>();
    socket
        .call("recordings")
        .path("ok")
        .path("recordings")
        .forEach(it -> names.add(it.path("file").asText()));
    return names;
  }

  /** The numbers for the replay: the description, and the rows of each column. */
  private record Columns(JsonNode head, List<double[]> rows) {
    double[] of(String name) {
      for (int i = 0; i < head.path("columns").size(); i++) {
        if (head.path("columns").get(i).path("name").asText().equals(name)) {
          return rows.get(i + 1);
        }
      }
      throw new AssertionError(name + " is not in " + head);
    }
  }

  private static Columns columns(TestPages pages, String file) throws Exception {
    HttpResponse<byte[]> answer =
        HttpClient.newHttpClient()
            .send(
                HttpRequest.newBuilder(pages.at("/recordings/" + file + "/columns"))
                    .header("Cookie", pages.login(Role.VIEW))
                    .build(),
                HttpResponse.BodyHandlers.ofByteArray());
    assertThat(answer.statusCode())
        .as(new String(answer.body(), StandardCharsets.UTF_8))
        .isEqualTo(200);
    ByteBuffer bytes = ByteBuffer.wrap(answer.body()).order(ByteOrder.LITTLE_ENDIAN);
    byte[] text = new byte[bytes.getInt()];
    bytes.get(text);
    assertThat(bytes.position() % Double.BYTES).isZero();
    JsonNode head = MAPPER.readTree(text);
    List<double[]> rows = new ArrayList<>();
    for (int column = 0; column <= head.path("columns").size(); column++) {
      double[] values = new double[head.path("rows").asInt()];
      bytes.asDoubleBuffer().get(values);
      bytes.position(bytes.position() + values.length * Double.BYTES);
      rows.add(values);
    }
    assertThat(bytes.hasRemaining()).isFalse();
    return new Columns(head, rows);
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void aRecordingInCsvIsAFileThatTheCommandLineReads(ServerType type) throws Exception {
    try (TestPages pages = pages(type);
        TestSocket socket = pages.open(Role.OPERATE)) {
      JsonNode started = start(socket, "run-1", "csv", "['$pos_act', '$OV_PRO', '$MODE_OP']");
      assertThat(started.path("ok").path("file").asText()).isEqualTo("run-1.csv");
      JsonNode end = stop(socket, "run-1.csv");

      assertThat(end.path("running").asBoolean()).isFalse();
      assertThat(end.path("reason").asText()).isEmpty();
      RecordedData data = RecordedData.read(folder.resolve("recordings/run-1.csv"));
      RecordedData.RecordedColumn override = data.find("$OV_PRO").orElseThrow();
      assertThat(override.size()).isEqualTo(end.path("rows").asInt());
      assertThat(override.values()).containsOnly(100);
      assertThat(data.find("$POS_ACT.X").orElseThrow().values()).containsOnly(525);
      assertThat(data.find("$MODE_OP").orElseThrow().texts()).containsOnly("#T1");
      assertThat(override.seconds()).isSorted();
    }
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void aRecordingInJsonLinesHasALineForEachReading(ServerType type) throws Exception {
    try (TestPages pages = pages(type);
        TestSocket socket = pages.open(Role.OPERATE)) {
      start(socket, "run", "jsonl", "['$AXIS_ACT', '$OV_PRO']");
      JsonNode end = stop(socket, "run.jsonl");

      List<String> lines = Files.readAllLines(folder.resolve("recordings/run.jsonl"));
      assertThat(lines).hasSize(end.path("rows").asInt());
      for (String line : lines) {
        JsonNode values = MAPPER.readTree(line).path("values");
        assertThat(values.path("$AXIS_ACT").path("A2").asDouble()).isEqualTo(-90);
        assertThat(values.path("$OV_PRO").asInt()).isEqualTo(100);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"csv", "jsonl"})
  void aRecordingIsReplayedByItsNumbers(String format) throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      start(socket, "run", format, "['$AXIS_ACT', '$STOPMESS', '$MODE_OP', '$TORQUE_AXIS_ACT[]']");
      JsonNode end = stop(socket, "run." + format);

      Columns columns = columns(pages, "run." + format);

      assertThat(columns.head.path("rows").asInt()).isEqualTo(end.path("rows").asInt());
      assertThat(columns.head.path("texts").get(0).asText()).isEqualTo("$MODE_OP");
      assertThat(columns.rows.get(0)).isSorted().startsWith(0);
      assertThat(columns.of("$AXIS_ACT.A2")).containsOnly(-90);
      assertThat(columns.of("$STOPMESS")).containsOnly(0);
      assertThat(columns.of("$TORQUE_AXIS_ACT[2]")).doesNotContain(Double.NaN);
      assertThat(columns.head.path("columns").get(0).path("unit").asText()).isEqualTo("°");
    }
  }

  @Test
  void aLostConnectionIsAGapInTheNumbers() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      Files.writeString(
          files.resolve("a.csv"),
          String.join(
              "\r\n",
              "time,seconds,$OV_PRO,access_ms,status",
              FIRST + ",0.000000,10,1.0,",
              FIRST + ",0.100000,,,gap 3; lost",
              FIRST + ",0.500000,20,1.0,\r\n"));
      String line = "{'time':'%s','seconds':%s,'failed':%s,'values':{'$OV_PRO':%s}}\n";
      Files.writeString(
          files.resolve("b.jsonl"),
          (line.formatted(FIRST, 0, 0, 10) + line.formatted(FIRST, 0.5, 3, 20) + "{'time'")
              .replace('\'', '"'));

      assertThat(columns(pages, "a.csv").of("$OV_PRO")).containsExactly(10, Double.NaN, 20);
      assertThat(columns(pages, "b.jsonl").of("$OV_PRO")).containsExactly(10, Double.NaN, 20);
      assertThat(columns(pages, "b.jsonl").rows.get(0)).containsExactly(0, 0, 0.5);
    }
  }

  @Test
  void aFileThatIsNoRecordingIsRefusedWithItsReason() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      Files.writeString(files.resolve("a.csv"), "a,b\n1,2\n");
      Files.writeString(files.resolve("b.jsonl"), "[]\n{}\n");
      Files.write(files.resolve("c.jsonl"), new byte[] {(byte) 0xFF, 1});
      String cookie = pages.login(Role.VIEW);

      for (String file : List.of("a.csv", "b.jsonl", "c.jsonl")) {
        HttpResponse<String> answer =
            pages.get(pages.at("/recordings/" + file + "/columns"), "Cookie", cookie);
        assertThat(answer.statusCode()).isEqualTo(422);
        assertThat(answer.body())
            .containsAnyOf(
                "is not a recording",
                "is not of a recording",
                "cannot read c.jsonl: it is not in UTF-8");
        assertThat(answer.body()).doesNotContain(folder.toString());
      }
    }
  }

  @Test
  void aRecordingThatWouldFillTheMemoryIsOnlyDownloaded() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      Files.write(files.resolve("a.csv"), new byte[16 * 1024 * 1024 + 1]);

      HttpResponse<String> answer =
          pages.get(pages.at("/recordings/a.csv/columns"), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.statusCode()).isEqualTo(413);
      assertThat(answer.body()).contains("has 16777217. Download it instead.");
    }
  }

  @Test
  void aSmallRecordingWhoseNumbersWouldFillTheMemoryIsOnlyDownloaded() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      List<String> lines = new ArrayList<>();
      for (int i = 0; i < 3000; i++) {
        lines.add(
            "{\"time\":\"2026-11-23T12:00:00Z\",\"seconds\":%d,\"values\":{\"N%d\":1}}"
                .formatted(i, i));
      }
      Files.write(files.resolve("a.jsonl"), lines);

      HttpResponse<String> answer =
          pages.get(pages.at("/recordings/a.jsonl/columns"), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.statusCode()).isEqualTo(422);
      assertThat(answer.body())
          .isEqualTo(
              "a recording that is opened may have at most 4194304 numbers, this one has more;"
                  + " download it instead\n");
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "a.jsonl | {\"time\": | line 1 of a.jsonl is not JSON",
        "a.jsonl | {\"time\":\"-1000000000-01-01T00:00:00Z\",\"seconds\":0,\"values\":{\"R\":1}} |"
            + " begins at -1000000000-01-01T00:00:00Z",
        "a.jsonl | {\"time\":\"-1000000000-01-01T00:00:00Z\",\"seconds\":1,\"values\":{\"R\":1}} |"
            + " line 1 has no time",
        "a.jsonl | {\"time\":\"+10000-01-01T00:00:00Z\",\"seconds\":0,\"values\":{\"R\":1}} |"
            + " begins at +10000-01-01T00:00:00Z"
      })
  void aLineOfJsonThatCannotBeReplayedIsRefusedWithItsReason(
      String file, String line, String reason) throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      Files.writeString(files.resolve(file), line);

      HttpResponse<String> answer =
          pages.get(pages.at("/recordings/" + file + "/columns"), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.statusCode()).isEqualTo(422);
      assertThat(answer.body()).contains(reason);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.csv", "a.jsonl"})
  void aRecordingWithTooManyColumnsIsOnlyDownloaded(String file) throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      String row = "{\"time\":\"2026-11-23T12:00:00Z\",\"seconds\":0,\"values\":{\"N[]\":[%s0]}}\n";
      String header = "time,seconds,%saccess_ms,status\n2026-11-23T12:00:00Z,0,%s1,ok\n";
      Files.writeString(
          files.resolve(file),
          file.endsWith(".csv")
              ? header.formatted("N,".repeat(10_001), "1,".repeat(10_001))
              : row.formatted("0,".repeat(10_000)));

      HttpResponse<String> answer =
          pages.get(pages.at("/recordings/" + file + "/columns"), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.statusCode()).isEqualTo(422);
      assertThat(answer.body())
          .isEqualTo(
              "a recording that is opened may have at most 10000 columns, this one has more;"
                  + " download it instead\n");
    }
  }

  @ParameterizedTest
  @CsvSource({
    "5.0, 3.2, 'row 2 must have the seconds of a later time, has 3.2 after 5.0'",
    "0.0, Infinity, 'row 2 must have the seconds of a later time, has Infinity after 0.0'"
  })
  void aRecordingWhoseTimesAreNotInOrderIsOnlyDownloaded(String first, String second, String reason)
      throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      String row = FIRST + ",%s,100,1.0,\n";
      Files.writeString(
          files.resolve("a.csv"),
          "time,seconds,$OV_PRO,access_ms,status\n" + row.formatted(first) + row.formatted(second));
      String line = "{\"time\":\"" + FIRST + "\",\"seconds\":%s,\"values\":{\"A\":1}}\n";
      Files.writeString(
          files.resolve("a.jsonl"),
          line.formatted(first) + line.formatted(second.replace("Infinity", "1e999")));

      String cookie = pages.login(Role.VIEW);
      for (String file : List.of("a.csv", "a.jsonl")) {
        HttpResponse<String> answer =
            pages.get(pages.at("/recordings/" + file + "/columns"), "Cookie", cookie);

        assertThat(answer.statusCode()).isEqualTo(422);
        assertThat(answer.body().replace("line 2", "row 2"))
            .isEqualTo(reason + "; download the recording instead\n");
      }
    }
  }

  @Test
  void aLinkIsNoRecording() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      Path secret = Files.writeString(folder.resolve("secret"), "another file");
      Files.createSymbolicLink(files.resolve("a.csv"), secret);
      Files.createSymbolicLink(files.resolve("b.csv"), folder.resolve("missing"));

      HttpResponse<String> answer =
          pages.get(pages.at("/recordings/a.csv"), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.statusCode()).isEqualTo(404);
      assertThat(files(socket)).isEmpty();
      assertThat(start(socket, "b", "csv", "['$OV_PRO']").path("error").asText())
          .isEqualTo("there is already a recording b.csv");
    }
  }

  @Test
  void recordingsWithoutANameThatStartInOneSecondHaveDifferentFiles() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      Set<String> files = new HashSet<>();
      for (int i = 0; i < 3; i++) { // at least two of them in one second
        JsonNode answer =
            socket.call(
                "record-start",
                "robot",
                "'mock'",
                "names",
                "['$OV_PRO']",
                "period",
                "20",
                "format",
                "'csv'");
        files.add(answer.path("ok").path("file").asText());
      }

      assertThat(files)
          .hasSize(3)
          .allMatch(file -> file.matches("mock-\\d{8}-\\d{6}(-[23])?\\.csv"));
    }
  }

  @Test
  void aStopOfARecordingDoesNotWaitForOneThatStarts() throws Exception {
    CountDownLatch released = new CountDownLatch(1);
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE);
        TestSocket other = pages.open(Role.VIEW)) {
      pages.controller().fault(request -> request.names().contains("MYINT"), Fault.hold(released));
      socket.send(
          ("{'id':900,'do':'record-start','robot':'mock','name':'first','names':['MYINT'],"
                  + ("'period':20,'format':'csv','clock':" + socket.clock() + "}"))
              .replace('\'', '"'));
      while (pages.controller().requests().stream().noneMatch(it -> it.names().contains("MYINT"))) {
        other.call("ping");
      }

      socket.send("{'id':901,'do':'record-stop','file':'none.csv'}".replace('\'', '"'));
      assertThat(socket.await(it -> it.path("id").asInt() >= 900).path("id").asInt())
          .isEqualTo(901);
    } finally {
      released.countDown();
    }
  }

  @Test
  void theNumberOfAWrongLineDoesNotCountGaps() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      Path files = Files.createDirectories(folder.resolve("recordings"));
      String row = "{\"time\":\"2026-11-23T12:00:00Z\",\"seconds\":%d,\"failed\":1,\"values\":{}}";
      Files.write(
          files.resolve("a.jsonl"), List.of(row.formatted(1), row.formatted(2), "{}", "{}"));

      HttpResponse<String> answer =
          pages.get(pages.at("/recordings/a.jsonl/columns"), "Cookie", pages.login(Role.VIEW));

      assertThat(answer.body()).isEqualTo("line 3 is not of a recording\n");
    }
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void everyViewerSeesListsAndDownloadsRecordings(ServerType type) throws Exception {
    try (TestPages pages = pages(type);
        TestSocket socket = pages.open(Role.OPERATE);
        TestSocket other = pages.open(Role.VIEW)) {
      start(socket, "run", "csv", "['$OV_PRO']");
      other.awaitEvent("recordings");
      assertThat(other.awaitEvent("recording").path("robot").asText()).isEqualTo("mock");
      assertThat(other.call("recordings").path("ok").path("running").get(0).path("file").asText())
          .isEqualTo("run.csv");
      assertThat(socket.call("recording-delete", "file", "'run.csv'").path("error").asText())
          .isEqualTo("stop run.csv first");
      stop(socket, "run.csv");
      other.await(
          it -> it.path("event").asText().equals("recording") && !it.path("running").asBoolean());

      assertThat(files(other)).containsExactly("run.csv");
      HttpResponse<String> file =
          pages.get(pages.at("/recordings/run.csv"), "Cookie", pages.login(Role.VIEW));
      assertThat(file.body())
          .startsWith("time,seconds,$OV_PRO,access_ms,status\r\n")
          .isEqualTo(Files.readString(folder.resolve("recordings/run.csv")));
      assertThat(file.headers().firstValue("content-disposition"))
          .contains("attachment; filename=\"run.csv\"");

      assertThat(socket.call("recording-delete", "file", "'run.csv'").has("ok")).isTrue();
      assertThat(files(other)).isEmpty();
      assertThat(folder.resolve("recordings/run.csv")).doesNotExist();
    }
  }

  @Test
  void aViewerWhoMayOnlyViewRecordsAndDeletesNothing() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.VIEW)) {
      String refused = "this needs the role OPERATE; this browser may only VIEW";
      assertThat(start(socket, "run", "csv", "['$OV_PRO']").path("error").asText())
          .isEqualTo(refused);
      assertThat(socket.call("record-stop", "file", "'run.csv'").path("error").asText())
          .isEqualTo(refused);
      assertThat(socket.call("recording-delete", "file", "'run.csv'").path("error").asText())
          .isEqualTo(refused);
      assertThat(folder.resolve("recordings")).doesNotExist();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "../x", "a/b", ".hidden", "a.b", "con", "COM1", "a b", "-a", "a\\u0000"})
  void aNameThatIsNoPlainFileIsRefused(String name) throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      assertThat(start(socket, name, "csv", "['$OV_PRO']").path("error").asText())
          .startsWith("the name of a recording must have");
      assertThat(folder.resolve("recordings")).doesNotExist();
    }
  }

  @Test
  void noOtherFileIsReadOrDeleted() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      Files.createDirectories(folder.resolve("recordings"));
      Files.writeString(folder.resolve("secret.csv"), "secret");
      Files.writeString(folder.resolve("recordings/notes.txt"), "secret");
      String cookie = pages.login(Role.JOG);
      for (String name : List.of("../secret.csv", "..%2fsecret.csv", "notes.txt", "", "x.csv")) {
        assertThat(pages.get(pages.at("/recordings/" + name), "Cookie", cookie).body())
            .doesNotContain("secret\n")
            .isNotEqualTo("secret");
        assertThat(socket.call("recording-delete", "file", "'" + name + "'").path("error").asText())
            .isEqualTo("there is no such recording");
      }
      assertThat(folder.resolve("secret.csv")).exists();
      assertThat(files(socket)).isEmpty();
    }
  }

  @ParameterizedTest
  @EnumSource(ServerType.class)
  void aVariableThatCannotBeReadStartsNoRecording(ServerType type) throws Exception {
    try (TestPages pages = pages(type);
        TestSocket socket = pages.open(Role.OPERATE)) {
      JsonNode answer = start(socket, "run", "csv", "['$OV_PRO', 'NO_SUCH_VARIABLE']");

      assertThat(answer.path("error").asText()).contains("NO_SUCH_VARIABLE");
      assertThat(files(socket)).isEmpty();
      assertThat(socket.call("recordings").path("ok").path("running")).isEmpty();
    }
  }

  @Test
  void aFileIsNotOverwrittenAndTooManyRecordingsAreRefused() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      for (int i = 0; i < 4; i++) {
        assertThat(start(socket, "run" + i, "csv", "['$OV_PRO']").has("ok")).isTrue();
      }
      assertThat(start(socket, "run4", "csv", "['$OV_PRO']").path("error").asText())
          .isEqualTo("there are 4 recordings already: stop one first");
      stop(socket, "run0.csv");
      assertThat(start(socket, "run0", "csv", "['$OV_PRO']").path("error").asText())
          .isEqualTo("there is already a recording run0.csv");
      assertThat(start(socket, "run0", "jsonl", "['$OV_PRO']").has("ok")).isTrue();
    }
  }

  @Test
  void wrongSettingsAreRefused() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      assertThat(start(socket, "run", "xls", "['$OV_PRO']").path("error").asText())
          .isEqualTo("format must be csv or jsonl");
      assertThat(start(socket, "run", "csv", "[]").path("error").asText())
          .startsWith("names must have at least one name");
      assertThat(socket.call("record-stop", "file", "'run.csv'").path("error").asText())
          .isEqualTo("there is no such recording that runs");
      JsonNode unnamed =
          socket.call(
              "record-start",
              "robot",
              "'mock'",
              "names",
              "['$OV_PRO']",
              "period",
              "20",
              "format",
              "'csv'");
      assertThat(unnamed.path("ok").path("file").asText()).matches("mock-\\d{8}-\\d{6}\\.csv");
    }
  }

  @Test
  void aRecordingIsCompleteWhenTheServerIsClosed() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.OPERATE)) {
      start(socket, "run", "csv", "['$OV_PRO']");
      socket.await(
          it -> it.path("event").asText().equals("recording") && it.path("rows").asInt() >= ROWS);
    }
    RecordedData data = RecordedData.read(folder.resolve("recordings/run.csv"));
    assertThat(data.find("$OV_PRO").orElseThrow().values()).hasSizeGreaterThanOrEqualTo(ROWS);
  }

  @Test
  void recordingsThatNobodyTakesDoNotFillTheMemory() throws Exception {
    writeLarge("large.jsonl");
    try (TestPages pages = pages(ServerType.C3_BRIDGE)) {
      String cookie = pages.login(Role.VIEW);
      URI address = pages.at("/recordings/large.jsonl/columns");
      List<Socket> slow = new ArrayList<>();
      try {
        for (int i = 0; i < 8; i++) {
          slow.add(ask(address, cookie));
        }
        for (Socket one : slow) {
          assertThat(one.getInputStream().read()).isEqualTo('H'); // and no more
        }

        HttpResponse<String> refused = pages.get(address, "Cookie", cookie);

        assertThat(refused.statusCode()).isEqualTo(503);
        assertThat(refused.body())
            .isEqualTo("8 recordings are being opened already: try again soon.\n");
        assertThat(pages.get(pages.at("/app.js"), "Cookie", cookie).statusCode()).isEqualTo(200);
      } finally {
        for (Socket one : slow) {
          one.close();
        }
      }
    }
  }

  /** Writes a recording whose numbers do not fit into the buffers of a connection: 6 MB. */
  private void writeLarge(String file) throws IOException {
    StringJoiner values = new StringJoiner(",", "{", "}");
    for (int i = 1; i <= 100; i++) {
      values.add("\"V" + i + "\":0");
    }
    StringBuilder text = new StringBuilder();
    for (int row = 0; row < 8000; row++) {
      text.append("{\"time\":\"2026-01-01T00:00:00Z\",\"seconds\":")
          .append(row)
          .append(",\"values\":")
          .append(row == 0 ? values : "{}")
          .append("}\n");
    }
    Path recordings = Files.createDirectories(folder.resolve("recordings"));
    Files.writeString(recordings.resolve(file), text);
  }

  /** Asks for a file and does not read the answer. */
  private static Socket ask(URI address, String cookie) throws IOException {
    Socket socket = new Socket();
    socket.setReceiveBufferSize(4096);
    socket.connect(new InetSocketAddress(address.getHost(), address.getPort()));
    String request =
        "GET "
            + address.getPath()
            + " HTTP/1.1\r\nHost: "
            + address.getAuthority()
            + "\r\nCookie: "
            + cookie
            + "\r\n\r\n";
    socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    return socket;
  }

  @Test
  void unitsAreThoseOfTheCatalogue() throws Exception {
    try (TestPages pages = pages(ServerType.C3_BRIDGE);
        TestSocket socket = pages.open(Role.VIEW)) {
      JsonNode units =
          socket
              .call("units", "names", "['$POS_ACT.X', '$AXIS_ACT.A1', '$OV_PRO', 'MYREAL']")
              .path("ok")
              .path("units");
      assertThat(units.path("$POS_ACT.X").asText()).isEqualTo("mm");
      assertThat(units.path("$AXIS_ACT.A1").asText()).isEqualTo("°");
      assertThat(units.path("$OV_PRO").asText()).isEqualTo("%");
      assertThat(units.path("MYREAL").asText()).isEmpty();
    }
  }
}
