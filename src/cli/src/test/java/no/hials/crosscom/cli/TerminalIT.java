package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** Runs {@code mock} on a terminal, which {@code script} of util-linux makes. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class TerminalIT {
  private static final Path SCRIPT = Path.of("/usr/bin/script");
  private static final int SIGINT_BIT = 1 << 1;

  @BeforeEach
  void needsATerminalWithCtrlC() throws IOException {
    assumeThat(Files.isExecutable(SCRIPT)).isTrue();
    // a shell's background jobs do not take it, nor do their children
    String ignored =
        Files.readAllLines(Path.of("/proc/self/status")).stream()
            .filter(line -> line.startsWith("SigIgn:"))
            .findFirst()
            .orElseThrow()
            .substring("SigIgn:".length())
            .strip();
    assumeThat(Long.parseUnsignedLong(ignored, 16) & SIGINT_BIT).isZero();
  }

  /** Runs it until a text is there, presses Ctrl-C, and gives all that was shown. */
  private static String show(String term, String until, String options) throws Exception {
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    String command =
        "exec '" + java + "' -jar target/jopenshowvar.jar mock --port 0 --no-discovery" + options;
    ProcessBuilder builder = new ProcessBuilder(SCRIPT.toString(), "-qec", command, "/dev/null");
    builder.environment().keySet().removeAll(List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS"));
    builder.environment().put("TERM", term);
    builder.redirectErrorStream(true);
    Process process = builder.start();
    try {
      StringBuilder shown = new StringBuilder();
      InputStream terminal = process.getInputStream();
      byte[] bytes = new byte[1000];
      boolean pressed = false;
      int length = terminal.read(bytes);
      while (length > 0) {
        shown.append(new String(bytes, 0, length, StandardCharsets.ISO_8859_1));
        if (!pressed && shown.indexOf(until) >= 0) {
          pressed = true;
          process.getOutputStream().write(3);
          process.getOutputStream().flush();
        }
        length = terminal.read(bytes);
      }
      assertThat(process.waitFor()).as(shown.toString()).isZero();
      return shown.toString();
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void showsAStatusLineWithoutWrappingAndTakesItAwayOnCtrlC() throws Exception {
    assertThat(show("xterm", "requests 0", ""))
        .containsPattern(
            "\u001B\\[\\?7l\\d+\\.\\d s \\| T1, no program \\|[^\n]*\u001B\\[K\u001B\\[\\?7h\r")
        .endsWith("\r\u001B[K");
  }

  @Test
  void writesNoControlSequencesOnADumbTerminal() throws Exception {
    assertThat(show("dumb", "T1, no program\r\n", "")).doesNotContain("\u001B");
  }

  @Test
  void hasNoStatusLineInALog() throws Exception {
    assertThat(show("xterm", "T1, no program\r\n", " --verbose")).doesNotContain("\u001B");
  }
}
