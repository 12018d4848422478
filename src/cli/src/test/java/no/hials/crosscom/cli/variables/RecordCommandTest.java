package no.hials.crosscom.cli.variables;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedDeque;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import no.hials.crosscom.cell.recording.RecordedData;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Tail;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RecordCommandTest {
  @TempDir private Path dir;
  @KukaController private MockServer server;
  private Path file;

  @BeforeEach
  void start() {
    file = dir.resolve("run.csv");
  }

  /** Records into the file at 5 ms. */
  private Cli.Result record(String... args) {
    String[] all =
        Stream.concat(Stream.of("--out", file.toString(), "--period", "5ms"), Stream.of(args))
            .toArray(String[]::new);
    return Cli.runOn(server, "record", all);
  }

  private static Fault value(String text) {
    return Fault.answer(text, Tail.SUCCESS);
  }

  /** Answers the next readings of a variable with these texts; later readings are not changed. */
  private void answer(String name, String... texts) {
    Deque<String> left = new ConcurrentLinkedDeque<>(List.of(texts));
    server.faults(
        request -> {
          String text = name.equals(request.name()) ? left.poll() : null;
          return text == null ? Optional.empty() : Optional.of(value(text));
        });
  }

  /** Returns the rows, split into fields. */
  private List<List<String>> rows() throws IOException {
    return Files.readString(file)
        .lines()
        .skip(1)
        .map(line -> List.of(line.split(",", -1)))
        .toList();
  }

  @Test
  void writesARowForEachSampleAndAColumnForEachNumber() throws IOException {
    Cli.Result result =
        record("--count", "3", "$OV_PRO", "MYFRAME", "MYBOOLS[]", "$MODE_OP", "$MODEL_NAME[]");

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.out()).isEmpty();
    assertThat(result.errLines())
        .singleElement()
        .asString()
        .startsWith("recorded to " + file + ": 3 samples, ");
    String text = Files.readString(file);
    assertThat(text).endsWith("\r\n");
    assertThat(text.lines().findFirst())
        .contains(
            "time,seconds,$OV_PRO,MYFRAME.X,MYFRAME.Y,MYFRAME.Z,MYFRAME.A,MYFRAME.B,MYFRAME.C,"
                + "MYBOOLS[1],MYBOOLS[2],MYBOOLS[3],MYBOOLS[4],MYBOOLS[5],MYBOOLS[6],MYBOOLS[7],"
                + "MYBOOLS[8],MYBOOLS[9],MYBOOLS[10],$MODE_OP,$MODEL_NAME[],access_ms,status");
    assertThat(rows())
        .hasSize(3)
        .allSatisfy(
            row -> {
              assertThat(row).hasSize(23);
              assertThat(row.get(0))
                  .matches("20\\d\\d-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\\.\\d{6}Z");
              assertThat(row.get(1)).matches("\\d\\.\\d{6}");
              assertThat(row.subList(2, 5)).containsExactly("100", "0.0", "0.0");
              assertThat(row.subList(18, 21))
                  .containsExactly("FALSE", "#T1", "#KR6R900 C4SR FLR 230");
              assertThat(row.get(21)).matches("\\d+\\.\\d{3}");
            });
    assertThat(rows().get(0).get(1)).isEqualTo("0.000000");
  }

  @Test
  void isReadByRecordedData() throws IOException {
    server.enqueue(value("1"), value("1"), value("-2.5"), value("3"));

    record("--count", "3", "MYREAL");

    RecordedData data = RecordedData.read(file);
    assertThat(data.series())
        .singleElement()
        .extracting(RecordedData.RecordedColumn::values)
        .isEqualTo(new double[] {1, -2.5, 3});
    assertThat(data.accessTimes().get(0).values()).hasSize(3).doesNotContain(Double.NaN);
  }

  @Test
  void quotesTextsAsRfc4180Says() throws IOException {
    server.variables().set("MYSTRING[]", "\"a,b\u00FC\"");

    record("--count", "1", "MYSTRING[]");

    assertThat(Files.readString(file, StandardCharsets.UTF_8)).contains(",\"a,b\u00FC\",");
  }

  @ParameterizedTest
  @ValueSource(strings = {"=cmd|'/c calc'!A0", "@SUM(A1)", "+1+1", " -2+3", "\t=1", "'=1", "-"})
  void guardsATextThatASpreadsheetWouldTakeForAFormula(String text) throws IOException {
    String name = "MYSTRING[]";
    server.fault(
        request -> name.equals(request.name()), Fault.answer('"' + text + '"', Tail.SUCCESS));
    Path raw = dir.resolve("raw.csv");

    record("--count", "1", name);
    Cli.runOn(server, "record", name, "--count", "1", "--raw", "--out", raw.toString());

    String escaped = text.replace("\t", "\\x09");
    assertThat(Files.readString(file)).contains(",'" + escaped + ",");
    assertThat(RecordedData.read(file).series().get(0).texts()).containsExactly(escaped);
    assertThat(Files.readString(raw)).contains("," + text + ",");
  }

  @Test
  void guardsAFormulaAfterASemicolonWhichSomeSpreadsheetsTakeForASeparator() throws IOException {
    String name = "MYSTRING[]";
    String formula = "x;=cmd|'/c calc'!A0";
    server.fault(
        request -> name.equals(request.name()), Fault.answer('"' + formula + '"', Tail.SUCCESS));

    record("--count", "1", name);

    assertThat(Files.readString(file)).contains(",x;'=cmd|'/c calc'!A0,");
    assertThat(RecordedData.read(file).series().get(0).texts()).containsExactly(formula);
  }

  @Test
  void writesNumbersWithoutAGuard() throws IOException {
    server.enqueue(value("-3.5"), value("-3.5"), value("1E5"), value("-1E-07"));

    record("--count", "3", "MYREAL");

    assertThat(rows())
        .extracting(row -> row.get(2))
        .containsExactly("-3.50000", "100000.0", "-1.00000E-07");
  }

  @Test
  void escapesControlCharacters() throws IOException {
    String name = "MYSTRING[]";
    server.fault(
        request -> name.equals(request.name()), Fault.answer("\"a\0\u001B[2J\"", Tail.SUCCESS));

    record("--count", "1", name);

    assertThat(Files.readString(file)).contains(",a\\x00\\x1B[2J,");
  }

  @Test
  void refusesAFileThatAnotherCommandRecordsTo() throws Exception {
    CountDownLatch thirdRequest = new CountDownLatch(1);
    server.fault(request -> request.number() == 3, Fault.hold(thirdRequest));
    CompletableFuture<Cli.Result> first =
        CompletableFuture.supplyAsync(() -> record("--count", "2", "MYINT"));
    while (server.requestCount() < 3) {
      Thread.onSpinWait();
    }

    record("--count", "1", "--yes", "MYREAL")
        .failsInLines(74)
        .containsExactly(
            "jopenshowvar: could not write " + file + ": another command is recording to it");

    thirdRequest.countDown();
    assertThat(first.join().code()).isZero();
    assertThat(rows()).hasSize(2);
    assertThat(record("--count", "1", "--yes", "MYREAL").code()).isZero();
  }

  @Test
  void writesTheRowsOfALostRobotInTheOrderOfTheirTimes() throws IOException {
    try (MockServer other = MockServer.start()) {
      other.faults(
          request ->
              request.number() > 2 && server.requestCount() < 20
                  ? Optional.of(Fault.closeBefore())
                  : Optional.empty());

      Cli.Result result = recordTwo(other, "--period", "20ms", "--count", "60");

      assertThat(result.code()).as(result.err()).isZero();
    }
    assertThat(rows()).extracting(row -> row.get(0)).isSorted();
    assertThat(rows()).extracting(row -> Double.valueOf(row.get(1))).isSorted();
    assertThat(rows())
        .filteredOn(row -> row.get(6).startsWith("gap "))
        .isNotEmpty()
        .allMatch(row -> row.get(2).equals("cell2"))
        .anyMatch(row -> row.get(6).matches("gap \\d+ since 20.*Z; .*MYINT.*"));
  }

  @Test
  void keepsTheColumnsOfTheFirstReading() throws IOException {
    server.enqueue(value("{X 1.0}"), value("{X 1.0}"), value("{X 2.0, Y 3.0}"), value("{Y 3.0}"));

    record("--count", "3", "MYPOS");

    assertThat(Files.readString(file)).startsWith("time,seconds,MYPOS.X,access_ms,status\r\n");
    assertThat(rows()).extracting(row -> row.get(2)).containsExactly("1.00000", "2.00000", "");
    assertThat(rows().get(1).get(4)).contains("no column for MYPOS.Y");
  }

  @Test
  void leavesTheCellsOfAVariableEmptyThatCannotBeReadAndSaysWhy() throws IOException {
    answer("MYINT", "0", "0", "");

    Cli.Result result = record("--count", "3", "MYINT", "MYREAL");

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(rows()).extracting(row -> row.get(2)).containsExactly("0", "", "0");
    assertThat(rows()).extracting(row -> row.get(3)).containsExactly("0.0", "0.0", "0.0");
    assertThat(rows().get(1).get(5)).contains("the controller refused to read MYINT");
  }

  @Test
  void goesOnAfterALossOfTheConnectionAndMarksTheGap() throws IOException {
    server.enqueue(value("1"), value("1"), Fault.closeBefore(), Fault.closeBefore(), value("2"));

    Cli.Result result = record("--count", "2", "MYINT");

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.errLines()).contains("jopenshowvar: connected again");
    assertThat(rows()).extracting(row -> row.get(2)).containsExactly("1", "", "2");
    assertThat(rows().get(1).get(3)).isEmpty();
    assertThat(rows().get(1).get(4)).matches("gap \\d+; .*MYINT.*");
    assertThat(rows()).extracting(row -> row.get(0)).isSorted();
  }

  @Test
  void marksAGapAtTheEndAndSaysByItsCodeThatTheConnectionIsLost() throws IOException {
    server.enqueue(value("1"), value("1"));
    server.fault(request -> request.number() > 2, Fault.closeBefore());

    Cli.Result result = record("--for", "150ms", "MYINT");

    assertThat(result.code()).as(result.err()).isEqualTo(4);
    assertThat(rows()).hasSize(2);
    assertThat(rows().get(1).get(4)).startsWith("gap ");
  }

  @Test
  void takesSamplesUntilTheTimeIsOver() throws IOException {
    assertThat(record("--for", "50ms", "MYINT").code()).isZero();

    assertThat(rows()).isNotEmpty().hasSizeLessThanOrEqualTo(10);
    assertThat(rows())
        .allSatisfy(row -> assertThat(Double.parseDouble(row.get(1))).isLessThan(0.05));
  }

  @Test
  void countsThePeriodsThatAReadingMissed() throws IOException {
    server.enqueue(Fault.none(), Fault.delay(Duration.ofMillis(40)), Fault.none());

    Cli.Result result = record("--count", "2", "MYINT");

    assertThat(rows().get(1).get(4)).matches("missed \\d+");
    assertThat(result.err()).containsPattern("missed [1-9]");
  }

  @Test
  void makesNoFileIfAVariableCannotBeReadAtTheStart() {
    Cli.Result result = record("MYINT", "NOPE", "NEITHER");

    result.failsInLines(1).hasSize(2);
    assertThat(result.errLines().get(0))
        .startsWith("jopenshowvar: the controller refused to read NOPE");
    assertThat(file).doesNotExist();
  }

  @Test
  void makesNoFileIfItCannotConnect() {
    server.refuseConnections();

    assertThat(record("MYINT").code()).isEqualTo(3);
    assertThat(file).doesNotExist();
  }

  @Test
  void doesNotOverwriteAFileUnlessToldTo() throws IOException {
    Files.writeString(file, "precious");

    record("--count", "1", "MYINT")
        .failsInLines(2)
        .containsExactly("jopenshowvar: " + file + " already exists; --yes overwrites it");
    assertThat(file).hasContent("precious");
    assertThat(server.requestCount()).isZero();

    assertThat(record("--count", "1", "--yes", "MYINT").code()).isZero();
    assertThat(rows()).hasSize(1);
  }

  @Test
  void saysThatThereIsNoSuchFolder() {
    file = dir.resolve("none").resolve("a.csv");

    record("--count", "1", "MYINT")
        .failsInLines(74)
        .containsExactly(
            "jopenshowvar: could not write "
                + file
                + ": there is no folder "
                + dir.resolve("none"));
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void endsWithCode74IfTheDiskIsFull() {
    file = Path.of("/dev/full");
    assumeThat(file).exists();

    record("MYINT")
        .failsInLines(74)
        .containsExactly("jopenshowvar: could not write /dev/full: No space left on device");
  }

  @Test
  void writesToStdout() {
    Cli.Result result = Cli.runOn(server, "record", "MYINT", "--count", "2", "--out", "-");

    assertThat(result.lines()).hasSize(3).first().isEqualTo("time,seconds,MYINT,access_ms,status");
    assertThat(result.err()).startsWith("recorded: 2 samples, ");
    assertThat(result.code()).isZero();
  }

  @Test
  void writesJsonLinesIntoAJsonlFile() throws IOException {
    file = dir.resolve("run.jsonl");
    server.variables().set("MYFRAME", "{X 1.5}");
    answer("MYINT", "0", "");

    assertThat(record("--count", "1", "MYINT", "MYFRAME").code()).isZero();
    assertThat(Files.readString(file).lines())
        .singleElement()
        .asString()
        .matches(
            "\\{\"time\":\"\\S+Z\",\"seconds\":0.000000,\"access_ms\":\\d+\\.\\d{3},\"missed\":0,"
                + "\"failed\":0,\"values\":\\{\"MYFRAME\":\\{\"X\":1.5,\"Y\":0.0,.*}},"
                + "\"errors\":\\{\"MYINT\":\"the controller refused.*\"},"
                + "\"changed\":\\[\"MYINT\",\"MYFRAME\"]}");
  }

  @Test
  void writesTheFormatThatIsAskedFor() throws IOException {
    record("--count", "1", "--format", "JSONL", "MYINT");

    assertThat(Files.readString(file)).startsWith("{\"time\":");
  }

  private Cli.Result recordTwo(MockServer other) throws IOException {
    return recordTwo(other, "--count", "2");
  }

  private Cli.Result recordTwo(MockServer other, String... options) throws IOException {
    Path profiles = dir.resolve("config.toml");
    List<String> lines = new ArrayList<>();
    for (MockServer one : List.of(server, other)) {
      lines.add("[robots.cell" + (lines.size() / 3 + 1) + "]");
      lines.add("host = \"" + one.host() + "\"");
      lines.add("port = " + one.port());
    }
    Files.write(profiles, lines);
    String[] args = {"record", "@cell1", "@cell2", "MYINT", "--out", file.toString()};
    return Cli.runIn(
        Map.of("JOPENSHOWVAR_CONFIG", profiles.toString()),
        Stream.concat(Stream.of(args), Stream.of(options)).toArray(String[]::new));
  }

  @Test
  void saysWhichOfSeveralRobotsCannotBeReached() throws IOException {
    try (MockServer other = MockServer.start()) {
      other.refuseConnections();

      recordTwo(other).failsInALine(3).startsWith("jopenshowvar: cell2: ");
      assertThat(file).doesNotExist();
    }
  }

  @Test
  void recordsSeveralRobotsInRowsOfTheirOwn() throws IOException {
    try (MockServer other = MockServer.start()) {
      other.variables().set("MYINT", "7");

      Cli.Result result = recordTwo(other);

      assertThat(result.code()).as(result.err()).isZero();
    }
    assertThat(Files.readString(file))
        .startsWith("time,seconds,robot,cell1:MYINT,cell2:MYINT,access_ms,status\r\n");
    assertThat(rows())
        .extracting(row -> String.join(" ", row.subList(2, 5)))
        .containsExactlyInAnyOrder("cell1 0 ", "cell1 0 ", "cell2  7", "cell2  7");
    assertThat(RecordedData.read(file).find("cell2:MYINT").orElseThrow().values())
        .containsExactly(7, 7);
  }

  @Test
  void writesTheRowsOfSeveralRobotsInTheOrderOfTheirTimes() throws IOException {
    CountDownLatch secondSample = new CountDownLatch(1);
    server.fault(request -> request.number() == 2, Fault.hold(secondSample));
    try (MockServer other = MockServer.start()) {
      other.faults(
          request -> {
            if (request.number() == 3) {
              secondSample.countDown();
            }
            return Optional.empty();
          });

      Cli.Result result = recordTwo(other);

      assertThat(result.code()).as(result.err()).isZero();
    }
    assertThat(rows()).hasSize(4).extracting(row -> row.get(0)).isSorted();
    assertThat(rows().get(0).get(1)).isEqualTo("0.000000");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "MYINT --mock                             | missing required option: '--out=FILE'",
        "--out a.csv --mock                       | missing required parameter: 'NAME'",
        "MYINT --out - --mock --format xml        | --format must be csv or jsonl, is xml",
        "MYINT --out a.jsonl --mock --raw         | --raw goes with csv",
        "MYINT --out - --mock --count 0           | --count must be 1 or more, is 0",
        "MYINT --out - --mock --period 25m --for 0| must be 1ms or more",
        "MYINT --out - --mock --period 1441m      | --period must be at most a day, is 24 h"
      })
  void saysWhatIsWrongInTheUsage(String arguments, String message) {
    Cli.run(("record " + arguments).split(" +"))
        .fails(2)
        .contains(message)
        .endsWith("try 'jopenshowvar record --help'\n");
  }
}
