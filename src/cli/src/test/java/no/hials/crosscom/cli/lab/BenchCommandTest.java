package no.hials.crosscom.cli.lab;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.cli.Main;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.lab.plot.Pictures;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.code.OperatingMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class BenchCommandTest {
  @TempDir private Path folder;
  @KukaController private MockServer server;

  private Cli.Result bench(String... args) {
    return Cli.runOn(server, "bench", args);
  }

  private long reads(String variable) {
    return server.requests().stream()
        .filter(request -> !request.isWrite() && request.name().equals(variable))
        .count();
  }

  private List<String> writes() {
    return server.requests().stream()
        .filter(RecordedRequest::isWrite)
        .map(request -> request.name() + " = " + request.value())
        .toList();
  }

  @Test
  void readsAsOftenAsAskedToAndBeforeOnceToTryAndToWarmUp() {
    bench("--count", "20", "--warm-up", "5", "$OV_PRO", "$AXIS_ACT").succeeds();
    assertThat(reads("$OV_PRO")).isEqualTo(1 + 5 + 20);
    assertThat(reads("$AXIS_ACT")).isEqualTo(1 + 5 + 20);
    assertThat(writes()).isEmpty();
  }

  @Test
  void printsALineForEachAccessWithTypeLengthAndCount() {
    List<String> lines = bench("--count", "20", "$OV_PRO", "$AXIS_ACT").lines();

    assertThat(lines.get(0).split(" {2,}", -1))
        .containsExactly(
            "ACCESS", "TYPE", "BYTES", "COUNT", "FAILED", "MIN", "50 %", "90 %", "99 %", "99.9 %",
            "MAX", "MEAN");
    assertThat(lines.get(1)).matches("read \\$OV_PRO +INT +3 +20 +0( +\\d+\\.\\d{3}){7}");
    assertThat(lines.get(2)).matches("read \\$AXIS_ACT +E6AXIS +\\d+ +20 +0( +\\d+\\.\\d{3}){7}");
    assertThat(lines.get(4))
        .matches(
            "times in ms; 1 client, closed loop; 40 accesses in [\\d.]+ s, \\d+/s; 100 rounds"
                + " before to warm up");
  }

  @Test
  void letsEachClientDoAllOfIt() {
    Cli.Result result = bench("--clients", "3", "--count", "10", "--warm-up", "0", "$OV_PRO");

    assertThat(result.lines().get(1)).contains(" 30 ");
    assertThat(result.lines().get(3)).contains("; 3 clients, closed loop; 30 accesses in ");
    assertThat(reads("$OV_PRO")).isEqualTo(1 + 3 * 10);
  }

  @Test
  void measuresAVariableOfEachTypeIfNothingIsNamed() {
    Cli.Result result = bench("--count", "2");

    assertThat(result.err()).isEmpty();
    assertThat(result.lines().subList(1, 9))
        .extracting(line -> line.split(" +", -1)[2])
        .containsExactly("INT", "REAL", "BOOL", "ENUM", "CHAR[]", "E6AXIS", "E6POS", "REAL[12]");
    assertThat(writes()).isEmpty();
  }

  @Test
  void writesBackWhatWasReadJustBefore() {
    server.variables().set("MYINT", "7");
    AtomicInteger count = new AtomicInteger();
    // as a program of the controller would
    server.fault(
        request -> {
          if (request.name().equals("MYINT") && count.incrementAndGet() == 4) {
            server.variables().set("MYINT", "8");
          }
          return false;
        },
        Fault.none());

    Cli.Result result = bench("--count", "3", "--warm-up", "0", "--write", "MYINT");

    assertThat(result.lines().get(1)).startsWith("read MYINT ");
    assertThat(result.lines().get(2)).matches("write MYINT +INT +1 +3 +0 .*");
    List<RecordedRequest> own =
        server.requests().stream().filter(request -> request.name().equals("MYINT")).toList();
    assertThat(own)
        .extracting(RecordedRequest::isWrite)
        .containsExactly(false, false, true, false, true, false, true);
    assertThat(writes()).last().isEqualTo("MYINT = 8");
    assertThat(server.variables().get("MYINT")).isEqualTo("8");
  }

  @Test
  void writesNothingOutsideT1WithoutYes() {
    server.controller().setMode(OperatingMode.AUT);

    Cli.Result refused = bench("--count", "2", "--write", "MYINT");

    refused.failsInLines(5).hasSize(1);
    assertThat(refused.errLines().get(0))
        .startsWith("jopenshowvar: did not write MYINT: $MODE_OP is #AUT")
        .contains("--yes");
    assertThat(writes()).isEmpty();
    assertThat(bench("--count", "2", "--warm-up", "1", "--write", "MYINT", "--yes").code())
        .isZero();
    assertThat(writes()).hasSize(3);
  }

  @Test
  void sendsNothingIfItIsForReadingOnlyAndSomethingIsToBeWritten() {
    Cli.Result result = bench("--write", "MYINT", "--read-only");

    assertThat(result.code()).isEqualTo(5);
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void countsFailuresByKindAndLeavesThemOutOfTheTimes() throws IOException {
    Path csv = folder.resolve("a.csv");
    AtomicInteger count = new AtomicInteger();
    server.fault(
        request -> request.name().equals("MYINT") && count.incrementAndGet() % 4 == 0,
        Fault.answer("", Tail.FAILURE));

    Cli.Result result =
        bench("--count", "20", "--warm-up", "0", "MYINT", "MYREAL", "--out", csv.toString());

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.errLines()).containsExactly("jopenshowvar: read MYINT failed: refused 5");
    assertThat(result.lines().get(1)).matches("read MYINT +INT +1 +15 +5 .*");
    assertThat(result.lines().get(2)).matches("read MYREAL +REAL +\\d+ +20 +0 .*");
    assertThat(Files.readAllLines(csv).stream().filter(line -> line.endsWith(",MYINT,,refused")))
        .hasSize(5);
  }

  @Test
  void goesOnWithANewConnectionAfterOneIsLost() {
    AtomicInteger count = new AtomicInteger();
    server.fault(
        request -> request.name().equals("MYINT") && count.incrementAndGet() == 10,
        Fault.closeBefore());

    Cli.Result result = bench("--count", "20", "--warm-up", "0", "MYINT");

    assertThat(result.code()).isEqualTo(4);
    assertThat(result.errLines())
        .containsExactly("jopenshowvar: read MYINT failed: connection lost 1");
    assertThat(result.lines().get(1)).matches("read MYINT +INT +1 +19 +1 .*");
  }

  @Test
  void givesUpWhereNoNewConnectionCanBeMade() {
    AtomicInteger count = new AtomicInteger();
    server.fault(
        request -> {
          boolean tenth = request.name().equals("MYINT") && count.incrementAndGet() == 10;
          if (tenth) {
            server.refuseConnections();
          }
          return tenth;
        },
        Fault.closeBefore());

    Cli.Result result = bench("--count", "20", "--warm-up", "0", "MYINT");

    assertThat(result.code()).isEqualTo(4);
    assertThat(result.lines().get(1)).matches("read MYINT +INT +1 +8 +1 .*");
    assertThat(result.errLines().get(1)).startsWith("jopenshowvar: client 1 gave up: ");
  }

  @Test
  void leavesOutWhatTheControllerDoesNotHave() {
    Cli.Result result = bench("--count", "2", "NOSUCH", "MYINT");

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.errLines()).hasSize(1);
    assertThat(result.errLines().get(0)).contains("NOSUCH");
    assertThat(result.lines().get(1)).startsWith("read MYINT ");
  }

  @Test
  void measuresNothingIfTheControllerHasNothingOfIt() {
    bench("NOSUCH").fails(1);
  }

  @Test
  void writesALineForEachAccessIntoAFile() throws IOException {
    Path csv = folder.resolve("a.csv");

    bench("--clients", "2", "--count", "10", "$OV_PRO", "MYINT", "--out", csv.toString());

    List<String> lines = Files.readAllLines(csv);
    assertThat(lines.get(0)).isEqualTo("seconds,client,access,name,access_ms,failure");
    assertThat(lines).hasSize(1 + 2 * 10 * 2);
    assertThat(lines.subList(1, lines.size()))
        .allMatch(line -> line.matches("\\d+\\.\\d{6},[12],read,(\\$OV_PRO|MYINT),\\d+\\.\\d{3},"));
  }

  @Test
  void doesNotOverwriteAFileUnlessToldTo() throws IOException {
    Path csv = Files.writeString(folder.resolve("a.csv"), "mine");

    Cli.Result result = bench("MYINT", "--out", csv.toString());

    assertThat(result.code()).isEqualTo(2);
    assertThat(csv).hasContent("mine");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void saysWhenItsFileCannotBeWritten() {
    Cli.Result result = bench("--count", "5000", "MYINT", "--out", "/dev/full");

    assertThat(result.code()).isEqualTo(74);
    assertThat(result.errLines().get(0)).startsWith("jopenshowvar: could not write /dev/full: ");
  }

  @Test
  void printsAJsonObjectForEachAccess() {
    List<String> lines = bench("--count", "5", "--json", "$OV_PRO", "$POS_ACT").lines();

    assertThat(lines).hasSize(2);
    String number = "\\d+\\.\\d{3}";
    assertThat(lines.get(1))
        .matches(
            "\\{\"access\":\"read\",\"name\":\"\\$POS_ACT\",\"type\":\"E6POS\",\"bytes\":\\d+,"
                + "\"clients\":1,\"seconds\":[\\d.E-]+,\"count\":5,\"failed\":\\{},\"min_ms\":"
                + number
                + ",\"p50_ms\":"
                + number
                + ",\"p90_ms\":"
                + number
                + ",\"p99_ms\":"
                + number
                + ",\"p99.9_ms\":"
                + number
                + ",\"max_ms\":"
                + number
                + ",\"mean_ms\":"
                + number
                + "}");
  }

  @Test
  void drawsAHistogramOfEachAccess() throws IOException {
    Path svg = folder.resolve("a.svg");
    Path png = folder.resolve("a.png");

    Cli.Result result = bench("--count", "50", "$OV_PRO", "$AXIS_ACT", "--plot", svg.toString());
    bench("--count", "50", "$OV_PRO", "--plot", png.toString());

    assertThat(result.err()).isEmpty();
    List<String> texts = Pictures.texts(svg).lines().toList();
    assertThat(texts.get(0)).isEqualTo("Access times of 127.0.0.1, 1 client");
    assertThat(texts.get(1))
        .matches(
            "read \\$OV_PRO \\(INT, 3 bytes\\): accesses over access time \\[ms]; 50 accesses.*, 50"
                + " %: [\\d.]+ ms, 99 %: [\\d.]+ ms");
    assertThat(texts.get(2)).startsWith("read $AXIS_ACT (E6AXIS, ");
    assertThat(Pictures.colors(png)).containsKey(0x0072B2);
  }

  @Test
  void refusesAPictureThatIsTooSmallBeforeItMeasures() {
    Path svg = folder.resolve("a.svg");

    Cli.Result result =
        bench("--count", "50", "MYINT", "$OV_PRO", "--plot", svg.toString(), "--size", "900x240");

    assertThat(result.fails(2).actual())
        .contains("a picture of 900x240 is too small for its 2 panels: it must be at least ");
    assertThat(result.out()).isEmpty();
    assertThat(server.requests().stream().filter(it -> it.name().equals("MYINT")))
        .as("the read before the measurement")
        .hasSize(1);
    assertThat(svg).doesNotExist();
  }

  @Test
  void drawsWidePictures() throws IOException {
    Path svg = folder.resolve("a.svg");

    bench("--count", "5", "MYINT", "$OV_PRO", "--plot", svg.toString(), "--size", "3840x400")
        .succeeds();

    assertThat(Pictures.texts(svg).lines()).hasSize(3);
  }

  @Test
  void drawsAlsoIfNobodyReadsWhatItPrints() throws IOException {
    Path svg = folder.resolve("a.svg");

    int code =
        Cli.runUnread(
            Cli.argsOn(server, "bench", "--count", "5", "MYINT", "--plot", svg.toString()));

    assertThat(code).isEqualTo(74);
    assertThat(Pictures.texts(svg)).contains("read MYINT (INT, 1 byte)");
  }

  @Test
  void printsAHistogramWhoseBarsCountAllAccesses() {
    List<String> lines = bench("--count", "40", "--histogram", "MYINT").lines();

    int title = lines.indexOf("read MYINT [ms]");
    assertThat(title).isPositive();
    List<String> bars = lines.subList(title + 1, lines.size());
    assertThat(bars).allMatch(bar -> bar.matches(" +[\\d.]+( - [\\d.]+| and more) +\\d+ #+"));
    assertThat(
            bars.stream().mapToInt(bar -> Integer.parseInt(bar.replaceAll(".* (\\d+) #+", "$1"))))
        .satisfies(counts -> assertThat(counts.stream().mapToInt(i -> i).sum()).isEqualTo(40));
  }

  @Test
  void stopsAtTheEndOfItsTime() {
    Cli.Result result = bench("--for", "50ms", "--warm-up", "0", "MYINT");

    assertThat(result.code()).isZero();
    assertThat(Long.parseLong(result.lines().get(1).split(" +", -1)[4])).isPositive();
  }

  @Test
  void printsWhatThereIsWhenItIsStopped() throws InterruptedException {
    StringWriter out = new StringWriter();
    CompletableFuture<Integer> code = new CompletableFuture<>();
    String[] args = Cli.argsOn(server, "bench", "--for", "10m", "--warm-up", "0", "MYINT");
    Thread thread =
        new Thread(() -> code.complete(Main.run(args, out, new StringWriter())), "bench-command");
    thread.start();
    for (int i = 0; i < 50; i++) {
      assertThat(server.takeRequest(Duration.ofSeconds(10))).isPresent();
    }
    thread.interrupt();

    assertThat(code.join()).isZero();
    assertThat(out.toString()).containsPattern("read MYINT +INT +1 +[1-9]\\d* +0 ");
  }

  @Test
  void showsWhatC3BridgeMeasuresItselfBesideIt() throws IOException {
    try (MockServer c3 = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      List<String> lines =
          Cli.runOn(c3, "bench", "--count", "5", "$OV_PRO", "--write", "MYINT").lines();

      assertThat(lines.get(0)).endsWith("  MEAN  SERVER");
      assertThat(lines.get(1)).matches("read \\$OV_PRO .*  \\d+\\.\\d{3}");
      assertThat(lines.get(2)).matches("read MYINT .*  \\d+\\.\\d{3}");
      assertThat(lines.get(3)).matches("write MYINT .* -");
      assertThat(Cli.runOn(c3, "bench", "--count", "5", "$OV_PRO", "--json").out())
          .containsPattern(",\"server_ms\":\\d+\\.\\d{3}}");
    }
  }

  @Test
  void doesNotAskAServerThatDoesNotMeasure() throws IOException {
    try (MockServer c3 = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      c3.fault(
          request -> request.request().type() == MessageType.FEATURES,
          Fault.answer("1".repeat(16), Tail.SUCCESS));

      Cli.runOn(c3, "bench", "--count", "5", "MYINT")
          .succeeds()
          .anyMatch(line -> line.endsWith("  MEAN"))
          .anyMatch(line -> line.startsWith("read MYINT "));
      assertThat(c3.requests())
          .extracting(request -> request.request().type())
          .contains(MessageType.FEATURES)
          .doesNotContain(MessageType.BENCHMARK);
    }
  }

  static List<Fault> faults() {
    return List.of(Fault.answer("", Tail.FAILURE), Fault.closeBefore(), Fault.wrongFunction(9));
  }

  @ParameterizedTest
  @MethodSource("faults")
  void printsItsOwnTimesIfTheServerFailsToMeasure(Fault fault) throws IOException {
    try (MockServer c3 = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      c3.fault(request -> request.request().type() == MessageType.BENCHMARK, fault);

      Cli.Result result = Cli.runOn(c3, "bench", "--count", "5", "MYINT");

      assertThat(result.lines())
          .anyMatch(line -> line.endsWith("  MEAN"))
          .anyMatch(line -> line.startsWith("read MYINT "));
      assertThat(result.errLines()).singleElement().asString().contains("benchmark");
    }
  }

  @Test
  void takesTheLatencyOfTheSimulatedController() {
    Cli.Result result =
        Cli.run(
            "bench",
            "--mock",
            "--latency",
            "2ms",
            "--count",
            "3",
            "--warm-up",
            "0",
            "--json",
            "MYINT");

    assertThat(result.err()).isEmpty();
    double least =
        Double.parseDouble(result.out().replaceAll("(?s).*\"min_ms\":([\\d.]+).*", "$1"));
    assertThat(least).isGreaterThanOrEqualTo(2);
    assertThat(server.requestCount()).isZero();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--count=0              | --count must be 1 or more, is 0",
        "--clients=0            | --clients must be 1 to 100, is 0",
        "--clients=101          | --clients must be 1 to 100, is 101",
        "--warm-up=-1           | --warm-up must be 0 to 1000000, is -1",
        "--count=1 --for=1s     | --count and --for exclude each other",
        "--latency=1ms          | --latency goes with --mock",
        "--plot=a.gif           | the name of a picture must end with .png or .svg, is a.gif",
      })
  void saysWhatIsWrongWithItsOptions(String options, String message) {
    Cli.Result result = bench(options.split(" "));

    assertThat(result.code()).isEqualTo(2);
    assertThat(result.errLines().get(0)).isEqualTo("jopenshowvar: " + message);
    assertThat(server.requestCount()).isZero();
  }
}
