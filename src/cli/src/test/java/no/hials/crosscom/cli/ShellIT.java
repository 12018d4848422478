package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.OperatingMode;
import no.hials.crosscom.mock.RecordedRequest;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The shell on a terminal, which {@code script} of util-linux makes. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class ShellIT {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final Path SCRIPT = Path.of("/usr/bin/script");
  private static final String PROMPT = "127.0.0.1> ";
  private static final String CTRL_C = "\u0003";
  private static final String CTRL_D = "\u0004";
  private static final String RED = "\u001B[31;1m";

  @TempDir private Path state;

  private MockServer server;

  @BeforeEach
  void start() throws IOException {
    assumeThat(Files.isExecutable(SCRIPT)).isTrue();
    server = MockServer.start();
  }

  @AfterEach
  void stop() {
    if (server != null) {
      server.close();
    }
  }

  private static void needsCtrlC() throws IOException {
    assumeThat(PseudoTerminal.takesCtrlC()).isTrue();
  }

  /** Runs the shell on a terminal of 100 columns. */
  private Dialogue shell(Map<String, String> environment, String... options) throws IOException {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    String command =
        Stream.concat(
                Stream.of(java, "-jar", "target/jopenshowvar.jar"),
                Stream.of(Cli.argsOn(server, "shell", options)))
            .map(arg -> "'" + arg + "'")
            .collect(Collectors.joining(" ", "stty cols 100 rows 30; exec ", ""));
    ProcessBuilder builder = new ProcessBuilder(SCRIPT.toString(), "-qec", command, "/dev/null");
    builder
        .environment()
        .keySet()
        .removeAll(List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "NO_COLOR"));
    builder.environment().put("TERM", "xterm");
    builder.environment().put("XDG_STATE_HOME", state.toString());
    builder.environment().putAll(environment);
    return new Dialogue(builder.redirectErrorStream(true).start());
  }

  /** What is typed, and what is shown. */
  private static final class Dialogue implements AutoCloseable {
    private final Process process;
    private final StringBuilder shown = new StringBuilder();
    private final CompletableFuture<Process> watchdog;
    private int seen;

    Dialogue(Process process) {
      this.process = process;
      // a test that waits for what does not come fails, as the stream ends
      this.watchdog =
          CompletableFuture.supplyAsync(
              process::destroyForcibly,
              CompletableFuture.delayedExecutor(LIMIT.toSeconds(), TimeUnit.SECONDS));
    }

    /** Waits until a text is shown that was not there when the last keys were pressed. */
    Dialogue until(String text) throws IOException {
      InputStream terminal = process.getInputStream();
      byte[] bytes = new byte[1000];
      int at = shown.indexOf(text, seen);
      while (at < 0) {
        int length = terminal.read(bytes);
        assertThat(length).as("waiting for " + text + " after " + shown).isPositive();
        shown.append(new String(bytes, 0, length, StandardCharsets.UTF_8));
        at = shown.indexOf(text, seen);
      }
      seen = at + text.length();
      return this;
    }

    Dialogue type(String keys) throws IOException {
      process.getOutputStream().write(keys.getBytes(StandardCharsets.UTF_8));
      process.getOutputStream().flush();
      return this;
    }

    /** Waits for the end, and gives all that was shown. */
    String end() throws Exception {
      shown.append(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
      assertThat(process.waitFor()).as(shown.toString()).isZero();
      return shown.toString();
    }

    @Override
    public void close() {
      watchdog.cancel(false);
      process.destroyForcibly();
    }
  }

  @Test
  void readsAndWritesWhatIsTyped() throws Exception {
    try (Dialogue shell = shell(Map.of())) {
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type("$OV_PRO = 50\r");
      shell
          .until("Really write $OV_PRO = 50? [y/N] ")
          .type("y\r")
          .until("\u001B[?2004l$OV_PRO = 50");
      shell.until(PROMPT).type("MYINT 5\r").until("[y/N] ").type("\r").until("not confirmed");
      shell.until(PROMPT).type(CTRL_D);

      assertThat(shell.end()).doesNotContain("WARNING");
    }
    assertThat(server.variables().get("$OV_PRO")).isEqualTo("50");
    assertThat(server.requests().stream().filter(RecordedRequest::isWrite)).hasSize(1);
  }

  @Test
  void completesNamesFieldsAndConstants() throws Exception {
    try (Dialogue shell = shell(Map.of())) {
      shell.until(PROMPT).type("$ov_p\t").until("OV_PRO").type("\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type("$POS_ACT.\t").until("E6").type("Z\r");
      shell.until("$POS_ACT.Z = 890.000");
      shell.until(PROMPT).type("$MODE_OP = #\t").until("INVALID").type(CTRL_C);
      shell.until(PROMPT).type("exit\r").end();
    }
  }

  @Test
  void remembersLinesInTheNextShell() throws Exception {
    try (Dialogue first = shell(Map.of())) {
      first.until(PROMPT).type("$OV_PRO\r").until("= 100").until(PROMPT).type("exit\r").end();
    }
    try (Dialogue second = shell(Map.of())) {
      // up twice: exit, then the line before it
      second.until(PROMPT).type("\u001BOA\u001BOA\r").until("$OV_PRO = 100");
      second.until(PROMPT).type(CTRL_D).end();
    }
    assertThat(state.resolve("jopenshowvar").resolve("history")).content().contains("$OV_PRO");
  }

  @Test
  void worksWithoutAHistoryThatCannotBeRead() throws Exception {
    Path history = Files.createDirectory(state.resolve("jopenshowvar")).resolve("history");
    byte[] noText = {(byte) 0xFF, '\n'};
    Files.write(history, noText);
    try (Dialogue shell = shell(Map.of())) {
      shell.until("history: it is not in UTF-8");
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type(CTRL_D).end();
    }
    assertThat(history).hasBinaryContent(noText);
  }

  @Test
  void worksWithoutAHistoryThatCannotBeWritten() throws Exception {
    Files.createFile(state.resolve("jopenshowvar"));
    try (Dialogue shell = shell(Map.of())) {
      shell.until("what is typed is not kept: ");
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");

      assertThat(shell.until(PROMPT).type(CTRL_D).end()).doesNotContain("WARNING");
    }
  }

  @Test
  void runsPastedLinesOneByOneUpToTheFirstThatFails() throws Exception {
    try (Dialogue shell = shell(Map.of("NO_COLOR", "1"), "--yes")) {
      shell.until(PROMPT).type(pasted("$OV_PRO = 40\r$OV_PRO\r50\rMYINT = 5\r") + "\r");
      shell.until("must be the name of a variable").until(PROMPT).type(CTRL_D).end();
    }
    assertThat(server.variables().get("$OV_PRO")).isEqualTo("40");
    assertThat(server.requests().stream().filter(RecordedRequest::isWrite)).hasSize(1);
  }

  private static String pasted(String text) {
    return "\u001B[200~" + text + "\u001B[201~";
  }

  @Test
  void comesBackToThePromptOnCtrlC() throws Exception {
    needsCtrlC();
    server.fault(request -> request.toString().contains("$POS_ACT"), Fault.dropAnswer());
    try (Dialogue shell = shell(Map.of(), "--timeout", "10m")) {
      shell.until(PROMPT).type("$POS_ACT\r");
      while (!server.takeRequest(LIMIT).orElseThrow().toString().contains("$POS_ACT")) {
        // the prompt reads something, too
      }
      shell.type(CTRL_C).until("jopenshowvar: ").until("interrupted");
      shell.until(PROMPT).type("$OV_").until("$OV_").type(CTRL_C);
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type(CTRL_D).end();
    }
  }

  @Test
  void comesBackToThePromptAfterALossOfTheConnection() throws Exception {
    server.fault(RecordedRequest::isWrite, Fault.closeDuring(5));
    try (Dialogue shell = shell(Map.of(), "--yes")) {
      shell.until(PROMPT).type("MYINT = 5\r").until("the outcome is unknown");
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type(CTRL_D).end();
    }
    assertThat(server.requests().stream().filter(RecordedRequest::isWrite)).hasSize(1);
  }

  @Test
  void warnsOutsideT1InRedUnlessColoursAreNotWanted() throws Exception {
    server.controller().setMode(OperatingMode.AUT);
    try (Dialogue shell = shell(Map.of())) {
      assertThat(shell.until("> ").type(CTRL_D).end()).contains(RED + "#AUT");
    }
    try (Dialogue shell = shell(Map.of("NO_COLOR", "1"))) {
      assertThat(
              shell
                  .until("127.0.0.1 #AUT> ")
                  .type("$POS_ACT.\t")
                  .until("E6")
                  .type(CTRL_C)
                  .until("> ")
                  .type(CTRL_D)
                  .end())
          .doesNotContainPattern("\u001B\\[([0-9;]*;)?[39][0-7][;m]");
    }
  }
}
