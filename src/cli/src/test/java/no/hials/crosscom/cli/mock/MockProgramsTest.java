package no.hials.crosscom.cli.mock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.LoadedFiles;
import no.hials.crosscom.cli.base.RunningMock;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.SimulationClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The data lists and programs of {@code mock}. */
@Timeout(60)
class MockProgramsTest {
  private static final Path KRL = Path.of("..", "..", "krl");

  @TempDir private Path dir;

  private String file(String name, String... lines) throws IOException {
    return Files.write(dir.resolve(name), List.of(lines), StandardCharsets.ISO_8859_1).toString();
  }

  private static RunningMock mock(String... options) throws InterruptedException {
    return new RunningMock(
        Stream.concat(Stream.of("--no-discovery"), Stream.of(options)).toArray(String[]::new));
  }

  private static Cli.Result refused(String... options) {
    return Cli.run(
        Stream.concat(Stream.of("mock", "--port", "0", "--no-discovery"), Stream.of(options))
            .toArray(String[]::new));
  }

  /** Reads until the value is another one; the test's time limit ends it. */
  private static String readUntilNot(String value, RunningMock mock, String name) {
    return Stream.generate(() -> mock.read(name)).filter(v -> !v.equals(value)).findFirst().get();
  }

  @Test
  void movesTheRobotByWhatAClientWrites() throws Exception {
    String config = KRL.resolve("config.dat").toString();
    String program = KRL.resolve("actuator.src").toString();
    try (RunningMock mock =
        mock(
            "--config",
            config,
            "--program",
            program,
            "--start",
            "--mode",
            "AUT",
            "--speed",
            "20")) {
      assertThat(mock.nextLine()).isEqualTo("loaded $CONFIG from " + config);
      assertThat(mock.nextLine()).isEqualTo("loaded ACTUATOR from " + program);
      assertThat(mock.nextLine()).startsWith("AUT, ACTUATOR #P_ACTIVE line ");
      // the program sets MYPOS to zeros before it counts
      readUntilNot("0", mock, "JOV_STEPS");
      assertThat(mock.read("$POS_ACT.X")).isEqualTo("525.000");

      assertThat(
              mock.run("write", "--yes", "MYPOS", "{X -0.5,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}").code())
          .isZero();

      String x = readUntilNot("525.000", mock, "$POS_ACT.X");
      assertThat(Double.parseDouble(x)).isLessThan(525);
      assertThat(mock.read("$POS_ACT")).contains("Y 0.0,").doesNotContain("X 525.000");
      assertThat(mock.stop()).isZero();
    }
  }

  @Test
  void selectsAProgramAndDoesNotStartItUnlessItIsTold() throws Exception {
    String program = file("waits.src", "DEF WAITS ( )", "  WAIT FOR $IN[1]", "END");
    try (RunningMock mock = mock("--program", program)) {
      assertThat(mock.nextLine()).isEqualTo("loaded WAITS from " + program);
      assertThat(mock.nextLine()).startsWith("T1, WAITS #P_RESET line ");
      assertThat(mock.read("$PRO_STATE1")).isEqualTo("#P_RESET");
      assertThat(mock.read("$MODE_OP")).isEqualTo("#T1");
    }
  }

  @Test
  void startsInEveryMode() throws Exception {
    String program = file("waits.src", "DEF WAITS ( )", "  WAIT FOR $IN[1]", "END");
    for (String mode : List.of("T1", "t2", "AUT", "EXT")) {
      try (RunningMock mock = mock("--program", program, "--start", "--mode", mode)) {
        assertThat(mock.read("$PRO_STATE1")).isEqualTo("#P_ACTIVE");
        assertThat(mock.read("$MODE_OP"))
            .isEqualTo(mode.equals("EXT") ? "#EX" : "#" + mode.toUpperCase(Locale.ROOT));
      }
    }
  }

  @Test
  void runsASubmitProgramBesideTheRobots() throws Exception {
    String submit = file("count.SUB", "DEF COUNT ( )", "LOOP", "  MYINT=MYINT+1", "ENDLOOP", "END");
    String program = file("waits.src", "DEF WAITS ( )", "  WAIT FOR $IN[1]", "END");
    try (RunningMock mock = mock("--program", program, "--program", submit, "--start")) {
      readUntilNot("0", mock, "MYINT");
      assertThat(mock.read("$PRO_NAME0[]")).isEqualTo("\"COUNT\"");
      assertThat(mock.read("$PRO_NAME1[]")).isEqualTo("\"WAITS\"");
    }
  }

  @Test
  void startsASubmitProgramAlone() throws Exception {
    String submit = file("count.sub", "DEF COUNT ( )", "LOOP", "  MYINT=MYINT+1", "ENDLOOP", "END");
    try (RunningMock mock = mock("--program", submit, "--start")) {
      assertThat(mock.nextLine()).startsWith("loaded COUNT from ");
      assertThat(mock.nextLine()).startsWith("T1, no program, submit COUNT #P_ACTIVE line ");
      readUntilNot("0", mock, "MYINT");
    }
  }

  @Test
  void selectsTheFirstProgramWhichMayCallTheOthers() throws Exception {
    String caller = file("caller.src", "DEF CALLER ( )", "  CALLED ( )", "END");
    String called = file("called.src", "DEF CALLED ( )", "  MYINT=5", "  WAIT FOR $IN[1]", "END");
    try (RunningMock mock = mock("--program", caller, "--program", called, "--start")) {
      assertThat(readUntilNot("0", mock, "MYINT")).isEqualTo("5");
      assertThat(mock.read("$PRO_NAME1[]")).isEqualTo("\"CALLER\"");
    }
  }

  @Test
  void loadsTheDataListBesideAProgramAndOwnGlobals() throws Exception {
    String config =
        file("own.dat", "DEFDAT $OWN", "DECL INT OWN_LIMIT=12", "DECL INT OWN_SUM=0", "ENDDAT");
    file("adds.dat", "DEFDAT ADDS", "DECL INT PART=30", "ENDDAT");
    String program = file("adds.src", "DEF ADDS ( )", "  OWN_SUM=OWN_LIMIT+PART", "END");
    try (RunningMock mock = mock("--config", config, "--program", program, "--start")) {
      assertThat(readUntilNot("0", mock, "OWN_SUM")).isEqualTo("42");
    }
  }

  @Test
  void showsTheMessagesOfTheControllerOnStderr() throws Exception {
    String program = file("far.src", "DEF FAR ( )", "  PTP {A1 400}", "END");
    try (RunningMock mock = mock("--program", program, "--start", "--mode", "AUT")) {
      assertThat(mock.nextErrorLine())
          .matches("\\d+ far\\.src:2:3: A1 must be at most 170.000 degrees, would be 400.000");
      assertThat(mock.read("$STOPMESS")).isEqualTo("TRUE");
    }
  }

  @Test
  void saysWhichFileIsNotThere() {
    refused("--program", dir.resolve("gone.src").toString())
        .failsInLines(2)
        .containsExactly(
            "jopenshowvar: cannot read " + dir.resolve("gone.src") + ": file not found");
  }

  @Test
  void doesNotTakeADirectoryForAFile() throws Exception {
    Path folder = Files.createDirectory(dir.resolve("folder.dat"));

    refused("--config", folder.toString())
        .fails(2)
        .startsWith("jopenshowvar: cannot read " + folder + ": ");
  }

  @Test
  void saysWhereTheErrorsOfAFileAre() throws Exception {
    String program =
        file("bad.src", "DEF BAD ( )", "  MYINT = = 3", "  WAIT FOO", "  MYINT=1", "END");

    Cli.Result result = refused("--strict", "--program", program);

    result.failsInLines(2).hasSizeGreaterThanOrEqualTo(3);
    assertThat(result.errLines().get(0)).isEqualTo("jopenshowvar: cannot load " + program + ":");
    assertThat(result.errLines().get(1)).startsWith("bad.src:2:11: ");
    assertThat(result.errLines().get(2)).startsWith("bad.src:3:8: ");
  }

  @Test
  void saysWhereTheErrorsOfADataListAre() throws Exception {
    String config = file("bad.dat", "DEFDAT $CONFIG", "DECL INT BAD=#A", "ENDDAT");

    refused("--strict", "--config", config)
        .failsInLines(2)
        .last()
        .asString()
        .startsWith("bad.dat:2:14: BAD: needs INT");
  }

  @Test
  void saysWhichRoutineAProgramLacks() throws Exception {
    String program = file("lacks.src", "DEF LACKS ( )", "  NOWHERE ( )", "END");

    refused("--strict", "--program", program, "--start")
        .failsInLines(2)
        .containsExactly(
            "jopenshowvar: " + program + " cannot be selected:",
            "lacks.src:2:3: no routine NOWHERE is known");
  }

  @Test
  void saysThatTheControllerRefusedToStart() throws Exception {
    Path program = Path.of(file("waits.src", "DEF WAITS ( )", "  WAIT FOR $IN[1]", "END"));
    try (MockServer server = MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()))) {
      server.controller().emergencyStop(true);

      List<String> lines =
          new ControllerSetup(List.of(), List.of(program), OperatingMode.AUT, true, null)
              .apply(server.controller(), new LoadedFiles(true));

      assertThat(lines)
          .contains("not started: start: the emergency stop is pressed")
          .last()
          .asString()
          .startsWith("AUT, WAITS #P_RESET");
    }
  }
}
