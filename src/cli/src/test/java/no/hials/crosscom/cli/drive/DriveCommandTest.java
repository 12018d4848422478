package no.hials.crosscom.cli.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.StringWriter;
import java.io.Writer;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import no.hials.crosscom.cli.Main;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.ExitCode;
import no.hials.crosscom.control.DriveSpace;
import no.hials.crosscom.control.StopReason;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.simulator.KrlPrograms;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Drives the simulated robot in real time, slowly, with delays that a busy computer has. */
@Timeout(120)
class DriveCommandTest {
  private static final Map<String, Integer> COLUMNS = Map.of("X", 17, "Z", 19, "A1", 17, "A6", 22);

  private static final Pattern MYAXIS_ZERO = Pattern.compile("A1 0(\\.0*)?,");

  @TempDir Path folder;

  private static String[] patient(String... args) {
    List<String> all = new java.util.ArrayList<>(List.of("drive", "--mock"));
    all.addAll(List.of("--max-delay", "2s", "--no-watchdog"));
    all.addAll(List.of(args));
    return all.toArray(String[]::new);
  }

  private Path replay(String axes, double seconds) throws IOException {
    StringBuilder csv = new StringBuilder("time,axis1,axis6,dead_man\n");
    for (double time = 0; time < seconds; time += 0.05) {
      csv.append(String.format(Locale.ROOT, "%.2f,%s,1%n", time, axes));
    }
    csv.append(String.format(Locale.ROOT, "%.2f,0,0,0%n", seconds));
    return Files.writeString(folder.resolve("replay.csv"), csv);
  }

  /** Returns the position of the robot in each cycle. */
  private static double[] recorded(Path file, String column) throws IOException {
    return Files.readAllLines(file).stream()
        .skip(1)
        .mapToDouble(line -> Double.parseDouble(line.split(",", -1)[COLUMNS.get(column)]))
        .toArray();
  }

  private static double way(double... places) {
    return places[places.length - 1] - places[0];
  }

  @Test
  void aRecordingMovesTheToolAndEndsWithExitCodeZero() throws IOException {
    Path record = folder.resolve("run.csv");

    Cli.Result result =
        Cli.run(
            patient(
                "--device=csv:" + replay("1,0", 1.5), "--speed", "20", "--record", "" + record));

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.lines()).hasSize(2);
    assertThat(result.lines().get(0)).matches("\\d+ cycles, \\d+ of them standing, .*");
    assertThat(result.lines().get(1)).isEqualTo("stopped: the loop was asked to stop");
    assertThat(result.errLines()).singleElement().asString().startsWith("replaying ");
    // how far depends on how often this computer let it send
    assertThat(way(recorded(record, "X"))).isBetween(0.5, 31.0);
    assertThat(way(recorded(record, "Z"))).isCloseTo(0, within(0.1));
  }

  @Test
  void aRecordingMovesTheToolAlongItsOwnAxes() throws IOException {
    Path record = folder.resolve("run.csv");

    Cli.Result result =
        Cli.run(
            patient(
                "--device=csv:" + replay("1,0", 1.5), "--frame", "tool", "--record", "" + record));

    assertThat(result.code()).as(result.err()).isZero();
    // its X points down and back there, at 45 degrees
    double x = way(recorded(record, "X"));
    assertThat(Math.abs(x)).isBetween(0.3, 31.0);
    assertThat(Math.abs(way(recorded(record, "Z")))).isCloseTo(Math.abs(x), within(0.1));
  }

  @Test
  void aRecordingMovesTheAxes() throws IOException {
    Path record = folder.resolve("run.csv");

    Cli.Result result =
        Cli.run(
            patient(
                "--device=csv:" + replay("-0.5,1", 1.5),
                "--frame=joints",
                "--speed=4",
                "--record=" + record));

    assertThat(result.code()).as(result.err()).isZero();
    double first = way(recorded(record, "A1"));
    assertThat(first).isBetween(-4.0, -0.1);
    assertThat(way(recorded(record, "A6"))).isCloseTo(-2 * first, within(0.2));
  }

  @Test
  void withoutTheDeadManOfTheRecordingNothingMoves() throws IOException {
    Path csv = Files.writeString(folder.resolve("a.csv"), "time,axis1\n0,1\n0.1,1\n0.2,1\n");
    Path record = folder.resolve("run.csv");

    Cli.Result result = Cli.run(patient("--device=csv:" + csv, "--record=" + record));

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.errLines()).last().asString().contains("the dead-man was not held");
    assertThat(recorded(record, "X")).isNotEmpty().containsOnly(recorded(record, "X")[0]);
  }

  /** The command on a thread, with datagrams for it. */
  private static final class Receiving implements AutoCloseable {
    private static final Pattern LISTENING = Pattern.compile("UDP 127\\.0\\.0\\.1:(\\d+)\\R");

    private final CompletableFuture<Integer> port = new CompletableFuture<>();
    private final CompletableFuture<Integer> code = new CompletableFuture<>();
    private final StringWriter err = new StringWriter();
    private final Thread thread;
    private final DatagramSocket socket = new DatagramSocket();

    Receiving(MockServer server, String... options) throws IOException {
      List<String> args =
          new java.util.ArrayList<>(
              List.of(
                  Cli.argsOn(
                      server,
                      "drive",
                      "--device=udp:0",
                      "--yes",
                      "--no-watchdog",
                      "--max-delay=2s")));
      args.addAll(List.of(options));
      Writer watched =
          new Writer() {
            @Override
            public void write(char[] chars, int off, int len) {
              err.write(chars, off, len);
              Matcher matcher = LISTENING.matcher(err.toString());
              if (matcher.find()) {
                port.complete(Integer.valueOf(matcher.group(1)));
              }
            }

            @Override
            public void flush() {}

            @Override
            public void close() {}
          };
      thread =
          new Thread(
              () -> {
                code.complete(Main.run(args.toArray(String[]::new), new StringWriter(), watched));
                port.completeExceptionally(new AssertionError(err.toString()));
              });
      thread.start();
    }

    void send(String text) throws IOException {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      socket.send(
          new DatagramPacket(bytes, bytes.length, InetAddress.getLoopbackAddress(), port.join()));
    }

    int stop() {
      thread.interrupt();
      return code.join();
    }

    @Override
    public void close() {
      stop();
      socket.close();
    }
  }

  private static MockServer robot(DriveSpace space) throws IOException {
    MockServer server = MockServer.start(cfg -> {});
    KrlPrograms.start(server.controller(), KrlPrograms.START, space.program());
    return server;
  }

  @Test
  void datagramsMoveTheRobotAndItStandsWhenTheyStop() throws Exception {
    try (MockServer server = robot(DriveSpace.JOINTS);
        Receiving drive = new Receiving(server, "--frame=joints")) {
      double start = server.controller().axes().a1();
      while (server.controller().axes().a1() < start + 1) {
        drive.send("{\"axes\": [1], \"deadMan\": true}");
        Thread.onSpinWait();
      }

      // no more of them: zeros are written, and the robot ends what was planned
      while (!MYAXIS_ZERO.matcher(Cli.runOn(server, "read", "MYAXIS").out()).find()
          || !server.controller().standing()) {
        Thread.onSpinWait();
      }
      double stoodAt = server.controller().axes().a1();
      assertThat(drive.code).isNotDone();
      assertThat(drive.stop()).isZero();
      assertThat(server.controller().axes().a1()).isEqualTo(stoodAt);
    }
  }

  @Test
  void hostileDatagramsMoveNothing() throws Exception {
    try (MockServer server = robot(DriveSpace.JOINTS);
        Receiving drive = new Receiving(server, "--frame=joints")) {
      for (String text :
          List.of(
              "",
              "{\"axes\": [2], \"deadMan\": true}",
              "{\"axes\": [1e999], \"deadMan\": true}",
              "{\"axes\": [1], \"deadMan\": \"true\"}",
              "{\"axes\": [[1]], \"deadMan\": true}",
              "{\"axes\": [1], \"deadMan\": true",
              "[".repeat(2000),
              "{\"axes\": [1], \"deadMan\": true, \"deadMan\": true}",
              "{\"deadMan\": true, \"axes\": [" + "1,".repeat(200) + "1]}",
              "{\"deadMan\": true, \"axes\": [1], \"x\": \"" + "x".repeat(3000) + "\"}")) {
        for (int i = 0; i < 50; i++) {
          drive.send(text);
        }
      }
      double start = server.controller().axes().a1();
      // what comes after them is taken as ever
      while (server.controller().axes().a6() < 0.5) {
        drive.send("{\"axes\": [0, 0, 0, 0, 0, 1], \"deadMan\": true}");
        Thread.onSpinWait();
      }

      assertThat(drive.stop()).isZero();
      assertThat(server.controller().axes().a1()).isEqualTo(start);
    }
  }

  @Test
  void aControllerWithoutTheProgramIsExplained() throws IOException {
    try (MockServer server = MockServer.start(cfg -> {})) {
      Cli.Result result = Cli.runOn(server, "drive", "--device=udp:0");

      result
          .fails(1)
          .contains(
              "the robot moves only if a program on the controller follows MYPOS",
              "no program is selected there; select and start ACTUATOR (krl/actuator.src)",
              "docs/how-to/drive-the-robot.md");
      assertThat(result.errLines().get(1))
          .isEqualTo("jopenshowvar: PROGRAM: $PRO_STATE1 must be #P_ACTIVE, is #P_FREE");
    }
  }

  @Test
  void aWatchdogThatWasOnBeforeIsExplained() {
    assertThat(DriveEnd.hintOnWatchdog("500"))
        .hasValueSatisfying(
            hint -> assertThat(hint).contains("JOV_LIMIT is 500", "write 0 to JOV_LIMIT"));
    assertThat(DriveEnd.hintOnWatchdog("0")).isEmpty();
    assertThat(DriveEnd.hintOnWatchdog("")).isEmpty();
  }

  @Test
  void aControllerWithoutTheWatchdogIsExplained() throws Exception {
    try (MockServer server = robot(DriveSpace.BASE)) {
      server.controller().submit().stop();

      Cli.runOn(server, "drive", "--device=udp:0", "--yes")
          .fails(1)
          .contains("WATCHDOG: the watchdog does not see the heartbeat", "--no-watchdog drives");
    }
  }

  @Test
  void aSecondDriverIsRefusedOrTakesOver() throws Exception {
    try (MockServer server = robot(DriveSpace.JOINTS)) {
      AtomicInteger beat = new AtomicInteger();
      server.faults(
          request -> {
            if (request.names().equals(List.of("JOV_HEARTBEAT"))) {
              server.variables().set("JOV_HEARTBEAT", "" + beat.incrementAndGet());
            }
            return Optional.empty();
          });
      String[] drive =
          Cli.argsOn(
              server, "drive", "--device=udp:0", "--yes", "--frame=joints", "--max-delay=2s");

      Cli.run(drive)
          .fails(1)
          .contains("OTHER_DRIVER: JOV_HEARTBEAT must not change before the start", "--takeover");
      String[] takeover = java.util.Arrays.copyOf(drive, drive.length + 1);
      takeover[drive.length] = "--takeover";
      Cli.run(takeover)
          .fails(1)
          .contains("OTHER_DRIVER: the other driver must stop within 5 s of the takeover");
    }
  }

  @Test
  void anotherProgramThatRunsIsNamed() throws Exception {
    try (MockServer server = robot(DriveSpace.JOINTS);
        Receiving drive = new Receiving(server)) {
      while (!drive.code.isDone()) {
        drive.send("{\"axes\": [1], \"deadMan\": true}");
        Thread.onSpinWait();
      }

      assertThat(drive.stop()).isEqualTo(1);
      assertThat(drive.err.toString())
          .contains(
              "STALLED_FEEDBACK", "EXT_MOVE_AXIS is selected there; select and start ACTUATOR");
    }
  }

  @Test
  void aReadOnlyControllerIsNotDriven() {
    Cli.run(patient("--read-only"))
        .fails(5)
        .isEqualToIgnoringNewLines(
            "jopenshowvar: did not drive the robot by MYPOS: --read-only is given");
  }

  @Test
  void outsideT1ItAsksAPerson() throws Exception {
    try (MockServer server = robot(DriveSpace.BASE)) {
      Cli.runOn(server, "drive", "--device=udp:0")
          .fails(5)
          .contains("did not drive the robot by MYPOS: $MODE_OP is #AUT, which needs --yes");
    }
  }

  @Test
  void withoutATerminalThereIsNoKeyboard() {
    Cli.run("drive", "--mock").fails(2).startsWith("jopenshowvar: the keyboard needs a terminal");
  }

  @Test
  void aFullDiskDoesNotHideWhyItEnded() throws IOException {
    Path full = Path.of("/dev/full");
    assumeThat(full).exists();

    Cli.Result result =
        Cli.run(patient("--device=udp:0", "--for=100ms", "--yes", "--record=" + full));

    assertThat(result.code()).isEqualTo(74);
    assertThat(result.lines()).last().isEqualTo("stopped: the time of 100 ms is over");
    assertThat(result.errLines()).last().asString().contains("could not write /dev/full");
  }

  @Test
  void aRecordingIsNotWrittenOver() throws IOException {
    Path record = Files.writeString(folder.resolve("run.csv"), "mine");

    Cli.run(patient("--device=udp:0", "--record=" + record))
        .fails(2)
        .contains("already exists; --yes overwrites it");
    assertThat(record).hasContent("mine");
  }

  @Test
  void aMissingOrWrongReplayIsNamed() throws IOException {
    Path wrong = Files.writeString(folder.resolve("wrong.csv"), "time,axis1\n0,2\n");

    assertThat(Cli.run(patient("--device=csv:" + folder.resolve("none.csv"))).errLines())
        .containsExactly(
            "jopenshowvar: cannot read " + folder.resolve("none.csv") + ": file not found");
    Cli.run(patient("--device=csv:" + wrong))
        .fails(2)
        .contains("wrong.csv, line 2: an axis must be -1 to 1, is 2.0");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--frame world            | --frame must be base, tool or joints, is world",
        "--speed 0                | --speed must be more than 0 and at most 250 mm/s, is 0.0",
        "--speed 251              | --speed must be more than 0 and at most 250 mm/s, is 251.0",
        "--speed NaN              | --speed must be more than 0 and at most 250 mm/s, is NaN",
        "--frame joints --speed 61 | --speed must be more than 0 and at most 60 deg/s, is 61.0",
        "--frame joints --turn 5  | --turn goes with base and tool",
        "--turn 61                | --turn must be more than 0 and at most 60 deg/s, is 61.0",
        "--dead-zone 1            | --dead-zone must be 0 to less than 1, is 1.0",
        "--period 3               | --period must be 4ms to 100ms, is 3ms",
        "--max-delay 3s           | --max-delay must be at most 2s, is 3000ms",
        "--device mouse           | must be keyboard, gamepad, udp, udp:PORT, udp:ADDRESS:PORT",
        "--device csv:            | must be keyboard, gamepad, udp",
        "--device udp:70000       | must be 0 to 65535, is 70000"
      })
  void saysWhatIsWrong(String options, String message) {
    Cli.run(("drive --mock " + options).split(" ")).fails(2).contains(message);
  }

  @ParameterizedTest
  @EnumSource(StopReason.StopKind.class)
  void onlyAPlannedEndHasExitCodeZero(StopReason.StopKind kind) {
    StopReason reason = new StopReason(kind, "why", null);

    assertThat(DriveEnd.code(reason) == ExitCode.DONE).isEqualTo(reason.isPlanned());
  }
}
