package no.hials.crosscom.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.ShellInput;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.code.OperatingMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RunCommandTest {
  @TempDir private Path dir;

  @KukaController private MockServer server;

  private String file(String... lines) throws IOException {
    return Files.write(dir.resolve("test.jov"), List.of(lines)).toString();
  }

  @Test
  void runsTheLinesOfAFile() throws IOException {
    String file = file("; slowly", "$OV_PRO = 10", "wait 1ms", "", "$OV_PRO", "exit", "NOPE");

    Cli.runOn(server, "run", file, "--yes")
        .succeeds()
        .containsExactly("$OV_PRO = 10", "$OV_PRO = 10");
  }

  @Test
  void stopsAtTheFirstErrorWithFileAndLine() throws IOException {
    String file = file("MYINT = 5", "$POS_ACT.X = 1.0", "MYINT = 6");

    Cli.Result result = Cli.runOn(server, "run", file, "--yes");

    assertThat(result.lines()).containsExactly("MYINT = 5");
    assertThat(result.errLines())
        .singleElement()
        .asString()
        .startsWith("jopenshowvar: " + file + ":2: the controller refused to write $POS_ACT.X");
    assertThat(result.code()).isEqualTo(1);
    assertThat(server.variables().get("MYINT")).isEqualTo("5");
  }

  @Test
  void sendsNothingOfAFileWithAMistake() throws IOException {
    String file = file("MYINT = 5", "MYINT = five", "vars --nonsense", "wait");

    Cli.Result result = Cli.runOn(server, "run", file, "--yes");

    result.failsInLines(2).hasSize(3);
    assertThat(result.errLines().get(0))
        .startsWith("jopenshowvar: " + file + ":2: five is not a KRL value");
    assertThat(result.errLines().get(1))
        .startsWith("jopenshowvar: " + file + ":3: unknown option: '--nonsense'");
    assertThat(result.errLines().get(2)).startsWith("jopenshowvar: " + file + ":4: ");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void saysInADryRunWhatEachLineWouldDoWithoutAController() throws IOException {
    String file = file("get $OV_PRO $MODE_OP", "$OV_PRO 10", "wait 2s", "help $OV_PRO", "vars x");

    Cli.run("run", "--dry-run", file)
        .succeeds()
        .containsExactly(
            file + ":1: read $OV_PRO $MODE_OP",
            file + ":2: write $OV_PRO = 10",
            file + ":3: wait 2000 ms",
            file + ":4: help $OV_PRO",
            file + ":5: vars x");
  }

  @Test
  void doesNotBeginAFileThatWritesWithoutLeave() throws IOException {
    String file = file("$OV_PRO", "MYINT = 5");

    Cli.runOn(server, "run", file).fails(5).contains("did not write MYINT = 5: it needs --yes");

    Cli.runOn(server, "run", file, "--yes", "--read-only")
        .fails(5)
        .contains("did not write MYINT = 5: --read-only is given");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void skipsAByteOrderMark() throws IOException {
    String file = file("\ufeff$OV_PRO = 10");

    assertThat(Cli.runOn(server, "run", file, "--yes").lines()).containsExactly("$OV_PRO = 10");
    Cli.Result piped = ShellInput.runOn(server, "\ufeff$OV_PRO\n", "shell");
    assertThat(piped.lines()).containsExactly("$OV_PRO = 10");
  }

  @Test
  void stopsAtAWriteWhoseAnswerHasAnotherValue() throws IOException {
    server.enqueue(Fault.answer("50", Tail.SUCCESS));
    String file = file("MYINT = 7", "MYINT = 8");

    Cli.runOn(server, "run", file, "--yes")
        .failsInALine(1)
        .isEqualTo(
            "jopenshowvar: "
                + file
                + ":1: MYINT: 7 was sent, but the answer to the write is 50; read the variable to"
                + " see its value");
    assertThat(server.requests()).hasSize(1);
  }

  @Test
  void runsStdin() {
    Cli.Result result = ShellInput.runOn(server, "MYINT = 5\nNOPE\n", "run", "-", "--yes");

    assertThat(result.lines()).containsExactly("MYINT = 5");
    assertThat(result.err()).startsWith("jopenshowvar: stdin:2: ");
    assertThat(result.code()).isEqualTo(1);
  }

  @Test
  void asksOnceForEachWriteInEveryMode() {
    List<String> questions = new ArrayList<>();
    Console.Prompt twice =
        question -> {
          questions.add(question);
          return questions.size() < 2 ? "y" : "n";
        };
    String[] args = Cli.argsOn(server, "run", "-");

    Cli.Result inT1 = ShellInput.run("MYINT = 5\nMYINT = 6\n", twice, args);

    assertThat(inT1.lines()).containsExactly("MYINT = 5");
    assertThat(inT1.err()).contains("stdin:2: did not write MYINT = 6: not confirmed");
    assertThat(inT1.code()).isEqualTo(5);
    server.controller().setMode(OperatingMode.AUT);
    ShellInput.run("MYINT = 7\n", twice, args);
    assertThat(questions)
        .containsExactly(
            "Really write MYINT = 5? [y/N] ",
            "Really write MYINT = 6? [y/N] ",
            "$MODE_OP is #AUT, not #T1. Really write MYINT = 7? [y/N] ");
    assertThat(server.requests().stream().filter(RecordedRequest::isWrite)).hasSize(1);
  }

  @Test
  void callsItWrongUsageIfTheFileCannotBeRead() throws IOException {
    Cli.runOn(server, "run", dir.resolve("none").toString())
        .fails(2)
        .contains("none: file not found");

    Path latin = Files.write(dir.resolve("latin"), new byte[] {(byte) 0xE4});
    Cli.runOn(server, "run", latin.toString()).fails(2).contains("latin: it is not in UTF-8");
  }
}
