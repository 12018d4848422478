package no.hials.crosscom.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.jar.JarFile;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.Jar;
import no.hials.crosscom.mock.Fault;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.mock.junit.KukaController;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Runs the jar as a user does: as a process of its own. */
@Timeout(120)
class JarIT {
  private static final Path LICENCE = Path.of("../../LICENSE");

  @TempDir private Path dir;
  @KukaController private MockServer server;

  private Cli.Result run(ProcessBuilder builder) throws Exception {
    return Jar.run(builder, dir);
  }

  private Cli.Result runOnServer(String command, String... args) throws Exception {
    return run(Jar.process(Cli.argsOn(server, command, args)));
  }

  @Test
  void readsThreeVariablesOfASimulatedController() throws Exception {
    run(Jar.process("read", "$POS_ACT", "$OV_PRO", "$MODEL_NAME[]", "--mock"))
        .succeeds()
        .containsExactly(
            "$POS_ACT = {E6POS: X 525.000, Y 0.0, Z 890.000, A 0.0, B 90.0000, C 0.0, S 2, T 2,"
                + " E1 0.0, E2 0.0, E3 0.0, E4 0.0, E5 0.0, E6 0.0}",
            "$OV_PRO = 100",
            "$MODEL_NAME[] = \"#KR6R900 C4SR FLR 230\"");
  }

  @Test
  void namesItsLibrariesAndHasTheTextsOfTheirLicences() throws Exception {
    try (FileSystem jar = FileSystems.newFileSystem(Jar.FILE)) {
      List<String> notice = Files.readAllLines(jar.getPath("META-INF/NOTICE"));
      assertThat(notice)
          .anyMatch(line -> line.startsWith("logback-classic "))
          .anyMatch(line -> line.startsWith("picocli "));
      assertThat(notice)
          .filteredOn(line -> line.startsWith("  texts: "))
          .isNotEmpty()
          .flatMap(line -> List.of(line.substring(9).split(", ")))
          .allSatisfy(text -> assertThat(jar.getPath("META-INF/licenses", text)).isNotEmptyFile());
      assertThat(jar.getPath("META-INF/LICENSE")).hasSameTextualContentAs(LICENCE);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"raed", "help bogus", "file bogus", "program status"})
  void endsWithCode2AndASuggestionOrTheHelpOnAMistypedCommand(String args) throws Exception {
    run(Jar.process(args.split(" ")))
        .fails(2)
        .startsWith("jopenshowvar: ")
        .contains("try 'jopenshowvar")
        .doesNotContain("internal error");
  }

  @Test
  void itsClassesNeedNoneThatIsLeftOut() throws Exception {
    JavaClasses own;
    try (JarFile jar = new JarFile(Jar.FILE.toFile())) {
      own =
          new ClassFileImporter()
              .withImportOption(location -> location.contains("no/hials/crosscom/"))
              .importJar(jar);
    }

    assertThat(own.contain(Main.class)).isTrue();
    assertThat(own)
        .flatMap(JavaClass::getDirectDependenciesFromSelf)
        .map(Dependency::getTargetClass)
        .map(JavaClass::getBaseComponentType)
        .filteredOn(needed -> needed.getName().startsWith("no.hials.crosscom."))
        .isNotEmpty()
        .filteredOn(needed -> !own.contain(needed.getName()))
        .isEmpty();
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no SIGTERM")
  void servesUntilSigtermThenFreesThePortAndEndsWithCode0() throws Exception {
    Process mock =
        Jar.process("mock", "--port", "0", "--no-discovery")
            .redirectError(dir.resolve("err").toFile())
            .start();
    try (BufferedReader out =
        new BufferedReader(new InputStreamReader(mock.getInputStream(), StandardCharsets.UTF_8))) {
      String first = out.readLine();
      assertThat(first).matches("listening on 127\\.0\\.0\\.1:\\d+");
      int port = Integer.parseInt(first.substring(first.lastIndexOf(':') + 1));

      Cli.Result read =
          run(Jar.process("read", "MYINT", "--host", "127.0.0.1", "--port", "" + port));
      assertThat(read.lines()).containsExactly("MYINT = 0");

      assertThat(out.readLine()).isEqualTo("T1, no program");
      // SIGTERM; Process.destroy would close the stream besides
      mock.toHandle().destroy();
      assertThat(mock.waitFor()).isZero();
      assertThat(out.readLine()).isNull();
      new ServerSocket(port, 1, InetAddress.getLoopbackAddress()).close();
    } finally {
      mock.destroyForcibly();
    }
    assertThat(dir.resolve("err")).isEmptyFile();
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void servesUntilItsTerminalIsClosedAndEndsWithCode129() throws Exception {
    Process mock =
        Jar.withDefaultSignal("HUP", Jar.process("mock", "--port", "0", "--no-discovery")).start();
    try (BufferedReader out =
        new BufferedReader(new InputStreamReader(mock.getInputStream(), StandardCharsets.UTF_8))) {
      assertThat(out.readLine()).startsWith("listening on ");
      Jar.send("HUP", mock);

      assertThat(mock.waitFor()).isEqualTo(129);
    } finally {
      mock.destroyForcibly();
    }
  }

  @ParameterizedTest
  @CsvSource({"HUP, 129", "INT, 130", "TERM, 143"})
  @EnabledOnOs(OS.LINUX)
  void endsWith128AndTheNumberOfTheSignalWithoutTheAnswer(String signal, int code)
      throws Exception {
    server.enqueue(Fault.drop());
    Process read =
        Jar.withDefaultSignal(
                signal, Jar.process(Cli.argsOn(server, "read", "MYINT", "--timeout", "10m")))
            .redirectOutput(dir.resolve("out").toFile())
            .start();
    try {
      assertThat(server.takeRequest(Duration.ofSeconds(60))).isPresent();
      Jar.send(signal, read);

      assertThat(read.waitFor()).isEqualTo(code);
    } finally {
      read.destroyForcibly();
    }
    assertThat(dir.resolve("out")).isEmptyFile();
  }

  @ParameterizedTest
  @ValueSource(strings = {"INT", "TERM"})
  @EnabledOnOs(OS.LINUX)
  void aCommandThatRunsUntilItIsStoppedEndsWithCode0(String signal) throws Exception {
    Process watch =
        Jar.withDefaultSignal(signal, Jar.process(Cli.argsOn(server, "watch", "MYINT"))).start();
    try (BufferedReader out =
        new BufferedReader(new InputStreamReader(watch.getInputStream(), StandardCharsets.UTF_8))) {
      assertThat(out.readLine()).isNotNull();
      Jar.send(signal, watch);

      assertThat(watch.waitFor()).isZero();
    } finally {
      watch.destroyForcibly();
    }
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no SIGTERM")
  void leavesNothingOfADownloadThatSigtermEnds() throws Exception {
    try (MockServer bridge =
        MockServer.start(
            cfg ->
                cfg.server(ServerType.C3_BRIDGE).latency(Latency.fixed(Duration.ofMillis(20))))) {
      // many parts, so that the end is far away
      bridge.files().put("KRC:\\R1\\TP\\a.bin", new byte[20_000_000]);
      Path folder = Files.createDirectory(dir.resolve("here"));
      Process get =
          Jar.process(Cli.argsOn(bridge, "file get", "KRC:\\R1\\TP\\a.bin", folder.toString()))
              .redirectError(dir.resolve("err").toFile())
              .start();
      try {
        while (!(bridge.takeRequest(Duration.ofSeconds(60)).orElseThrow().request()
            instanceof ReadDataRequest)) {
          // not that far yet
        }
        assertThat(folder).isNotEmptyDirectory();
        get.toHandle().destroy();

        assertThat(get.waitFor()).isEqualTo(128 + 15);
      } finally {
        get.destroyForcibly();
      }
      assertThat(folder).isEmptyDirectory();
      assertThat(dir.resolve("err"))
          .content()
          .isEqualTo("jopenshowvar: stopped\nnot downloaded: KRC:\\R1\\TP\\a.bin\n");
    }
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no SIGTERM")
  void endsWithCode0AlsoWhileAProgramRunsAtFullSpeed() throws Exception {
    Path program = dir.resolve("busy.src");
    Files.write(
        program,
        List.of("DEF BUSY ( )", "LOOP", "  PTP_REL {A1 1}", "  PTP_REL {A1 -1}", "ENDLOOP", "END"));
    Process mock =
        Jar.process(
                "mock",
                "--port",
                "0",
                "--no-discovery",
                "--program",
                program.toString(),
                "--start",
                "--speed",
                "max")
            .redirectError(dir.resolve("err").toFile())
            .start();
    try (BufferedReader out =
        new BufferedReader(new InputStreamReader(mock.getInputStream(), StandardCharsets.UTF_8))) {
      assertThat(out.readLine()).startsWith("listening on ");
      assertThat(out.readLine()).startsWith("loaded BUSY from ");
      assertThat(out.readLine()).startsWith("T1, BUSY #P_ACTIVE line ");

      mock.toHandle().destroy();
      assertThat(mock.waitFor()).isZero();
      assertThat(out.readLine()).isNull();
    } finally {
      mock.destroyForcibly();
    }
    assertThat(Files.readAllLines(dir.resolve("err")))
        .isSubsetOf("1350 programmed path reached (BCO)"); // if it was printed before the end
  }

  @Test
  void writesWithCode0() throws Exception {
    runOnServer("write", "MYINT", "-5").succeeds().containsExactly("MYINT = -5");
    assertThat(server.variables().get("MYINT")).isEqualTo("-5");
  }

  @Test
  void readsFromSeveralRobotsOfTheConfigurationFile() throws Exception {
    Path file =
        Files.write(
            dir.resolve("config.toml"),
            List.of(
                "[robots.sim]",
                "mock = true",
                "[robots.cell1]",
                "host = '" + server.host() + "'",
                "port = " + server.port()));
    server.variables().set("MYINT", "1");
    ProcessBuilder builder = Jar.process("read", "@cell1", "@sim", "MYINT");
    builder.environment().put("JOPENSHOWVAR_CONFIG", file.toString());

    run(builder).succeeds().containsExactly("cell1: MYINT = 1", "sim: MYINT = 0");
  }

  @Test
  void endsWithCode1IfTheControllerRefuses() throws Exception {
    Cli.Result result = runOnServer("read", "MYINT", "NOPE");

    assertThat(result.lines()).containsExactly("MYINT = 0");
    assertThat(result.errLines())
        .singleElement()
        .asString()
        .startsWith("jopenshowvar: the controller refused to read NOPE");
    assertThat(result.code()).isEqualTo(1);
  }

  @Test
  void endsWithCode2OnWrongUsage() throws Exception {
    run(Jar.process("read", "MYINT")).fails(2).startsWith("jopenshowvar: which controller?");
  }

  @Test
  void endsWithCode3IfItCannotConnect() throws Exception {
    server.refuseConnections();

    runOnServer("read", "MYINT")
        .failsInALine(3)
        .startsWith("jopenshowvar: could not connect to 127.0.0.1");
  }

  @Test
  void endsWithCode4IfWhatComesIsNotTheProtocol() throws Exception {
    server.enqueue(Fault.none(), Fault.wrongFunction(9));

    runOnServer("write", "MYINT", "5")
        .failsInALine(4)
        .startsWith("jopenshowvar: the answer to the write of MYINT is invalid")
        .contains("the outcome is unknown");
  }

  @Test
  void logsFramesToStderrAndDataToStdout() throws Exception {
    Cli.Result result = runOnServer("read", "-vv", "--json", "MYINT");

    assertThat(result.lines())
        .containsExactly("{\"name\":\"MYINT\",\"type\":\"INT\",\"value\":0,\"text\":\"0\"}");
    assertThat(result.err())
        .contains("DEBUG Connection: connected to ")
        .contains("TRACE Connection: sending 00 01 00 08 00 00 05 4D 59 49 4E 54")
        .contains("TRACE Connection: received 00 01 00 07 00 00 01 30 00 01 01");
    assertThat(result.errLines())
        .allMatch(line -> line.matches("\\d\\d:\\d\\d:\\d\\d\\.\\d{3} (DEBUG|TRACE) \\S+: .*"));
    assertThat(result.code()).isZero();
  }

  @Test
  void logsWhatTheConnectionDoesButNoFramesIfVerboseOnce() throws Exception {
    assertThat(runOnServer("read", "--verbose", "MYINT").err())
        .contains("DEBUG Connection: connected to ")
        .doesNotContain("TRACE");
  }

  @Test
  void drawsAnSvgWithTexts() throws Exception {
    Path csv = Files.writeString(dir.resolve("run.csv"), "time [s],force [N]\n0,1.5\n1,2.5\n");
    Path svg = dir.resolve("run.svg");

    run(Jar.process("plot", csv.toString(), "--out", svg.toString())).succeeds();
    assertThat(Files.readString(svg)).contains(">run.csv</text>");
  }

  @Test
  void printsTheVersionOfTheBuild() throws Exception {
    Cli.Result result = run(Jar.process("--version"));

    assertThat(result.out().strip()).matches("jopenshowvar \\d+\\.\\d+\\.\\d+(-SNAPSHOT)?");
    result.succeeds();
  }

  @Test
  void endsQuietlyIfNobodyReadsItsOutput() throws Exception {
    Path err = dir.resolve("err");
    Process process =
        Jar.process("read", "MYINT", "MYREAL", "--mock").redirectError(err.toFile()).start();
    try {
      process.getInputStream().close();

      assertThat(process.waitFor()).isEqualTo(74);
      assertThat(err).isEmptyFile();
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void printsUmlautsAlsoWhereNoCharsetIsChosen() throws Exception {
    server.variables().set("MYSTRING[]", "\"B\u00FChne\"");
    ProcessBuilder builder = Jar.process(Cli.argsOn(server, "read", "MYSTRING[]"));
    builder.environment().put("LC_ALL", "C");

    assertThat(run(builder).lines()).containsExactly("MYSTRING[] = \"B\u00FChne\"");
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void readsUmlautsAlsoWhereNoCharsetIsChosen() throws Exception {
    Path lines = Files.writeString(dir.resolve("lines"), "MYSTRING[] = \"B\u00FChne\"\n");
    ProcessBuilder builder =
        Jar.process(Cli.argsOn(server, "shell", "--yes")).redirectInput(lines.toFile());
    builder.environment().put("LC_ALL", "C");

    assertThat(run(builder).code()).isZero();
    assertThat(server.variables().get("MYSTRING[]")).isEqualTo("\"B\u00FChne\"");
  }
}
