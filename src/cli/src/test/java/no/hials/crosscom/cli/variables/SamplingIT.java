package no.hials.crosscom.cli.variables;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import no.hials.crosscom.cell.recording.RecordedData;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.Jar;
import no.hials.crosscom.cli.base.PseudoTerminal;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Runs {@code watch} and {@code record} from the jar, on a terminal and without one. */
@Timeout(120)
class SamplingIT {
  private static final String CTRL_Z = "\u001a";
  private static final String ENTER = "\u001b[?1049h";
  private static final String LEAVE = "\u001b[?1049l";

  @TempDir private Path dir;
  @KukaController private MockServer server;

  /** Runs a command on a terminal, presses a key when a text is there, and returns the output. */
  private String show(
      Map<String, String> environment, String until, String key, String name, String... args)
      throws Exception {
    try (PseudoTerminal terminal =
        PseudoTerminal.start(
            environment, "stty rows 24 cols 80; exec %s", Cli.argsOn(server, name, args))) {
      return terminal.until(until).type(key).finish();
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void watchShowsATableAndLeavesTheTerminalAsItWasOnCtrlC() throws Exception {
    String shown =
        show(Map.of(), "MYFRAME.C", PseudoTerminal.CTRL_C, "watch", "$OV_PRO", "MYFRAME");

    int left = shown.indexOf("\u001b[?1049l");
    assertThat(shown.substring(0, left)).contains("\u001b[?1049h", "\u001b[?25l", "MYFRAME.X");
    assertThat(shown.substring(left))
        .contains("\u001b[?25h", "NAME ", "MYFRAME.C ", "access ")
        .doesNotContain("\u001b[1m", "\u001b[?25l");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void watchEndsWithTheKeyQAndHasNoColoursIfTheyAreNotWanted() throws Exception {
    String shown = show(Map.of("NO_COLOR", "1"), "MYINT", "q", "watch", "MYINT");

    assertThat(shown)
        .contains("\u001b[?1049h", "NAME ")
        .doesNotContainPattern("\u001b\\[[0-9;]*[13][0-9]?m");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void watchLeavesTheScreenOnCtrlZAndShowsItAgainAfterFg() throws Exception {
    String shell =
        "stty rows 24 cols 80; export WATCH=\"%s\" PS1='READY> ';"
            + " exec bash --norc --noprofile --noediting -i";
    try (PseudoTerminal terminal =
        PseudoTerminal.start(Map.of(), shell, Cli.argsOn(server, "watch", "MYINT"))) {
      terminal.until("READY> ").type("eval \"$WATCH\"\r").until(ENTER).until("MYINT");
      terminal.type(CTRL_Z).until(LEAVE).until("Stopped").until("READY> ");
      terminal.type("fg\r").until(ENTER).until("MYINT");
      terminal.type("q").until(LEAVE).until("MYINT").until("READY> ");
      terminal.type("exit\r").finish();
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void watchGoesOnAfterCtrlZIfNoShellCouldContinueIt() throws Exception {
    try (PseudoTerminal terminal =
        PseudoTerminal.start(
            Map.of(), "stty rows 24 cols 80; exec %s", Cli.argsOn(server, "watch", "MYINT"))) {
      terminal.until(ENTER).until("MYINT").type(CTRL_Z).until(LEAVE).until(ENTER).until("MYINT");
      terminal.type("q").finish();
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void watchPrintsLinesOnADumbTerminal() throws Exception {
    assertThat(show(Map.of("TERM", "dumb"), "MYINT = 0", PseudoTerminal.CTRL_C, "watch", "MYINT"))
        .doesNotContain("\u001b");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void recordShowsHowItGoesAndKeepsEverySampleOnCtrlC() throws Exception {
    Path file = dir.resolve("a.csv");

    String shown =
        show(
            Map.of(),
            "/s, access",
            PseudoTerminal.CTRL_C,
            "record",
            "MYINT",
            "--out",
            file.toString());

    assertThat(shown).contains("\u001b[?7l").containsPattern("recorded to \\S+a.csv: \\d+ samples");
    String recorded = shown.substring(shown.indexOf("recorded to"));
    int samples = Integer.parseInt(recorded.replaceFirst("(?s).*?: (\\d+) samples.*", "$1"));
    assertThat(RecordedData.read(file).find("MYINT").orElseThrow().size()).isEqualTo(samples);
  }

  /** Starts a recording, and waits for its first samples. */
  private Process recording(Path file) throws Exception {
    Process process =
        Jar.process(
                Cli.argsOn(server, "record", "MYINT", "--period", "10ms", "--out", file.toString()))
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(dir.resolve("err").toFile())
            .start();
    while (server.requestCount() < 10 && process.isAlive()) {
      Thread.onSpinWait();
    }
    return process;
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no SIGTERM")
  void recordEndsWithCode0OnSigterm() throws Exception {
    Path file = dir.resolve("a.csv");
    Process process = recording(file);
    try {
      process.destroy();

      assertThat(process.waitFor()).isZero();
    } finally {
      process.destroyForcibly();
    }
    int rows = RecordedData.read(file).series().get(0).size();
    assertThat(dir.resolve("err")).content().startsWith("recorded to " + file + ": " + rows + " s");
    // the first one was a test
    assertThat(rows).isEqualTo((int) server.requestCount() - 1);
  }

  @ParameterizedTest
  @CsvSource({
    "watch MYINT, MYINT = 0",
    "record MYINT --out -, recorded: ",
    "bench MYINT --for 10m, read MYINT "
  })
  @EnabledOnOs(OS.LINUX)
  void aClosedTerminalEndsACommandWithCode129AfterItsOutput(String command, String last)
      throws Exception {
    Path shown = dir.resolve("shown");
    Process process =
        Jar.withDefaultSignal("HUP", Jar.process(Cli.argsOn(server, command)))
            .redirectErrorStream(true)
            .redirectOutput(shown.toFile())
            .start();
    try {
      while (server.requestCount() < 10 && process.isAlive()) {
        Thread.onSpinWait();
      }
      Jar.send("HUP", process);

      assertThat(process.waitFor()).as(Files.readString(shown)).isEqualTo(129);
    } finally {
      process.destroyForcibly();
    }
    assertThat(shown).content().contains(last);
  }

  @Test
  void recordRefusesAFileThatAnotherProcessRecordsTo() throws Exception {
    Path file = dir.resolve("a.csv");
    Process process = recording(file);
    try {
      Cli.runOn(server, "record", "MYINT", "--count", "1", "--yes", "--out", file.toString())
          .failsInALine(74)
          .isEqualTo(
              "jopenshowvar: could not write " + file + ": another command is recording to it");
    } finally {
      process.destroyForcibly().waitFor();
    }
    assertThat(RecordedData.read(file).series().get(0).size()).isPositive();
  }

  private static long rows(Path csv) throws IOException {
    // the first line has names
    return Files.readString(csv).lines().count() - 1;
  }

  @Test
  void recordHasWhatItReadInTheFileIfItIsKilled() throws Exception {
    Path file = dir.resolve("a.csv");
    Process process = recording(file);
    // the last answers may not have come to be written, but a buffer of rows would hold hundreds
    while (rows(file) < 7 && server.requestCount() < 100 && process.isAlive()) {
      Thread.onSpinWait();
    }
    process.destroyForcibly().waitFor();

    assertThat(RecordedData.read(file).series().get(0).size()).isGreaterThanOrEqualTo(7);
  }
}
