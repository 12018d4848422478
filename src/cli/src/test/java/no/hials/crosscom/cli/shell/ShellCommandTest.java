package no.hials.crosscom.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.ShellInput;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShellCommandTest {
  @KukaController private MockServer server;

  @Test
  void runsPipedLinesWithoutPromptEchoOrQuestion() {
    Cli.Result result =
        ShellInput.runOn(
            server,
            "$OV_PRO\n; half of it\n$OV_PRO = 50\nget $OV_PRO $MODE_OP\nMYSTRING[] \"a b\"\n",
            "shell",
            "--yes");

    result
        .succeeds()
        .containsExactly(
            "$OV_PRO = 100",
            "$OV_PRO = 50",
            "$OV_PRO = 50",
            "$MODE_OP = #T1",
            "MYSTRING[] = \"a b\"");
  }

  @Test
  void usesOneConnectionForAllLines() {
    ShellInput.runOn(server, "$OV_PRO\n$OV_PRO\n$OV_PRO\n", "shell");

    assertThat(server.requests().stream().map(RecordedRequest::connection).distinct()).hasSize(1);
  }

  @Test
  void doesNotWriteWithoutALeaveThatNobodyCanGive() {
    ShellInput.runOn(server, "MYINT = 5\n$OV_PRO\n", "shell")
        .failsInLines(5)
        .containsExactly("jopenshowvar: line 1: did not write MYINT = 5: it needs --yes");
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void doesNotSendAMistypedCommandAsAVariable() {
    ShellInput.runOn(server, "wiat 500\n", "shell", "--yes")
        .fails(2)
        .contains("unknown command: wiat; did you mean wait?");
    assertThat(server.requestCount()).isZero();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "%s",
        "get %s",
        "MYINT = %s",
        "MYINT = \"%s",
        "wait %s",
        "help %s",
        "read %s b %s"
      })
  void shortensALongLineInItsError(String form) {
    String line = form.replace("%s", "a".repeat(1_000_000));

    Cli.Result result = ShellInput.runOn(server, line + "\n", "shell", "--yes");

    assertThat(result.code()).isBetween(1, 2);
    assertThat(result.err()).startsWith("jopenshowvar: line 1: ").hasSizeLessThan(5000);
  }

  @Test
  void doesNotWriteIfItIsForReadingOnly() {
    ShellInput.runOn(server, "MYINT = 5\n", "shell", "--yes", "--read-only")
        .fails(5)
        .contains("line 1: did not write MYINT = 5: --read-only is given");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void stopsAtTheFirstLineThatFailsWithItsCode() {
    Cli.Result refused = ShellInput.runOn(server, "$OV_PRO\nNOPE\n$OV_PRO\n", "shell");
    assertThat(refused.lines()).hasSize(1);
    assertThat(refused.err())
        .startsWith("jopenshowvar: line 2: the controller refused to read NOPE");
    assertThat(refused.code()).isEqualTo(1);

    ShellInput.runOn(server, "$OV_PRO = x\n$OV_PRO\n", "shell").fails(2);

    server.enqueue(Fault.closeDuring(5));
    ShellInput.runOn(server, "MYINT = 5\nMYINT = 6\n", "shell", "--yes")
        .fails(4)
        .contains("line 1: ")
        .contains("the outcome is unknown");
  }

  @Test
  void callsItWrongUsageIfANameCannotBeSent() {
    ShellInput.runOn(server, "get MYINT\u0100\n", "shell")
        .fails(2)
        .startsWith("jopenshowvar: line 1: ");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void runsOtherCommandsOnTheSameController() {
    Cli.Result result = ShellInput.runOn(server, "vars torque max\nexit\nNOPE\n", "shell");

    assertThat(result.out()).contains("$TORQUE_AXIS_MAX[12]").doesNotContain("$OV_PRO");
    assertThat(result.code()).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"@cell2", "--robot=cell2", "--host=127.0.0.1", "--port=7", "--mock"})
  void sendsNoCommandToAnotherController(String option) {
    ShellInput.runOn(server, "watch $OV_PRO " + option + "\n", "shell")
        .fails(2)
        .contains(option + ": commands here go to the controller of the shell; another");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void stopsIfAnotherCommandFails() {
    ShellInput.runOn(server, "vars --declared no-such-file.dat\n$OV_PRO\n", "shell")
        .failsInLines(2)
        .containsExactly("jopenshowvar: cannot read no-such-file.dat: file not found");
  }

  @Test
  void explainsASystemVariable() {
    Cli.Result result = ShellInput.runOn(server, "help $mode_op\nhelp $POS_ACT.S\n", "shell");

    assertThat(result.lines())
        .containsExactly(
            "$MODE_OP",
            "  operating mode",
            "  type    MODE_OP",
            "  access  read",
            "  values  #AUT, #EX, #INVALID, #T1, #T2",
            "$POS_ACT.S",
            "  field of $POS_ACT: commanded tool centre point in the base frame",
            "  type    INT",
            "  access  read");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void explainsTheLanguageAndItsCommands() {
    Cli.Result result =
        ShellInput.runOn(server, "help\nhelp wait\nhelp quit\nhelp vars\n", "shell");

    assertThat(result.out())
        .contains("$OV_PRO = 50")
        .contains("get NAME...")
        .containsSubsequence("exit, quit", "exit, quit")
        .contains("Usage: jopenshowvar vars");
  }

  @Test
  void saysSoIfThereIsNothingToExplain() {
    ShellInput.runOn(server, "help nothing\n", "shell")
        .fails(2)
        .contains("unknown command or variable: nothing");
  }

  @Test
  void explainsAVariableThatADataListOnTheControllerDeclares() throws IOException {
    try (MockServer bridge = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      bridge
          .files()
          .put(
              "KRC:\\R1\\Program\\cell.dat",
              """
            DEFDAT CELL PUBLIC
            DECL GLOBAL INT PARTS[4] ;parts in the boxes
            DECL INT HIDDEN
            ENDDAT
            """);

      Cli.Result result = ShellInput.runOn(bridge, "help parts\nhelp hidden\n", "shell");

      assertThat(result.lines())
          .containsExactly(
              "PARTS[4]",
              "  parts in the boxes",
              "  type    INT",
              "  from    KRC:\\R1\\Program\\cell.dat");
      assertThat(result.code()).isEqualTo(2);
    }
  }
}
