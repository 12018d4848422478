package no.hials.crosscom.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ShellLineTest {
  private static ShellLine parse(String line) throws ShellSyntaxException {
    return ShellLine.parse(line, Set.of("vars"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "$OV_PRO",
        "$POS_ACT.X",
        "LOAD_DATA[1].CM.X",
        "$TORQUE_AXIS_ACT[]",
        "TOOL_NAME[1,]",
        "@PROXY_TYPE",
        "myPos"
      })
  void aNameAloneReads(String name) throws Exception {
    assertThat(parse("  " + name + " ")).isEqualTo(new ShellLine.Read(List.of(name)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "$OV_PRO 50                   | $OV_PRO      | 50",
        "$OV_PRO = 50                 | $OV_PRO      | 50",
        "$OV_PRO=50                   | $OV_PRO      | 50",
        "$OV_PRO =50                  | $OV_PRO      | 50",
        "$OV_PRO= 50 ; half           | $OV_PRO      | 50",
        "set $OV_PRO 50               | $OV_PRO      | 50",
        "SET $OV_PRO = 50             | $OV_PRO      | 50",
        "write $OV_PRO=50             | $OV_PRO      | 50",
        "MYREAL -1.5                  | MYREAL       | -1.5",
        "MYENUM #T1                   | MYENUM       | #T1",
        "MYBOOL = TRUE                | MYBOOL       | TRUE",
        "MYSTRING[] = \"a = b; #c\"   | MYSTRING[]   | \"a = b; #c\"",
        "MYPOS {X 1.0, Y -2}          | MYPOS        | {X 1.0, Y -2}",
        "MYINTS[] 1 2 3               | MYINTS[]     | 1 2 3",
        "MYREALS[2] = 1               | MYREALS[2]   | 1",
        "set set 5                    | set          | 5",
      })
  void aNameWithAValueWrites(String line, String name, String value) throws Exception {
    assertThat(parse(line)).isEqualTo(new ShellLine.Write(name, value));
  }

  @Test
  void aWordThatIsNearlyACommandIsAVariableIfTheLineSaysSo() throws Exception {
    assertThat(parse("READY")).isEqualTo(new ShellLine.Read(List.of("READY")));
    assertThat(parse("get ready")).isEqualTo(new ShellLine.Read(List.of("ready")));
    assertThat(parse("ready = TRUE")).isEqualTo(new ShellLine.Write("ready", "TRUE"));
    assertThat(parse("set ready TRUE")).isEqualTo(new ShellLine.Write("ready", "TRUE"));
    assertThat(parse("myvar")).isEqualTo(new ShellLine.Read(List.of("myvar")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "   ", "; $OV_PRO = 0", "# $OV_PRO = 0", "  # x"})
  void blankLinesAndCommentsDoNothing(String line) throws Exception {
    assertThat(parse(line)).isEqualTo(new ShellLine.Nothing());
  }

  @Test
  void wordsOfTheLanguageAreTakenInUpperOrLowerCase() throws Exception {
    assertThat(parse("Get $A $B")).isEqualTo(new ShellLine.Read(List.of("$A", "$B")));
    assertThat(parse("WAIT 1.5s")).isEqualTo(new ShellLine.Wait(Duration.ofMillis(1500)));
    assertThat(parse("help")).isEqualTo(new ShellLine.Help(""));
    assertThat(parse("help $OV_PRO")).isEqualTo(new ShellLine.Help("$OV_PRO"));
    assertThat(parse("QUIT")).isEqualTo(new ShellLine.Exit());
  }

  @Test
  void commandsOfTheCommandLineAreTakenWithTheirArguments() throws Exception {
    assertThat(parse("vars --declared \"my file.dat\" x=1"))
        .isEqualTo(new ShellLine.Command(List.of("vars", "--declared", "my file.dat", "x=1")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "raed             | unknown command: raed; did you mean read? For a variable of this name:",
        "raed $X          | unknown command: raed; did you mean read?",
        "wiat 500         | did you mean wait?",
        "hepl             | did you mean help?",
        "exti             | get exti, set exti VALUE",
        "vras             | did you mean vars?",
        "foo bar          | unknown command: foo; as a write: bar is not a KRL value",
        "$OV_PRO = fifty  | fifty is not a KRL value",
        "S[] = hello      | a text needs double quotes: \"hello\", a constant",
        "MYPOS = {X 1     | the brace at position 0 is not closed",
        "MYINT = 1 2      | 1 2 is not a KRL value: expected one value, since the name",
        "$OV_PRO =        | the value is missing",
        "set $OV_PRO      | the value is missing: set NAME VALUE",
        "get              | missing names of variables: get NAME...",
        "50               | must be a variable, such as ",
        "get $A 5         | must be a variable, such as ",
        "= 50             | must be a variable, such as ",
        "MYSTRING[] \"x   | a text must end with a double quote",
        "wait             | wait needs one argument, has 0",
        "wait long        | the time to wait must be like 500, 500ms, 3s or 1m, is long",
        "exit now         | exit takes no argument, has now",
        "$A $B            | $B is not a KRL value",
        "mock --port 0    | mock is not available in the shell",
      })
  void saysWhatIsWrong(String line, String message) {
    assertThatThrownBy(() -> parse(line))
        .isInstanceOf(ShellSyntaxException.class)
        .hasMessageContaining(message);
  }
}
