package no.hials.crosscom.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.PseudoTerminal;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.code.OperatingMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The shell on a terminal, which {@code script} of util-linux makes. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class ShellIT {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final String PROMPT = "127.0.0.1> ";
  private static final String RED = "\u001B[31;1m";

  @TempDir private Path state;

  @KukaController private MockServer server;

  /** Runs the shell on a terminal of 100 columns. */
  private PseudoTerminal shell(Map<String, String> environment, String... options)
      throws IOException {
    Map<String, String> all = new HashMap<>(environment);
    all.put("XDG_STATE_HOME", state.toString());
    return PseudoTerminal.start(
        all, "stty cols 100 rows 30; exec %s", Cli.argsOn(server, "shell", options));
  }

  /** With Enter, and without it: the Enter after the question must not complete the line. */
  @ParameterizedTest
  @ValueSource(strings = {"y\r", "y"})
  void keysTypedBeforeTheQuestionDoNotAnswerIt(String keys) throws Exception {
    CountDownLatch asked = new CountDownLatch(1);
    CountDownLatch typed = new CountDownLatch(1);
    try (PseudoTerminal shell = shell(Map.of())) {
      shell.until(PROMPT);
      server.faults(
          request -> {
            if (!request.name().equals("$MODE_OP")) {
              return Optional.empty();
            }
            asked.countDown();
            return Optional.of(Fault.hold(typed));
          });
      shell.type("MYINT = 5\r");
      asked.await(); // by now the line editor has given the terminal back, which shows the keys
      shell.type(keys).until("y");
      typed.countDown();
      shell.until("[y/N] ").type("\r").until("not confirmed");
      shell.until(PROMPT).type(PseudoTerminal.CTRL_D).finish();
    }
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void readsAndWritesWhatIsTyped() throws Exception {
    try (PseudoTerminal shell = shell(Map.of())) {
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type("$OV_PRO = 50\r");
      shell
          .until("Really write $OV_PRO = 50? [y/N] ")
          .type("y\r")
          .until("\u001B[?2004l$OV_PRO = 50");
      shell.until(PROMPT).type("MYINT 5\r").until("[y/N] ").type("\r").until("not confirmed");
      shell.until(PROMPT).type(PseudoTerminal.CTRL_D);

      assertThat(shell.finish()).doesNotContain("WARNING");
    }
    assertThat(server.variables().get("$OV_PRO")).isEqualTo("50");
    assertThat(server.requests().stream().filter(RecordedRequest::isWrite)).hasSize(1);
  }

  @Test
  void showsInThePromptThatItIsForReadingOnly() throws Exception {
    try (PseudoTerminal shell = shell(Map.of(), "--read-only")) {
      shell.until("127.0.0.1 (read-only)> ").type("$OV_PRO = 50\r").until("--read-only is given");
      shell.until("127.0.0.1 (read-only)> ").type(PseudoTerminal.CTRL_D).finish();
    }
  }

  @Test
  void watchIsATableThatTheKeyQOrCtrlCEnds() throws Exception {
    String enter = "\u001b[?1049h";
    String leave = "\u001b[?1049l";
    try (PseudoTerminal shell = shell(Map.of())) {
      for (String end : List.of("q", PseudoTerminal.CTRL_C)) {
        shell.until(PROMPT).type("watch MYINT\r").until(enter).until("MYINT");
        shell.type(end).until(leave).until(" sample");
      }
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type(PseudoTerminal.CTRL_D).finish();
    }
  }

  @Test
  void completesNamesFieldsAndConstants() throws Exception {
    try (PseudoTerminal shell = shell(Map.of())) {
      shell.until(PROMPT).type("$ov_p\t").until("OV_PRO").type("\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type("$POS_ACT.\t").until("E6").type("Z\r");
      shell.until("$POS_ACT.Z = 890.000");
      shell.until(PROMPT).type("$MODE_OP = #\t").until("INVALID").type(PseudoTerminal.CTRL_C);
      shell.until(PROMPT).type("exit\r").finish();
    }
  }

  @Test
  void remembersLinesInTheNextShell() throws Exception {
    try (PseudoTerminal first = shell(Map.of())) {
      first.until(PROMPT).type("$OV_PRO\r").until("= 100").until(PROMPT).type("exit\r").finish();
    }
    try (PseudoTerminal second = shell(Map.of())) {
      // up twice: exit, then the line before it
      second.until(PROMPT).type("\u001BOA\u001BOA\r").until("$OV_PRO = 100");
      second.until(PROMPT).type(PseudoTerminal.CTRL_D).finish();
    }
    assertThat(state.resolve("jopenshowvar").resolve("history")).content().contains("$OV_PRO");
  }

  @Test
  void worksWithoutAHistoryThatCannotBeRead() throws Exception {
    Path history = Files.createDirectory(state.resolve("jopenshowvar")).resolve("history");
    byte[] noText = {(byte) 0xFF, '\n'};
    Files.write(history, noText);
    try (PseudoTerminal shell = shell(Map.of())) {
      shell.until("history: it is not in UTF-8");
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type(PseudoTerminal.CTRL_D).finish();
    }
    assertThat(history).hasBinaryContent(noText);
  }

  @Test
  void worksWithoutAHistoryThatCannotBeWritten() throws Exception {
    Files.createFile(state.resolve("jopenshowvar"));
    try (PseudoTerminal shell = shell(Map.of())) {
      shell.until("the history is not saved: ");
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");

      assertThat(shell.until(PROMPT).type(PseudoTerminal.CTRL_D).finish())
          .doesNotContain("WARNING");
    }
  }

  @Test
  void runsPastedLinesOneByOneUpToTheFirstThatFails() throws Exception {
    try (PseudoTerminal shell = shell(Map.of("NO_COLOR", "1"), "--yes")) {
      shell.until(PROMPT).type(pasted("$OV_PRO = 40\r$OV_PRO\r50\rMYINT = 5\r") + "\r");
      shell
          .until("must be a variable, such as ")
          .until(PROMPT)
          .type(PseudoTerminal.CTRL_D)
          .finish();
    }
    assertThat(server.variables().get("$OV_PRO")).isEqualTo("40");
    assertThat(server.requests().stream().filter(RecordedRequest::isWrite)).hasSize(1);
  }

  private static String pasted(String text) {
    return "\u001B[200~" + text + "\u001B[201~";
  }

  @Test
  void comesBackToThePromptOnCtrlC() throws Exception {
    server.fault(request -> request.toString().contains("$POS_ACT"), Fault.dropAnswer());
    try (PseudoTerminal shell = shell(Map.of(), "--timeout", "10m")) {
      shell.until(PROMPT).type("$POS_ACT\r");
      while (!server.takeRequest(LIMIT).orElseThrow().toString().contains("$POS_ACT")) {
        // the prompt reads something, too
      }
      shell.type(PseudoTerminal.CTRL_C).until("jopenshowvar: ").until("interrupted");
      shell.until(PROMPT).type("$OV_").until("$OV_").type(PseudoTerminal.CTRL_C);
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type(PseudoTerminal.CTRL_D).finish();
    }
  }

  @Test
  void comesBackToThePromptAfterALossOfTheConnection() throws Exception {
    server.fault(RecordedRequest::isWrite, Fault.closeDuring(5));
    try (PseudoTerminal shell = shell(Map.of(), "--yes")) {
      shell.until(PROMPT).type("MYINT = 5\r").until("the outcome is unknown");
      shell.until(PROMPT).type("$OV_PRO\r").until("$OV_PRO = 100");
      shell.until(PROMPT).type(PseudoTerminal.CTRL_D).finish();
    }
    assertThat(server.requests().stream().filter(RecordedRequest::isWrite)).hasSize(1);
  }

  @Test
  void warnsOutsideT1InRedUnlessColoursAreNotWanted() throws Exception {
    server.controller().setMode(OperatingMode.AUT);
    try (PseudoTerminal shell = shell(Map.of())) {
      assertThat(shell.until("> ").type(PseudoTerminal.CTRL_D).finish()).contains(RED + "#AUT");
    }
    try (PseudoTerminal shell = shell(Map.of("NO_COLOR", "1"))) {
      assertThat(
              shell
                  .until("127.0.0.1 #AUT> ")
                  .type("$POS_ACT.\t")
                  .until("E6")
                  .type(PseudoTerminal.CTRL_C)
                  .until("> ")
                  .type(PseudoTerminal.CTRL_D)
                  .finish())
          .doesNotContainPattern("\u001B\\[([0-9;]*;)?[39][0-7][;m]");
    }
  }
}
