package no.hials.crosscom.cli.variables;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.io.Writer;
import no.hials.crosscom.cli.Main;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Tail;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReadCommandTest {
  @KukaController private MockServer server;

  @Test
  void printsNameAndValueOfEachVariableInTheOrderAsked() {
    Cli.Result result =
        Cli.runOn(server, "read", "$OV_PRO", "$POS_ACT", "$MODEL_NAME[]", "$MODE_OP", "$OV_PRO");

    result
        .succeeds()
        .containsExactly(
            "$OV_PRO = 100",
            "$POS_ACT = {E6POS: X 525.000, Y 0.0, Z 890.000, A 0.0, B 90.0000, C 0.0, S 2, T 2,"
                + " E1 0.0, E2 0.0, E3 0.0, E4 0.0, E5 0.0, E6 0.0}",
            "$MODEL_NAME[] = \"#KR6R900 C4SR FLR 230\"",
            "$MODE_OP = #T1",
            "$OV_PRO = 100");
  }

  @Test
  void printsTheValueExactlyAsTheControllerPrintedIt() {
    server.enqueue(
        Fault.answer("{X 1.5,  Y .5,B TRUE }", Tail.SUCCESS),
        Fault.answer("1 2 3 ", Tail.SUCCESS),
        Fault.answer("no KRL value: }", Tail.SUCCESS));

    assertThat(Cli.runOn(server, "read", "A", "B", "C").lines())
        .containsExactly("A = {X 1.5,  Y .5,B TRUE }", "B = 1 2 3 ", "C = no KRL value: }");
  }

  @Test
  void takesOptionsBehindTheNames() {
    Cli.Result result =
        Cli.run(
            "read",
            "myint",
            "--port",
            "" + server.port(),
            "--timeout",
            "5s",
            "--host",
            "127.0.0.1");

    assertThat(result).isEqualTo(new Cli.Result(0, "myint = 0" + System.lineSeparator(), ""));
  }

  @Test
  void readsFromASimulatedControllerOfItsOwn() {
    Cli.run("read", "$OV_PRO", "--mock").succeeds().containsExactly("$OV_PRO = 100");
    assertThat(server.requestCount()).isZero();
  }

  @Test
  void readsTheOthersIfOneIsRefused() {
    Cli.Result result = Cli.runOn(server, "read", "$OV_PRO", "NOPE", "MYINT");

    assertThat(result.lines()).containsExactly("$OV_PRO = 100", "MYINT = 0");
    assertThat(result.errLines())
        .singleElement()
        .asString()
        .startsWith("jopenshowvar: the controller refused to read NOPE");
    assertThat(result.code()).isEqualTo(1);
  }

  @Test
  void endsWhenTheConnectionIsLost() {
    server.enqueue(Fault.none(), Fault.closeBefore());

    Cli.Result result = Cli.runOn(server, "read", "MYINT", "MYREAL", "MYBOOL", "MYCHAR");

    assertThat(result.lines()).containsExactly("MYINT = 0");
    assertThat(result.errLines()).hasSize(2);
    assertThat(result.errLines().get(0)).startsWith("jopenshowvar: ").contains("read of MYREAL");
    assertThat(result.errLines().get(1)).isEqualTo("not read: MYREAL MYBOOL MYCHAR");
    assertThat(result.code()).isEqualTo(4);
    assertThat(server.requestCount()).isEqualTo(2);
  }

  @Test
  void endsWithTheCodeOfTheGravestFailure() {
    server.enqueue(Fault.none(), Fault.closeBefore());

    assertThat(Cli.runOn(server, "read", "NOPE", "MYINT").code()).isEqualTo(4);
  }

  @Test
  void endsWithTheCodeOfTheGravestFailureThoughALesserOneFollows() {
    Cli.Result result = Cli.runOn(server, "read", "MY\u0100", "NOPE", "MYINT");

    assertThat(result.lines()).containsExactly("MYINT = 0");
    assertThat(result.errLines()).hasSize(2).allMatch(line -> line.startsWith("jopenshowvar: "));
    assertThat(result.code()).isEqualTo(2);
  }

  @Test
  void saysThatTheServerSpeaksAnotherProtocol() {
    server.enqueue(Fault.raw("48 54 54 50 2F 31 2E 31 20 34 30 30 0D 0A"));

    Cli.runOn(server, "read", "MYINT", "--timeout", "200ms")
        .fails(4)
        .contains(" answered with HTTP (HTTP/1.1 400), not KUKAVARPROXY or C3 Bridge")
        .doesNotContain("48 54 54 50");
  }

  @Test
  void saysThatNoAnswerCame() {
    server.enqueue(Fault.drop());

    Cli.runOn(server, "read", "MYINT", "--timeout", "50")
        .failsInALine(4)
        .startsWith("jopenshowvar: no answer to the read of MYINT within 50 ms");
  }

  @Test
  void saysThatNobodyListens() {
    server.refuseConnections();

    Cli.runOn(server, "read", "MYINT")
        .failsInALine(3)
        .startsWith("jopenshowvar: could not connect to 127.0.0.1:" + server.port());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "$OV_PRO            | `INT`, `value`:100",
        "MYREAL             | `REAL`, `value`:0.0",
        "MYBOOL             | `BOOL`, `value`:false",
        "MYCHAR             | `CHAR`, `value`:`A`",
        "MYSTRING[]         | `CHAR[]`, `value`:` `",
        "$MODEL_NAME[]      | `CHAR[]`, `value`:`#KR6R900 C4SR FLR 230`",
        "$MODE_OP           | `ENUM`, `value`:`#T1`",
        "MYINTS[]           | `INT[]`, `value`:[0,0,0,0,0,0,0,0,0,0]",
        "MYREALS[3]         | `REAL`, `value`:0.0",
        "MYBOOLS[]          | `BOOL[]`, `value`:[false,false,false,false,false,false,false,false,"
            + "false,false]",
        "MYFRAME            | `STRUC`, `struc`:`FRAME`, `value`:{`X`:0.0,`Y`:0.0,`Z`:0.0,`A`:0.0,"
            + "`B`:0.0,`C`:0.0}",
        "$DATE              | `STRUC`, `struc`:`DATE`, `value`:{`CSEC`:0,`SEC`:30,`MIN`:15,"
            + "`HOUR`:10,`DAY`:14,`MONTH`:3,`YEAR`:2014}"
      })
  void printsTypedJson(String name, String rest) {
    Cli.Result result = Cli.runOn(server, "read", "--json", name);

    String expected = "{'name':'" + name + "','type':" + rest.replace(", `", ",`") + ",'text':";
    result
        .succeeds()
        .singleElement()
        .asString()
        .startsWith(expected.replace('\'', '"').replace('`', '"'));
  }

  @Test
  void printsNumbersInJsonAndTheTextOfTheController() {
    server.variables().set("MYREAL", "3.5");
    server.variables().set("MYFRAME", "{X -2.5}");

    assertThat(Cli.runOn(server, "read", "--json", "MYREAL", "MYFRAME").lines())
        .containsExactly(
            "{\"name\":\"MYREAL\",\"type\":\"REAL\",\"value\":3.5,\"text\":\"3.50000\"}",
            "{\"name\":\"MYFRAME\",\"type\":\"STRUC\",\"struc\":\"FRAME\",\"value\":{\"X\":-2.5,"
                + "\"Y\":0.0,\"Z\":0.0,\"A\":0.0,\"B\":0.0,\"C\":0.0},\"text\":\"{FRAME: X"
                + " -2.50000, Y 0.0, Z 0.0, A 0.0, B 0.0, C 0.0}\"}");
  }

  @Test
  void printsOneJsonObjectALine() {
    Cli.Result result = Cli.runOn(server, "read", "--json", "MYINT", "NOPE", "MYBOOL");

    assertThat(result.lines())
        .containsExactly(
            "{\"name\":\"MYINT\",\"type\":\"INT\",\"value\":0,\"text\":\"0\"}",
            "{\"name\":\"MYBOOL\",\"type\":\"BOOL\",\"value\":false,\"text\":\"FALSE\"}");
    assertThat(result.code()).isEqualTo(1);
  }

  @Test
  void printsWhatIsNoKrlValueAsAStringOfTypeUnknown() {
    server.enqueue(Fault.answer("?? \"what\"", Tail.SUCCESS));

    Cli.Result result = Cli.runOn(server, "read", "--json", "MYPOS", "PING", "MYINT");

    assertThat(result.code()).isZero();
    assertThat(result.out().lines())
        .containsExactly(
            "{\"name\":\"MYPOS\",\"type\":\"UNKNOWN\",\"value\":\"?? \\\"what\\\"\","
                + "\"text\":\"?? \\\"what\\\"\"}",
            "{\"name\":\"PING\",\"type\":\"UNKNOWN\",\"value\":\"PONG\",\"text\":\"PONG\"}",
            "{\"name\":\"MYINT\",\"type\":\"INT\",\"value\":0,\"text\":\"0\"}");
  }

  @Test
  void printsControlCharactersSoThatALineIsAVariable() {
    server.enqueue(Fault.answer("\"a\nb\u001b[31m\"", Tail.SUCCESS));

    Cli.Result result = Cli.runOn(server, "read", "MYSTRING[]");

    assertThat(result.out()).isEqualTo("MYSTRING[] = \"a\\x0Ab\\x1B[31m\"\n");
  }

  @Test
  void showsAStackTraceOnlyIfAskedFor() {
    assertThat(Cli.runOn(server, "read", "--verbose", "NOPE").err())
        .startsWith("jopenshowvar: the controller refused")
        .contains("\tat no.hials.crosscom.");
    assertThat(Cli.runOn(server, "read", "NOPE").err()).doesNotContain("\tat ");
  }

  @Test
  void stopsQuietlyWhenNobodyReadsTheOutput() {
    StringWriter err = new StringWriter();

    int code = Main.run(read("MYINT", "MYREAL"), new FailingWriter("Broken pipe"), err);

    assertThat(err.toString()).isEmpty();
    assertThat(code).isEqualTo(74);
    assertThat(server.requestCount()).isEqualTo(1);
  }

  @Test
  void saysThatTheOutputCannotBeWritten() {
    StringWriter err = new StringWriter();

    int code = Main.run(read("MYINT"), new FailingWriter("No space left on device"), err);

    assertThat(err.toString().lines())
        .containsExactly("jopenshowvar: could not write the output: No space left on device");
    assertThat(code).isEqualTo(74);
  }

  private String[] read(String... names) {
    return Cli.argsOn(server, "read", names);
  }

  /** Fails as soon as something has to leave it. */
  private static final class FailingWriter extends Writer {
    private final String message;

    FailingWriter(String message) {
      this.message = message;
    }

    @Override
    public void write(char[] chars, int off, int len) {
      // as if it were kept in a buffer
    }

    @Override
    public void flush() throws IOException {
      throw new IOException(message);
    }

    @Override
    public void close() {}
  }
}
