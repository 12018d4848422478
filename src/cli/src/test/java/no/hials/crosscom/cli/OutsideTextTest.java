package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Values, names and answers from outside cannot control a terminal or forge a line. */
class OutsideTextTest {
  private static final String NAME = "MYSTRING[]";
  private static final String UNSAFE = "\u001B]0;x\u0007\u009B2J\r\nforged\u007F";
  private static final String SAFE = "\\x1B]0;x\\x07\\x9B2J\\x0D\\x0Aforged\\x7F";

  @TempDir private Path dir;

  @KukaController private MockServer server;

  /** Returns all output, after it was checked to have no unsafe character but line ends. */
  private static String output(Cli.Result result) {
    String all = result.out() + result.err();
    assertThat(all.lines().flatMapToInt(String::codePoints))
        .noneMatch(c -> Character.isISOControl(c) && c != '\t')
        .noneMatch(c -> c == 0x202E || c == 0x2066 || c == 0x2028);
    assertThat(all.lines()).noneMatch(line -> line.startsWith("forged"));
    return all;
  }

  /** Runs a command with a charset that has U+009B, which windows-1252 does not have. */
  private Cli.Result runInLatin1(String command, String... args) {
    return Cli.runOn(server, command + " --charset ISO-8859-1", args);
  }

  private void setUnsafe() {
    server.fault(
        request -> NAME.equals(request.name()), Fault.answer("\"" + UNSAFE + "\"", Tail.SUCCESS));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "read",
        "read -v",
        "watch --count 1",
        "watch --changes --count 1",
        "record --count 1 --out -"
      })
  void escapesValues(String command) {
    setUnsafe();

    assertThat(output(runInLatin1(command, NAME))).contains(SAFE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"read --json", "watch --json --count 1"})
  void escapesValuesInJson(String command) {
    setUnsafe();

    assertThat(output(runInLatin1(command, NAME)))
        .contains("\\u001B]0;x\\u0007\\u009B2J\\r\\nforged\\u007F");
  }

  @Test
  void printsAValueExactlyIfAsked() {
    setUnsafe();

    assertThat(runInLatin1("read", "--raw", NAME).out())
        .isEqualTo(NAME + " = \"" + UNSAFE + "\"" + System.lineSeparator());
    assertThat(runInLatin1("read", "--raw", "--json", NAME).fails(2).actual())
        .startsWith("jopenshowvar: --raw and --json exclude each other");
  }

  @Test
  void escapesTheEchoOfAWrite() {
    String output = output(Cli.runOn(server, "write", NAME, "\"a\u001B[2J\u007F\"", "--yes"));

    assertThat(output).startsWith(NAME + " = \"a\\x1B[2J\\x7F\"");
  }

  @Test
  void escapesNamesInMessages() {
    assertThat(output(runInLatin1("read", "A" + UNSAFE)))
        .startsWith(
            "jopenshowvar: a variable's name must not have a line break or NUL, has U+000D at index"
                + " 10: A"
                + SAFE);
  }

  @Test
  void escapesAMessageThatQuotesTheController() {
    server.faults(request -> Optional.of(Fault.answer(UNSAFE, Tail.SUCCESS)));

    assertThat(output(runInLatin1("watch", "-v", "--count", "1", NAME))).contains(SAFE);
    assertThat(output(runInLatin1("info"))).contains(SAFE);
  }

  @Test
  void escapesPathsOfThisComputer() throws IOException {
    Path local = dir.resolve("a\u001B[2J\u202E.src");
    try (MockServer bridge = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      bridge.files().put("KRC:\\R1\\PROGRAM\\A.SRC", "DEF A ( )\nEND\n");

      Cli.Result got = Cli.runOn(bridge, "file get", "/R1/A.SRC", local.toString());
      Cli.Result json =
          Cli.runOn(bridge, "file get", "/R1/A.SRC", local.toString(), "--yes", "--json");
      Cli.Result put = Cli.runOn(bridge, "file put", local.toString(), "/R1/B.SRC", "--yes");

      assertThat(output(got)).contains("a\\x1B[2J\\u202E.src, 14 bytes");
      assertThat(output(json)).contains("a\\u001B[2J\\u202E.src");
      assertThat(output(put)).contains("a\\x1B[2J\\u202E.src -> /R1/B.SRC");
    }
  }

  @Test
  void escapesTheTextOfAScriptAndItsErrors() throws IOException {
    Path script = dir.resolve("a.jov");
    Files.writeString(script, NAME + " = \"\u001B[2J\u202E\"\n");

    assertThat(output(Cli.run("run", "--dry-run", script.toString())))
        .contains(NAME + " = \"\\x1B[2J\\u202E\"");
    assertThat(output(Cli.runOn(server, "run", script.toString(), "--yes")))
        .contains("\\x1B[2J\\u202E");
  }

  @ParameterizedTest
  @CsvSource({"--json", "-v"})
  void escapesAnAnswerByUdp(String option) throws IOException {
    String answer = "KUKA|\"KR6" + UNSAFE + "\"|\"1\u202E\"";
    try (DatagramSocket answerer = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      Thread thread = new Thread(() -> answer(answerer, answer));
      thread.start();
      String ports = answerer.getLocalPort() + "," + answerer.getLocalPort() + ",0";

      Cli.Result result =
          Cli.run(
              "discover",
              option,
              "--no-legacy",
              "--timeout",
              "300ms",
              "--address",
              "127.0.0.1",
              "--ports",
              ports);

      assertThat(output(result)).contains(option.equals("-v") ? SAFE : "\\u001B]0;x");
    }
  }

  private static void answer(DatagramSocket socket, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    DatagramPacket question = new DatagramPacket(new byte[1000], 1000);
    try {
      for (; ; ) {
        socket.receive(question);
        socket.send(new DatagramPacket(bytes, bytes.length, question.getSocketAddress()));
      }
    } catch (IOException e) {
      // the socket is closed: the test is over
    }
  }

  @Test
  void escapesTheErrorsOfAKrlFile() throws IOException {
    Path program = dir.resolve("BAD.SRC");
    Files.writeString(program, "DEF BAD ( )\n  X = \u001B[2J\u009B\nEND\n");

    Cli.Result result = Cli.run("mock", "--port", "0", "--strict", "--program", program.toString());

    assertThat(result.errLines()).hasSizeGreaterThan(1);
    assertThat(List.of(output(result))).allMatch(text -> text.contains("BAD.SRC"));
  }
}
