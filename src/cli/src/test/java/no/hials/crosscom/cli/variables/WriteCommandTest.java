package no.hials.crosscom.cli.variables;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.code.OperatingMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class WriteCommandTest {
  @KukaController private MockServer server;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "$OV_PRO      | 50           | 50",
        "MYINT        | -5           | -5",
        "MYREAL       | -5.5         | -5.50000",
        "MYREAL       | -1.5E-05     | -1.50000E-05",
        "MYREAL       | -.5          | -0.500000",
        "MYBOOL       | TRUE         | TRUE",
        "MYENUM       | #EX          | #EX",
        "MYCHAR       | \"x\"        | \"x\"",
        "MYSTRING[]   | \"two words\"| \"two words\"",
        "MYREALS[2]   | 1            | 1.00000",
        "MYPOS.X      | -2.5         | -2.50000",
      })
  void writesAndPrintsWhatItSent(String name, String value, String stored) {
    Cli.Result result = Cli.runOn(server, "write", name, value);

    assertThat(result)
        .isEqualTo(new Cli.Result(0, name + " = " + value + System.lineSeparator(), ""));
    assertThat(server.variables().get(name)).isEqualTo(stored);
  }

  @Test
  void writesSomeFieldsOfAnAggregate() {
    Cli.Result result = Cli.runOn(server, "write", "MYFRAME", "{X 100.0,Z -20.5}");

    assertThat(result.lines()).containsExactly("MYFRAME = {X 100.0,Z -20.5}");
    assertThat(server.variables().get("MYFRAME"))
        .isEqualTo("{FRAME: X 100.000, Y 0.0, Z -20.5000, A 0.0, B 0.0, C 0.0}");
  }

  @Test
  void writesToASimulatedControllerOfItsOwn() {
    assertThat(Cli.run("write", "MYINT", "7", "--mock").lines()).containsExactly("MYINT = 7");
    assertThat(server.variables().get("MYINT")).isEqualTo("0");
  }

  @Test
  void takesAnyValueBehindTwoHyphens() {
    Cli.runOn(server, "write", "--yes", "--", "MYINT", "-5").succeeds();
    Cli.runOn(server, "write", "--", "MYINT", "--json")
        .fails(2)
        .startsWith("jopenshowvar: VALUE is not a KRL value: ");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "S[]     | hello        | a text needs double quotes: '\"hello\"', a constant of an ENUM"
            + " begins with #: '#hello'",
        "S[]     | two words    | a text needs double quotes: '\"two words\"'",
        "S[]     | \"hello       | the double quote at position 0 is not closed",
        "MYENUM  | EX           | begins with #: '#EX'",
        "MYFRAME | {X 1         | expected ',' or '}' at position 4, found the end, in: {X 1; the"
            + " brace at position 0 is not closed",
        "MYFRAME | {A {X 1}     | the brace at position 0 is not closed",
        "MYREAL  | 1,5          | a decimal number has a point: 1.5",
        "MYINT   | 5x           | expected",
        "MYINT   | 'abc'        | found 'a', in: 'abc'; a text needs double quotes instead of",
        "S[]     | 'hello'      | a text needs double quotes instead of single ones",
        "MYINT   | 1 2          | expected one value, since the name does not end with [] at"
            + " position 0, found '1', in: 1 2",
        "A[1]    | #A #B        | expected one value, since the name does not end with []",
        "MYFRAME | {X 1 Y 2}    | found 'Y', in: {X 1 Y 2}; fields need commas between them",
        "MYPOS   | {POS: X 1, Y 2 T 3} | found 'T', in: {POS: X 1, Y 2 T 3}; fields need commas",
        "MYFRAME | {}           | expected a field with its value at position 1, found '}', in: {}",
        "MYFRAME | {X}          | expected a field with its value at position 2, found '}'",
      })
  void refusesAMalformedValueBeforeItConnects(String name, String value, String hint) {
    server.refuseConnections();

    Cli.runOn(server, "write", "--yes", name, value)
        .fails(2)
        .startsWith("jopenshowvar: VALUE is not a KRL value: ")
        .contains(hint);
  }

  @ParameterizedTest
  @CsvSource({"$POS_ACT.X,1.0", "NOPE,1", "MYINT,#T1"})
  void saysWhatTheControllerRefused(String name, String value) {
    Cli.runOn(server, "write", name, value)
        .failsInALine(1)
        .startsWith("jopenshowvar: the controller refused to write " + name);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {"MYSTRING[]|\"\u0100\"", "MY\u0100|1", "MYINT|` `", "` `|1"})
  void callsItWrongUsageIfItCannotBeSent(String name, String value) {
    Cli.runOn(server, "write", name, value).fails(2).startsWith("jopenshowvar: ");
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void callsItWrongUsageIfItIsTooLongToBeSent() {
    String value = "{X " + "0".repeat(253) + "}";

    Cli.runOn(server, "write", "MYFRAME", value)
        .fails(2)
        .startsWith(
            "jopenshowvar: MYFRAME: an aggregate to be written must have at most 255 bytes");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void explainsALongTextWithoutRepeatingIt() {
    Cli.runOn(server, "write", "MYSTRING[]", "hello" + "A".repeat(70_000))
        .fails(2)
        .contains("position 0, found 'h', in: hello", "; a text needs double quotes\n")
        .hasSizeLessThan(500);
  }

  @Test
  void doesNotTakeAnArgumentForAFileOfArguments(@TempDir Path dir) throws IOException {
    Path file = Files.writeString(dir.resolve("value"), "5");

    Cli.Result result = Cli.runOn(server, "write", "MYINT", "@" + file);

    assertThat(result.err()).contains("VALUE is not a KRL value", "@" + file);
    assertThat(server.variables().get("MYINT")).isEqualTo("0");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "MYINT      | 7              | 50",
        "MYINT      | 16777217       | 16777216",
        "MYREAL     | 0.1            | 0.2",
        "MYBOOL     | TRUE           | FALSE",
        "MYENUM     | #EX            | #AUT",
        "MYSTRING[] | \"a\"          | \"b\"",
        "MYREALS[]  | 1.0 2.0        | 1.0 2.5",
        "MYPOS      | {X 1.0,Z 2.0}  | {X 1.0}",
        "MYINT      | 7              | ??",
      })
  void failsIfTheAnswerHasAnotherValue(String name, String value, String answer) {
    server.fault(RecordedRequest::isWrite, Fault.answer(answer, Tail.SUCCESS));

    Cli.runOn(server, "write", name, value)
        .failsInALine(1)
        .isEqualTo(
            "jopenshowvar: "
                + name
                + ": "
                + value
                + " was sent, but the answer to the write is "
                + answer
                + "; read the variable to see its value");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "MYINT      | 'HFF'          | 255",
        "MYREAL     | 0.1            | 0.100000001",
        "MYREAL     | 50             | 50.0000",
        "MYINT      | 50.0           | 50",
        "MYENUM     | #ex            | #EX",
        "MYREALS[]  | 1.0 2.0        | `1.00000 2.00000 `",
        "MYPOS      | {X 1,Z 2.5}    | {E6POS: X 1.00000, Y 0.0, Z 2.50000}",
        "MYINT      | 7              | ``",
      })
  void acceptsAnAnswerWithTheSameValueInAnotherForm(String name, String value, String answer) {
    server.enqueue(Fault.none(), Fault.answer(answer, Tail.SUCCESS));

    assertThat(Cli.runOn(server, "write", name, value).lines())
        .containsExactly(name + " = " + value);
  }

  @Test
  void saysThatTheOutcomeOfATimedOutWriteIsUnknown() {
    server.enqueue(Fault.none(), Fault.dropAnswer());

    Cli.runOn(server, "write", "--timeout", "50ms", "MYINT", "5")
        .fails(4)
        .startsWith("jopenshowvar: no answer to the write of MYINT within 50 ms")
        .contains("the outcome is unknown");
  }

  @Test
  void neverRepeatsAWriteWhoseAnswerWasLost() {
    server.enqueue(Fault.none(), Fault.closeDuring(5));

    Cli.runOn(server, "write", "MYINT", "5").fails(4).contains("the outcome is unknown");
    assertThat(server.requests()).filteredOn(RecordedRequest::isWrite).hasSize(1);
  }

  @Test
  void printsTypedJsonOfWhatItSent() {
    assertThat(Cli.runOn(server, "write", "--json", "MYFRAME", "{X 1.0,Y -2}").lines())
        .containsExactly(
            "{\"name\":\"MYFRAME\",\"type\":\"STRUC\",\"struc\":null,\"value\":{\"X\":1.0,\"Y\":-2},"
                + "\"text\":\"{X 1.0,Y -2}\"}");
  }

  @Test
  void doesNotSendWhatJsonCannotShow() {
    Cli.runOn(server, "write", "--json", "MYFRAME", "{X 1.0")
        .fails(2)
        .startsWith("jopenshowvar: VALUE is not a KRL value: ");
    assertThat(server.requestCount()).isZero();
  }

  @ParameterizedTest
  @EnumSource(
      value = OperatingMode.class,
      names = {"T2", "AUT", "EXT"})
  void doesNotWriteOutsideT1WhereNobodyCanBeAsked(OperatingMode mode) {
    server.controller().setMode(mode);

    Cli.runOn(server, "write", "MYINT", "5")
        .failsInLines(5)
        .containsExactly(
            "jopenshowvar: did not write MYINT: $MODE_OP is #"
                + mode.constant()
                + ", which needs --yes");
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void doesNotWriteWhereTheModeIsNotToBeHad() {
    server.enqueue(Fault.answer("", Tail.SUCCESS));

    Cli.runOn(server, "write", "MYINT", "5")
        .fails(5)
        .contains("$MODE_OP is unknown, which needs --yes");
    assertThat(server.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @Test
  void keepsWhatAControllerSaysFromSteeringTheTerminal() {
    server.enqueue(Fault.answer("\u001B[2J#T1", Tail.SUCCESS));

    assertThat(Cli.runOn(server, "write", "MYINT", "5").err())
        .isEqualTo(
            "jopenshowvar: did not write MYINT: $MODE_OP is \\x1B[2J#T1, which needs --yes"
                + System.lineSeparator());
  }

  @Test
  void doesNotWriteIfTheConnectionIsLostBefore() {
    server.enqueue(Fault.closeBefore());

    Cli.runOn(server, "write", "MYINT", "5")
        .fails(4)
        .contains("read of $MODE_OP")
        .doesNotContain("outcome");
    assertThat(server.requestCount()).isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"--yes", "-y"})
  void neitherReadsTheModeNorAsksIfYesIsGiven(String option) {
    server.controller().setMode(OperatingMode.AUT);

    Cli.runOn(server, "write", option, "MYINT", "5").succeeds().containsExactly("MYINT = 5");
    assertThat(server.requests()).singleElement().matches(RecordedRequest::isWrite);
  }

  @Test
  void doesNotEvenConnectIfOnlyReadingIsAllowed() {
    server.refuseConnections();

    Cli.runOn(server, "write", "--read-only", "--yes", "MYINT", "5")
        .failsInLines(5)
        .containsExactly("jopenshowvar: did not write MYINT: --read-only is given");
  }

  @Test
  void findsWrongUsageBeforeItSaysThatItIsNotAllowed() {
    assertThat(Cli.run("write", "--read-only", "--mock", "--json", "MYINT", "{").code())
        .isEqualTo(2);
  }

  @ParameterizedTest
  @ValueSource(strings = {"kukavarproxy", "c3"})
  void writesThroughBothServers(String kind) {
    assertThat(Cli.run("write", "MYINT", "7", "--mock", "--server", kind))
        .isEqualTo(new Cli.Result(0, "MYINT = 7" + System.lineSeparator(), ""));
  }
}
