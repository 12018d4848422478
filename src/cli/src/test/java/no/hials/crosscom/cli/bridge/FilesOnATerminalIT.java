package no.hials.crosscom.cli.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.PseudoTerminal;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The questions and the progress of {@code file} on a terminal. */
@Timeout(120)
@EnabledOnOs(OS.LINUX)
class FilesOnATerminalIT {
  private static final String QUESTION = "[y/N] ";

  @TempDir private Path dir;

  @KukaController(server = ServerType.C3_BRIDGE)
  private MockServer server;

  @BeforeEach
  void start() throws IOException {
    server.files().put("KRC:\\R1\\TP\\a.txt", "old");
  }

  private PseudoTerminal.Shown run(String keys, String command, String... args) throws Exception {
    return PseudoTerminal.run("xterm", QUESTION, keys, Cli.argsOn(server, command, args));
  }

  private String file(int size) throws IOException {
    return Files.write(dir.resolve("a.txt"), new byte[size]).toString();
  }

  @Test
  void asksOnceForAllReasonsAndOverwritesIfTheAnswerIsYes() throws Exception {
    server.controller().setMode(OperatingMode.AUT);
    String local = file(3);

    PseudoTerminal.Shown shown = run("y\r", "file put", local, "KRC:\\R1\\TP\\");

    assertThat(shown.text())
        .startsWith(
            "KRC:\\R1\\TP\\a.txt already exists; $MODE_OP is #AUT, not #T1. Really upload "
                + local
                + "? [y/N] ")
        .endsWith("a.txt, 3 bytes\r\n");
    assertThat(shown.code()).isZero();
    assertThat(server.files().get("KRC:\\R1\\TP\\a.txt")).isEqualTo(new byte[3]);
  }

  @Test
  void deletesNothingIfTheAnswerIsNo() throws Exception {
    PseudoTerminal.Shown shown = run("n\r", "file rm", "KRC:\\R1\\TP\\a.txt");

    assertThat(shown.text()).endsWith("did not delete KRC:\\R1\\TP\\a.txt: not confirmed\r\n");
    assertThat(shown.code()).isEqualTo(5);
    assertThat(server.files().exists("KRC:\\R1\\TP\\a.txt")).isTrue();
  }

  @Test
  void showsProgressInPlaceAndTakesItAway() throws Exception {
    String local = file(200_000);

    PseudoTerminal.Shown shown = run("", "file put", "--yes", local, "KRC:\\R1\\TP\\");

    assertThat(shown.text())
        .contains("KRC:\\R1\\TP\\a.txt: all of 196 KB, checking\u001B[K\u001B[?7h\r")
        .endsWith("\r\u001B[K" + local + " -> KRC:\\R1\\TP\\a.txt, 200000 bytes\r\n");
    assertThat(shown.code()).isZero();
  }

  @Test
  void takesTheProgressAwayAndUploadsNothingAfterCtrlC() throws Exception {
    // many parts, so that the end is far away
    server.fault(
        request -> request.request() instanceof WriteDataRequest,
        Fault.delay(Duration.ofMillis(20)));
    String local = file(20_000_000);

    PseudoTerminal.Shown shown =
        PseudoTerminal.run(
            "xterm",
            " 0 % of ",
            PseudoTerminal.CTRL_C,
            Cli.argsOn(server, "file put", "--yes", local, "KRC:\\R1\\TP\\"));

    assertThat(shown.text())
        .endsWith("\r\u001B[Kjopenshowvar: stopped\r\nnot uploaded: KRC:\\R1\\TP\\a.txt\r\n");
    assertThat(shown.code()).isEqualTo(130);
    assertThat(server.files().text("KRC:\\R1\\TP\\a.txt")).hasValue("old");
  }

  @Test
  void writesNoControlSequencesOnADumbTerminal() throws Exception {
    String local = file(200_000);

    PseudoTerminal.Shown shown =
        PseudoTerminal.run(
            "dumb", QUESTION, "", Cli.argsOn(server, "file put", "--yes", local, "KRC:\\R1\\TP\\"));

    assertThat(shown.text()).isEqualTo(local + " -> KRC:\\R1\\TP\\a.txt, 200000 bytes\r\n");
  }
}
