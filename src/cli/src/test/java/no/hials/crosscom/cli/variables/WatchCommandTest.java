package no.hials.crosscom.cli.variables;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Writer;
import java.util.List;
import no.hials.crosscom.cli.Main;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.Tail;
import org.junit.jupiter.api.Test;

class WatchCommandTest {
  private static final String TIME = "20\\d\\d-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\\.\\d{6}Z ";

  @KukaController private MockServer server;

  private Cli.Result watch(String... args) {
    String[] all = new String[args.length + 2];
    all[0] = "--period";
    all[1] = "5ms";
    System.arraycopy(args, 0, all, 2, args.length);
    return Cli.runOn(server, "watch", all);
  }

  /** Answers the first reading, which is a test, and those of the samples. */
  private void answer(String... texts) {
    server.enqueue(Fault.answer(texts[0], Tail.SUCCESS));
    for (String text : texts) {
      server.enqueue(Fault.answer(text, Tail.SUCCESS));
    }
  }

  private static List<String> withoutTimes(Cli.Result result) {
    assertThat(result.lines()).allMatch(line -> line.matches(TIME + ".*"));
    return result.lines().stream().map(line -> line.substring(line.indexOf(' ') + 1)).toList();
  }

  @Test
  void printsALineForEachSampleOfEachVariable() {
    Cli.Result result = watch("--count", "2", "$OV_PRO", "MYFRAME");

    String frame = "MYFRAME = {FRAME: X 0.0, Y 0.0, Z 0.0, A 0.0, B 0.0, C 0.0}";
    assertThat(withoutTimes(result))
        .containsExactly("$OV_PRO = 100", frame, "$OV_PRO = 100", frame);
    result.succeeds();
  }

  @Test
  void readsAVariableOnceIfItIsNamedInDifferentCase() {
    assertThat(withoutTimes(watch("--count", "1", "$OV_PRO", "$ov_pro")))
        .containsExactly("$OV_PRO = 100");
  }

  @Test
  void printsOnlyWhatChangesIfAskedTo() {
    answer("1", "1", "1", "2", "2", "1");

    assertThat(withoutTimes(watch("--changes", "--count", "3", "MYINT")))
        .containsExactly("MYINT = 1", "MYINT = 2", "MYINT = 1");
    // the next reading may be on its way before the third line ends the command
    assertThat(server.requestCount()).isGreaterThanOrEqualTo(7);
  }

  @Test
  void tellsOnceOnStderrThatAVariableCannotBeReadAnyMore() {
    answer("1", "", "", "2");

    Cli.Result result = watch("--count", "4", "MYINT");

    assertThat(withoutTimes(result)).containsExactly("MYINT = 1", "MYINT = 2");
    assertThat(result.errLines())
        .singleElement()
        .asString()
        .startsWith("jopenshowvar: the controller refused to read MYINT");
    assertThat(result.code()).isZero();
  }

  @Test
  void endsIfAVariableCannotBeReadAtTheStart() {
    watch("MYINT", "NOPE")
        .failsInALine(1)
        .startsWith("jopenshowvar: the controller refused to read NOPE");
  }

  @Test
  void goesOnAfterALossOfTheConnection() {
    answer("1");
    server.enqueue(Fault.closeBefore(), Fault.closeBefore());

    Cli.Result result = watch("--count", "2", "MYINT");

    assertThat(withoutTimes(result)).containsExactly("MYINT = 1", "MYINT = 0");
    assertThat(result.errLines())
        .contains("jopenshowvar: connected again")
        .first()
        .asString()
        .startsWith("jopenshowvar: the connection to ");
    assertThat(result.code()).isZero();
  }

  @Test
  void printsJsonWithTheReadingsThatFailedAndWhatChanged() {
    answer("1", "1");
    server.enqueue(Fault.closeBefore(), Fault.closeBefore());
    server.enqueue(Fault.answer("#T1", Tail.SUCCESS));

    Cli.Result result = watch("--json", "--count", "3", "MYINT");

    assertThat(result.lines()).hasSize(3);
    assertThat(result.lines().get(0))
        .matches(
            "\\{\"time\":\""
                + TIME.strip()
                + "\",\"seconds\":0.000000,\"access_ms\":\\d+\\.\\d{3},"
                + "\"missed\":0,\"failed\":0,\"values\":\\{\"MYINT\":1},\"errors\":\\{},"
                + "\"changed\":\\[\"MYINT\"]}");
    assertThat(result.lines().get(1)).endsWith("\"changed\":[]}");
    assertThat(result.lines().get(2))
        .containsPattern("\"failed\":[1-9]")
        .contains("\"values\":{\"MYINT\":\"#T1\"}")
        .endsWith("\"changed\":[\"MYINT\"]}");
  }

  @Test
  void printsControlCharactersSoThatALineIsAVariable() {
    server.fault(r -> r.name().equals("MYSTRING[]"), Fault.answer("\"a\nb\"", Tail.SUCCESS));

    assertThat(withoutTimes(watch("--count", "1", "MYSTRING[]")))
        .containsExactly("MYSTRING[] = \"a\\x0Ab\"");
  }

  @Test
  void takesAnInterruptForTheEnd() throws InterruptedException {
    Thread[] watching = new Thread[1];
    int[] code = {-1};
    Thread thread =
        new Thread(
            () -> {
              code[0] =
                  Main.run(
                      Cli.argsOn(server, "watch", "MYINT"),
                      new Writer() {
                        @Override
                        public void write(char[] chars, int off, int len) {
                          watching[0].interrupt();
                        }

                        @Override
                        public void flush() {}

                        @Override
                        public void close() {}
                      },
                      Writer.nullWriter());
            });
    watching[0] = thread;

    thread.start();
    thread.join();

    assertThat(code[0]).isZero();
  }

  @Test
  void takesABlankNameForAVariableThatAShellReplaced() {
    watch("").fails(2).startsWith("jopenshowvar: a name is blank; in a shell").contains("'$");
  }

  @Test
  void saysThatTheServerCannotTakeAName() {
    watch("MY\u0100").fails(1).contains("KUKAVARPROXY");
  }
}
