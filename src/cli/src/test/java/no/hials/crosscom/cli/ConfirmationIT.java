package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.PseudoTerminal;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The question before a write outside T1, on a terminal. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class ConfirmationIT {
  private static final String QUESTION = "[y/N] ";

  @KukaController(mode = OperatingMode.AUT)
  private MockServer server;

  private PseudoTerminal.Shown answer(String term, String keys, String... options)
      throws Exception {
    return PseudoTerminal.run(term, QUESTION, keys, Cli.argsOn(server, "write", options));
  }

  @ParameterizedTest
  @ValueSource(strings = {"y", "Yes"})
  void writesIfTheAnswerIsYes(String yes) throws Exception {
    PseudoTerminal.Shown shown = answer("xterm", yes + "\r", "MYINT", "5");

    assertThat(shown.text())
        .startsWith("$MODE_OP is #AUT, not #T1. Really write MYINT? [y/N] ")
        .endsWith("MYINT = 5\r\n");
    assertThat(shown.code()).isZero();
    assertThat(server.variables().get("MYINT")).isEqualTo("5");
  }

  @ParameterizedTest
  @ValueSource(strings = {"\r", "n\r", "yesno\r", PseudoTerminal.CTRL_D})
  void doesNotWriteIfItIsNot(String keys) throws Exception {
    PseudoTerminal.Shown shown = answer("xterm", keys, "MYINT", "5");

    assertThat(shown.text())
        .contains(QUESTION)
        .endsWith("\r\njopenshowvar: did not write MYINT: not confirmed\r\n");
    assertThat(shown.code()).isEqualTo(5);
    assertThat(server.requests())
        .singleElement()
        .matches(request -> request.request() instanceof ReadRequest);
  }

  @Test
  void doesNotWriteIfCtrlCIsPressed() throws Exception {
    PseudoTerminal.Shown shown = answer("xterm", PseudoTerminal.CTRL_C, "MYINT", "5");

    assertThat(shown.code()).isEqualTo(130);
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }

  /** With Enter, and without it: the Enter after the question must not complete the line. */
  @ParameterizedTest
  @ValueSource(strings = {"y\r", "y", "y\ry\ry"})
  void keysTypedBeforeTheQuestionDoNotAnswerIt(String keys) throws Exception {
    CountDownLatch typed = new CountDownLatch(1);
    server.fault(request -> request.name().equals("$MODE_OP"), Fault.hold(typed));
    try (PseudoTerminal terminal =
        PseudoTerminal.start(Map.of(), "exec %s", Cli.argsOn(server, "write", "MYINT", "5"))) {
      assertThat(server.takeRequest(Duration.ofSeconds(60))).isPresent();
      terminal.type(keys).until(keys.replace("\r", "\r\n")); // the echo
      typed.countDown();
      terminal.until(QUESTION).type("\r");

      assertThat(terminal.end().text()).contains("did not write MYINT: not confirmed");
    }
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void anAnswerDoesNotAnswerTheNextQuestion(@TempDir Path dir) throws Exception {
    Path file = Files.writeString(dir.resolve("two.jov"), "MYINT = 31\nMYINT = 32\n");
    try (PseudoTerminal terminal =
        PseudoTerminal.start(Map.of(), "exec %s", Cli.argsOn(server, "run", file.toString()))) {
      terminal.until(QUESTION).type("y\ry\ry").until(QUESTION).type("\r");

      assertThat(terminal.end().text()).contains("did not write MYINT = 32: not confirmed");
    }
    assertThat(server.variables().get("MYINT")).isEqualTo("31");
  }

  @Test
  void doesNotAskIfYesIsGiven() throws Exception {
    PseudoTerminal.Shown shown = answer("xterm", "", "--yes", "MYINT", "5");

    assertThat(shown).isEqualTo(new PseudoTerminal.Shown(0, "MYINT = 5\r\n"));
    assertThat(server.requests()).singleElement().matches(RecordedRequest::isWrite);
  }

  @Test
  void asksInT1AsTheShellDoes() throws Exception {
    server.controller().setMode(OperatingMode.T1);

    PseudoTerminal.Shown shown = answer("xterm", "\r", "MYINT", "5");

    assertThat(shown.text())
        .startsWith("Really write MYINT? [y/N] ")
        .endsWith("jopenshowvar: did not write MYINT: not confirmed\r\n");
    assertThat(shown.code()).isEqualTo(5);
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }
}
