package no.hials.crosscom.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.cell.Robot;
import no.hials.crosscom.cell.RobotConnection;
import no.hials.crosscom.cli.Main;
import no.hials.crosscom.cli.base.CommandTree;
import no.hials.crosscom.cli.base.Console;
import no.hials.crosscom.cli.base.Robots;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import org.jline.reader.Candidate;
import org.jline.reader.Parser.ParseContext;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ShellCompleterTest {
  @KukaController(server = ServerType.C3_BRIDGE)
  private MockServer server;

  private RobotConnection controller;
  private ShellSymbols symbols;
  private ShellCompleter completer;

  @BeforeEach
  void start() throws IOException {
    server
        .files()
        .put(
            "KRC:\\R1\\Program\\cell.dat",
            """
            DEFDAT CELL PUBLIC
            GLOBAL ENUM COLOUR RED,GREEN
            GLOBAL STRUC CRATE COLOUR LID, INT PARTS[2]
            DECL GLOBAL CRATE CRATES[3]
            ENDDAT
            """);
    Robot target =
        new Robot("", server.host(), server.port(), null, null, ServerType.C3_BRIDGE, null);
    controller = Robots.open(target, Robot.LASTING);
    symbols = new ShellSymbols(controller);
    Console console = new Console(new StringWriter(), new StringWriter(), Map.of());
    CommandTree program = Main.commandLine(console).getCommand();
    completer = new ShellCompleter(new ShellCommands(program), symbols);
  }

  @AfterEach
  void stop() throws IOException {
    controller.close();
  }

  private List<Candidate> candidates(String line) {
    return completer.candidates(
        new ShellParser().parse(line, line.length(), ParseContext.COMPLETE));
  }

  private List<String> values(String line) {
    return candidates(line).stream().map(Candidate::value).toList();
  }

  private Candidate candidate(String line, String value) {
    return candidates(line).stream()
        .filter(candidate -> candidate.value().equals(value))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void offersCommandsAndVariablesAtTheBeginning() {
    assertThat(values("")).contains("get", "help", "vars", "$OV_PRO", "$MODEL_NAME[]", "CRATES[");
  }

  @Test
  void tellsTypeUnitAccessAndMeaningOfASystemVariable() {
    assertThat(candidate("$OV", "$OV_PRO").descr()).isEqualTo("INT % RW, program override");
    assertThat(candidate("$OV", "$OV_PRO").complete()).isTrue();
  }

  @Test
  void goesOnWithoutABlankWhereAFieldOrAnIndexMayFollow() {
    assertThat(candidate("$POS", "$POS_ACT").complete()).isFalse();
    assertThat(candidate("$TOR", "$TORQUE_AXIS_ACT[").complete()).isFalse();
  }

  @Test
  void offersFieldsBehindADotInTheirOrder() {
    List<Candidate> fields = candidates("get $POS_ACT.");

    assertThat(fields.stream().map(Candidate::value))
        .startsWith("$POS_ACT.X", "$POS_ACT.Y", "$POS_ACT.Z", "$POS_ACT.A")
        .endsWith("$POS_ACT.E5", "$POS_ACT.E6");
    assertThat(fields.stream().map(Candidate::sort)).isSorted();
    assertThat(values("crates[1].")).containsExactly("crates[1].LID", "crates[1].PARTS[");
  }

  @Test
  void offersTheIndicesOfAnArray() {
    assertThat(values("CRATES["))
        .containsExactly("CRATES[]", "CRATES[1]", "CRATES[2]", "CRATES[3]");
  }

  @Test
  void offersTheConstantsOfAnEnumerationAsValues() {
    assertThat(values("$MODE_OP = #")).contains("#T1", "#T2", "#AUT", "#EX");
    assertThat(values("$MODE_OP ")).contains("#T1");
    assertThat(values("set CRATES[1].LID ")).containsExactly("#RED", "#GREEN");
    assertThat(values("$OV_PRO = ")).isEmpty();
  }

  @Test
  void offersNamesUsedBeforeThatNoListHas() {
    symbols.used("mysecret");
    symbols.used("$OV_PRO");

    assertThat(values("my")).contains("MYSECRET").doesNotHaveDuplicates();
  }

  @Test
  void offersOptionsOfACommand() {
    assertThat(values("vars --d")).contains("--declared");
    assertThat(values("wait ")).isEmpty();
  }

  @Test
  void offersWhatItKnowsIfTheControllerIsGone() {
    server.close();

    assertThat(values("$OV")).contains("$OV_PRO").doesNotContain("CRATES[");
  }

  @Test
  void findsTheWordThatTheCursorIsIn() {
    ShellParser.Words words = new ShellParser().parse("set $A = #B", 6, ParseContext.COMPLETE);

    assertThat(words.words()).containsExactly("set", "$A", "=", "#B");
    assertThat(words.word()).isEqualTo("$A");
    assertThat(words.wordCursor()).isEqualTo(2);
  }
}
