package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThatCode;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.CyclicBarrier;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.RecordedRequest;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.OperatingMode;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Robots with names, and the environment. */
class ProfilesTest {
  @TempDir private Path dir;
  @KukaController private MockServer one;
  @KukaController private MockServer two;
  private final Map<String, String> environment = new HashMap<>();

  @BeforeEach
  void start() {
    one.variables().set("MYINT", "1");
    two.variables().set("MYINT", "2");
  }

  /** Writes the configuration file, and names it to the program. */
  private Path config(String... lines) throws IOException {
    Path file = Files.write(dir.resolve("robots.toml"), List.of(lines));
    environment.put("JOPENSHOWVAR_CONFIG", file.toString());
    return file;
  }

  private static String robot(String name, MockServer server, String... more) {
    return "[robots."
        + name
        + "]\nhost = \""
        + server.host()
        + "\"\nport = "
        + server.port()
        + "\n"
        + String.join("\n", more);
  }

  private Cli.Result run(String... args) {
    return Cli.runIn(environment, args);
  }

  @Test
  void aRobotBeforeHelpDoesNotMatter() throws IOException {
    config(robot("cell1", one));
    assertThat(run("@cell1", "help").lines()).isEqualTo(run("help").lines());
    assertThat(run("@cell1", "help", "read").lines()).isEqualTo(run("help", "read").lines());
  }

  @Test
  void readsFromARobotByItsName() throws IOException {
    config(robot("cell1", one), robot("'cell-2.a'", two));

    assertThat(run("read", "@cell1", "MYINT").lines()).containsExactly("MYINT = 1");
    assertThat(run("read", "MYINT", "@cell-2.a").lines()).containsExactly("MYINT = 2");
    assertThat(run("read", "MYINT", "--robot", "cell1").lines()).containsExactly("MYINT = 1");
  }

  @Test
  void takesARobotBeforeTheCommand() throws IOException {
    config(robot("cell1", one), robot("cell2", two));

    assertThat(run("@cell2", "read", "MYINT").lines()).containsExactly("MYINT = 2");
    assertThat(run("@cell1", "@cell2", "read", "MYINT").lines())
        .containsExactly("cell1: MYINT = 1", "cell2: MYINT = 2");
    assertThat(run("@cell1", "write", "--", "MYINT", "-5").lines()).containsExactly("MYINT = -5");
  }

  @Test
  void takesARobotBeforeACommandOfAGroup() throws IOException {
    try (MockServer bridge = MockServer.start(cfg -> cfg.server(ServerType.C3_BRIDGE))) {
      config(robot("cell1", bridge));

      assertThat(run("@cell1", "file", "ls", "KRC:\\").code()).isZero();
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "@a read @b MYINT     | @a stands before the command, and another robot after it",
        "@a read @a MYINT     | @a stands before the command, and another robot after it",
        "@a read MYINT --host h | --host and @a exclude each other",
        "@a @a read MYINT     | @a is given twice",
        "@a mock              | this command takes no robot: @a",
        "mock @a              | this command takes no robot: @a",
        "@a raed MYINT        | unknown command: 'raed'"
      })
  void refusesASecondPlaceForTheRobot(String arguments, String message) throws IOException {
    config(robot("a", one), robot("b", two));

    run(arguments.split(" ")).fails(2).startsWith("jopenshowvar: " + message);
  }

  @Test
  void takesAFileThatBeginsWithAByteOrderMark() throws IOException {
    config("\uFEFF" + robot("cell1", one));

    assertThat(run("read", "@cell1", "MYINT").lines()).containsExactly("MYINT = 1");
  }

  @Test
  void readsFromTheDefaultRobotIfNoneIsNamed() throws IOException {
    config("default = \"cell2\"", robot("cell1", one), robot("cell2", two));

    assertThat(run("read", "MYINT").lines()).containsExactly("MYINT = 2");
  }

  @Test
  void takesTheMostExplicitOfWhatNamesAController() throws IOException {
    environment.put("JOPENSHOWVAR_HOST", one.host());
    environment.put("JOPENSHOWVAR_PORT", "" + one.port());
    config("default = \"cell2\"", robot("cell2", two));

    assertThat(run("read", "MYINT").lines()).containsExactly("MYINT = 1");
    assertThat(run("read", "MYINT", "@cell2").lines()).containsExactly("MYINT = 2");
    assertThat(run("read", "MYINT", "--mock").lines()).containsExactly("MYINT = 0");
    assertThat(Cli.runIn(environment, Cli.argsOn(two, "read", "MYINT")).lines())
        .containsExactly("MYINT = 2");
    assertThat(run("read", "MYINT", "--port", "" + two.port()).lines())
        .containsExactly("MYINT = 2");
    assertThat(run("read", "MYINT", "@cell2", "--port", "" + one.port()).lines())
        .containsExactly("MYINT = 1");
  }

  @Test
  void takesThePortAfterTheHost() throws IOException {
    String address = one.host() + ":" + one.port();
    assertThat(run("read", "MYINT", "--host", address).lines()).containsExactly("MYINT = 1");
    assertThat(run("read", "MYINT", "--host", address, "--port", "" + one.port()).lines())
        .containsExactly("MYINT = 1");
    assertThat(run("read", "MYINT", "--host", "localhost:" + two.port()).lines())
        .containsExactly("MYINT = 2");

    environment.put("JOPENSHOWVAR_HOST", address);
    assertThat(run("read", "MYINT").lines()).containsExactly("MYINT = 1");

    config("[robots.cell2]", "host = \"" + two.host() + ":" + two.port() + "\"");
    assertThat(run("read", "@cell2", "MYINT").lines()).containsExactly("MYINT = 2");
  }

  @Test
  void takesThePortAfterAnAddressOfIpv6() throws Exception {
    byte[] address = new byte[16];
    address[15] = 1;
    InetAddress loopback = InetAddress.getByAddress(address);
    assumeThatCode(() -> new ServerSocket(0, 1, loopback).close()).doesNotThrowAnyException();
    try (MockServer six = MockServer.start(cfg -> cfg.bindAddress(loopback))) {
      assertThat(run("read", "MYINT", "--host", "[::1]:" + six.port()).lines())
          .containsExactly("MYINT = 0");
    }
  }

  @Test
  void refusesTwoDifferentPorts() {
    run("read", "MYINT", "--host", "127.0.0.1:7", "--port", "8")
        .fails(2)
        .startsWith(
            "jopenshowvar: invalid value for option '--host': names the port 7, but the port is set"
                + " to 8");
    environment.put("JOPENSHOWVAR_HOST", "h:7");
    environment.put("JOPENSHOWVAR_PORT", "8");
    run("read", "MYINT")
        .fails(2)
        .startsWith("jopenshowvar: JOPENSHOWVAR_HOST names the port 7, but the port is set to 8");
  }

  @Test
  void takesTheMostExplicitTimeout() throws IOException {
    one.faults(request -> Optional.of(Fault.drop()));
    config(
        "default = \"slow\"",
        robot("slow", one, "timeout = \"43ms\""),
        robot("number", one, "timeout = 44"),
        robot("plain", one));
    assertThat(run("read", "MYINT").err()).contains("within 43 ms");

    environment.put("JOPENSHOWVAR_TIMEOUT", "45");

    assertThat(run("read", "MYINT").err()).contains("within 45 ms");
    assertThat(run("read", "MYINT", "@plain").err()).contains("within 45 ms");
    assertThat(run("read", "MYINT", "@number").err()).contains("within 44 ms");
    assertThat(run("read", "MYINT", "@number", "--timeout", "46").err()).contains("within 46 ms");
    assertThat(Cli.runIn(environment, Cli.argsOn(one, "read", "MYINT")).err())
        .contains("within 45 ms");
  }

  @Test
  void simulatesARobotThatTheFileSaysIsSimulated() throws IOException {
    config("[robots.sim]", "mock = true", "server = \"c3\"", "[robots.old]", "mock = true");

    assertThat(run("read", "@sim", "@PROXY_TYPE", "MYINT").code()).isEqualTo(2);
    assertThat(run("read", "@sim", "--", "@PROXY_TYPE").lines())
        .containsExactly("@PROXY_TYPE = C3 BRIDGE INTERFACE");
    assertThat(run("read", "@old", "--", "@PROXY_TYPE").code()).isEqualTo(1);
    assertThat(run("read", "@old", "--server", "c3", "--", "@PROXY_TYPE").code()).isZero();
  }

  @Test
  void doesNotAskARobotForTheTypeThatTheFileSays() throws IOException {
    config(robot("a", one) + "\nserver = 'kukavarproxy'");

    assertThat(run("info", "@a").out()).contains("KUKAVARPROXY");
    assertThat(one.requests())
        .extracting(RecordedRequest::name)
        .isNotEmpty()
        .doesNotContain("@PROXY_TYPE");
  }

  @Test
  void readsFromSeveralRobotsInTheOrderGiven() throws IOException {
    config(robot("cell1", one), robot("cell2", two));

    run("read", "@cell2", "@cell1", "MYINT", "MYBOOL")
        .succeeds()
        .containsExactly(
            "cell2: MYINT = 2",
            "cell2: MYBOOL = FALSE",
            "cell1: MYINT = 1",
            "cell1: MYBOOL = FALSE");
  }

  @Test
  void namesTheRobotInJsonIfThereAreSeveral() throws IOException {
    config(robot("cell1", one), robot("cell2", two));

    assertThat(run("read", "--json", "@cell1", "@cell2", "MYINT").lines())
        .containsExactly(
            "{\"robot\":\"cell1\",\"name\":\"MYINT\",\"type\":\"INT\",\"value\":1,\"text\":\"1\"}",
            "{\"robot\":\"cell2\",\"name\":\"MYINT\",\"type\":\"INT\",\"value\":2,\"text\":\"2\"}");
    assertThat(run("read", "--json", "@cell1", "MYINT").lines())
        .containsExactly("{\"name\":\"MYINT\",\"type\":\"INT\",\"value\":1,\"text\":\"1\"}");
  }

  @Test
  void asksSeveralRobotsAtTheSameTime() throws Exception {
    config(robot("cell1", one), robot("cell2", two));
    // each answers only when the other was asked, too
    CyclicBarrier both = new CyclicBarrier(2);
    for (MockServer server : List.of(one, two)) {
      server.faults(
          request -> {
            try {
              both.await();
            } catch (InterruptedException | BrokenBarrierException e) {
              throw new IllegalStateException(e);
            }
            return Optional.empty();
          });
    }

    assertThat(run("read", "@cell1", "@cell2", "MYINT").lines())
        .containsExactly("cell1: MYINT = 1", "cell2: MYINT = 2");
  }

  @Test
  void printsTheOtherRobotsIfOneFails() throws IOException {
    MockServer gone = MockServer.start();
    try {
      gone.refuseConnections();
      config(robot("gone", gone), robot("cell1", one), robot("cell2", two));
      two.enqueue(Fault.none(), Fault.closeBefore());

      Cli.Result result = run("read", "@gone", "@cell1", "@cell2", "NOPE", "MYINT", "MYBOOL");

      assertThat(result.lines()).containsExactly("cell1: MYINT = 1", "cell1: MYBOOL = FALSE");
      assertThat(result.errLines()).hasSize(5);
      assertThat(result.errLines().get(0)).startsWith("jopenshowvar: gone: could not connect to ");
      assertThat(result.errLines().get(1))
          .startsWith("jopenshowvar: cell1: the controller refused to read NOPE");
      assertThat(result.errLines().get(2))
          .startsWith("jopenshowvar: cell2: the controller refused to read NOPE");
      assertThat(result.errLines().get(3)).contains("cell2: ").contains("read of MYINT");
      assertThat(result.errLines().get(4)).isEqualTo("cell2: not read: MYINT MYBOOL");
      assertThat(result.code()).isEqualTo(4);
    } finally {
      gone.close();
    }
  }

  @Test
  void writesToOneRobotAtATime() throws IOException {
    config(robot("cell1", one), robot("cell2", two));

    assertThat(run("write", "@cell1", "MYINT", "5").lines()).containsExactly("MYINT = 5");
    run("write", "@cell1", "@cell2", "MYINT", "6")
        .fails(2)
        .startsWith("jopenshowvar: this command takes one robot, 2 are given");
    assertThat(one.variables().get("MYINT")).isEqualTo("5");
    assertThat(two.requestCount()).isZero();
  }

  @Test
  void refusesToWriteToARobotThatIsForReadingOnly() throws IOException {
    config("default = \"cell1\"", robot("cell1", one, "read-only = true"));
    environment.put("JOPENSHOWVAR_READ_ONLY", "false");

    for (List<String> name : List.of(List.of("@cell1"), List.<String>of())) {
      Cli.Result result =
          run(
              Stream.concat(Stream.of("write", "--yes", "MYINT", "5"), name.stream())
                  .toArray(String[]::new));

      result
          .fails(5)
          .startsWith("jopenshowvar: cell1: did not write MYINT: ")
          .contains("read-only = true in " + environment.get("JOPENSHOWVAR_CONFIG") + ":");
    }
    assertThat(run("read", "MYINT").lines()).containsExactly("MYINT = 1");
    assertThat(one.requests()).noneMatch(RecordedRequest::isWrite);
  }

  @ParameterizedTest
  @ValueSource(strings = {"true", "TRUE", "1"})
  void refusesToWriteAnywhereIfTheEnvironmentSaysSo(String value) throws IOException {
    config(robot("cell1", one, "read-only = false"));
    environment.put("JOPENSHOWVAR_READ_ONLY", value);

    assertThat(run("write", "--yes", "@cell1", "MYINT", "5").code()).isEqualTo(5);
    assertThat(run("write", "--yes", "--mock", "MYINT", "5").code()).isEqualTo(5);
    assertThat(one.requestCount()).isZero();
  }

  @Test
  void saysWhichRobotItDidNotWriteTo() throws IOException {
    config(robot("cell1", one));
    one.controller().setMode(OperatingMode.AUT);

    run("write", "@cell1", "MYINT", "5")
        .failsInLines(5)
        .containsExactly(
            "jopenshowvar: cell1: did not write MYINT: $MODE_OP is #AUT, which needs --yes");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "hots = 'a'             | :2: robots.a.hots: no such key; known: host, port, timeout,",
        "port = 7000            | :1: robots.a: a robot needs a host, or mock = true",
        "host = ' '             | :2: robots.a.host: must be HOST, HOST:PORT or [IPV6]:PORT, is ' '",
        "host = 'h:0'           | :2: robots.a.host: the port must be 1 to 65535, is 0",
        "host = 'h:7'~port = 8  | :2: robots.a.host: names the port 7, but the port is set to 8",
        "host = 7               | :2: robots.a.host: must be a text in quotes",
        "host = ['h']           | :2: robots.a.host: must be a text in quotes",
        "port = '7000'          | :2: robots.a.port: must be a whole number, without quotes",
        "port = 1.5             | :2: robots.a.port: must be a whole number, without quotes",
        "port = 65536           | :2: robots.a.port: must be 1 to 65535, is 65536",
        "port = 99999999999999999999 | :2: robots.a.port: must be 1 to 65535",
        "timeout = true         | :2: robots.a.timeout: must be a text in quotes such as",
        "timeout = 1.5          | :2: robots.a.timeout: must be a text in quotes such as \"1.5s\", or",
        "host='h'~host='i'~~#   | :3: invalid TOML: Duplicate key",
        "host='h'~host='i'      | :3: invalid TOML: Duplicate key",
        "timeout = '3h'         | :2: robots.a.timeout: must be like 500, 500ms, 3s or 1m, is 3h",
        "read-only = 'yes'      | :2: robots.a.read-only: must be true or false, without quotes",
        "mock = 1               | :2: robots.a.mock: must be true or false, without quotes",
        "server = 'c4'          | :2: robots.a.server: must be kukavarproxy or c3, is c4",
        "'read only' = true     | :2: robots.a.read only: no such key",
        "mock.server = 'c3'     | :2: robots.a.mock: must be true or false",
        "host =                 | :2: invalid TOML: ",
      })
  void saysWhereTheFileIsWrong(String line, String message) throws IOException {
    Path file = config("[robots.a]", line.replace('~', '\n'));

    run("read", "MYINT", "@a").fails(2).startsWith("jopenshowvar: " + file + message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "defualt = 'a'                  | :2: defualt: no such key; known: default, robots",
        "default = 'b'                  | :2: default: no robot is named b; known: a",
        "default = 1                    | :2: default: must be a text in quotes",
        "robots = 1                     | :2: robots: must be a table",
        "robots.b = 1                   | :2: robots.b: must be a table",
        "robots.b = { hots = 'h' }      | :2: robots.b.hots: no such key",
        "robots.b.hots = 'h'            | :2: robots.b.hots: no such key",
        "[robots.'b c']                 | :2: robots.b c: a robot's name must be letters, digits",
        "[robots.b]~mock=true~host='h'  | :2: robots.b: mock excludes host and port",
        "[robot.b]                      | :2: robot: no such key; known: default, robots",
      })
  void saysWhereTheFileIsWrongOutsideTheRobotThatIsAsked(String lines, String message)
      throws IOException {
    String rest = lines.startsWith("robots = ") ? "" : "[robots.a]\nhost = 'h'";
    Path file =
        lines.startsWith("[")
            ? config(" # robots", lines.replace('~', '\n'), rest)
            : config(" # robots", lines, rest);

    run("read", "MYINT", "@a").fails(2).startsWith("jopenshowvar: " + file + message);
  }

  @Test
  void refusesTwoNamesThatDifferOnlyInCase() throws IOException {
    Path file = config(robot("a", one), "[robots.b]", "mock = true", robot("A", two));

    run("read", "MYINT", "@a")
        .fails(2)
        .startsWith(
            "jopenshowvar: "
                + file
                + ":7: robots.A: the name differs only in case from a in "
                + file
                + ":1");
  }

  @Test
  void takesTheFileThatTheDocumentationShows() throws IOException {
    String page = Files.readString(Path.of("..", "..", "docs", "how-to", "name-your-robots.md"));
    int start = page.indexOf("```toml") + "```toml".length();
    config(page.substring(start, page.indexOf("```", start)));

    assertThat(run("read", "@sim", "--", "@PROXY_TYPE").code()).isZero();
    assertThat(run("write", "--yes", "MYINT", "5").err()).contains("cell1: did not write MYINT");
  }

  @Test
  void saysWhichRobotsThereAre() throws IOException {
    Path file = config(robot("cell2", two), robot("cell1", one));

    assertThat(run("read", "MYINT", "@cell1", "@cell3").errLines())
        .containsExactly(
            "jopenshowvar: " + file + ": no robot is named cell3; known: cell1, cell2");
    assertThat(one.requestCount()).isZero();
  }

  @Test
  void saysThatThereIsNoFile() {
    Path file = dir.resolve("jopenshowvar").resolve("config.toml");
    environment.put("XDG_CONFIG_HOME", dir.toString());
    environment.put("APPDATA", dir.toString());

    run("read", "MYINT", "@cell1")
        .failsInLines(2)
        .containsExactly("jopenshowvar: no robot is named cell1: there is no " + file);
    assertThat(run("read", "MYINT").err())
        .startsWith("jopenshowvar: which controller? give --host")
        .doesNotContain(file.toString());
  }

  @Test
  void saysThatTheFileOfTheEnvironmentIsNotThere() {
    environment.put("JOPENSHOWVAR_CONFIG", dir.resolve("gone.toml").toString());

    run("read", "MYINT")
        .fails(2)
        .startsWith("jopenshowvar: cannot read " + dir.resolve("gone.toml"))
        .contains("JOPENSHOWVAR_CONFIG")
        .contains("file not found");
  }

  @Test
  void saysThatTheFileIsNotUtf8() throws IOException {
    Path file = config();
    Files.write(file, new byte[] {'#', (byte) 0xFC});

    assertThat(run("read", "MYINT", "@a").errLines())
        .containsExactly("jopenshowvar: cannot read " + file + ": it must be UTF-8");
  }

  @Test
  void findsTheFileWhereTheUsersConfigurationIs() throws IOException {
    Path folder = Files.createDirectories(dir.resolve("jopenshowvar"));
    Files.writeString(folder.resolve("config.toml"), robot("cell1", one));
    environment.put("XDG_CONFIG_HOME", dir.toString());
    environment.put("APPDATA", dir.toString());

    assertThat(run("read", "MYINT", "@cell1").lines()).containsExactly("MYINT = 1");
  }

  @Test
  void doesNotReadTheFileForAControllerThatIsGiven() throws IOException {
    config("no TOML");

    assertThat(run("read", "MYINT", "--mock").code()).isZero();
    assertThat(Cli.runIn(environment, Cli.argsOn(one, "read", "MYINT")).code()).isZero();
  }

  @Test
  void theCharsetOfKukavarproxyIsThatOfTheRobotOrTheOption() throws Exception {
    try (MockServer cyrillic = MockServer.start(cfg -> cfg.codePage(1251))) {
      cyrillic.variables().set("MYSTRING[]", "\"Привет\"");
      config(robot("ru", cyrillic) + "\ncharset = \"windows-1251\"", robot("a", cyrillic));

      String[] charset = {"read", "@a", "MYSTRING[]", "--charset", "windows-1251"};
      for (Cli.Result result : List.of(run("read", "@ru", "MYSTRING[]"), run(charset))) {
        assertThat(result.lines()).containsExactly("MYSTRING[] = \"Привет\"");
      }
    }
    run("read", "@a", "MYINT", "--charset", "windows-7")
        .fails(2)
        .contains("must be a charset such as windows-1251, is windows-7");
    run("read", "@a", "MYINT", "--charset", "UTF-16")
        .fails(2)
        .contains("charset must have ASCII in the same bytes, is UTF-16");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--host h @a         | --host and @a exclude each other",
        "--mock @a           | --mock and @a exclude each other",
        "@a @b @a            | @a is given twice",
        "@sim --port 7000    | --port goes with --host",
        "@a --server c3      | --server goes with --mock",
      })
  void refusesWhatContradictsItself(String options, String message) throws IOException {
    config(robot("a", one), robot("b", two), "[robots.sim]\nmock = true");

    run(("read MYINT " + options).split(" ")).fails(2).startsWith("jopenshowvar: " + message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "JOPENSHOWVAR_PORT      | 0     | must be 1 to 65535, is 0",
        "JOPENSHOWVAR_TIMEOUT   | x     | must be like 500, 500ms, 3s or 1m, is x",
        "JOPENSHOWVAR_READ_ONLY | maybe | must be true or false, is maybe",
        "JOPENSHOWVAR_PORT      | 7000  | goes with JOPENSHOWVAR_HOST",
      })
  void saysWhichVariableOfTheEnvironmentIsWrong(String name, String value, String message) {
    environment.put(name, value);

    run("read", "MYINT", "--mock").fails(2).startsWith("jopenshowvar: " + name + " " + message);
  }
}
