package no.hials.crosscom.cli.mock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.cli.base.RunningMock;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The archive of {@code mock}, and the commands of {@code krl} on it. */
@Timeout(60)
class MockArchiveTest {
  private static final Charset WINDOWS = Charset.forName("windows-1252");

  private static final String PICK =
      """
      &ACCESS RVP
      DEF PICK( ) ;Gr\u00F6\u00DFe
      DECL AXIS A
      A={A1 10,A2 -90,A3 90,A4 0,A5 0,A6 0}
      PTP A
      A.A1=20.0
      PTP A
      PARTS=PARTS+1
      END
      """
          .replace("\n", "\r\n");

  @TempDir private Path dir;

  private final Map<String, String> files = new LinkedHashMap<>();
  private String zip = "";

  @BeforeEach
  void write() throws IOException {
    files.put("am.ini", "[Archive]\r\nName=Cell 4\r\n");
    files.put("KRC/R1/System/$config.dat", "DEFDAT $CONFIG\nINT PARTS=6\nINT CYCLES=0\nENDDAT\n");
    files.put(
        "KRC/R1/System/sps.sub",
        "DEF SPS( )\nLOOP\nCYCLES=CYCLES+1\nWAIT SEC 0.012\nENDLOOP\nEND\n");
    files.put("KRC/R1/Program/pick.src", PICK);
    zip = zip();
  }

  private String zip() throws IOException {
    Path path = dir.resolve("cell.zip");
    try (OutputStream out = Files.newOutputStream(path);
        ZipOutputStream entries = new ZipOutputStream(out)) {
      for (Map.Entry<String, String> file : files.entrySet()) {
        entries.putNextEntry(new ZipEntry(file.getKey()));
        entries.write(file.getValue().getBytes(WINDOWS));
      }
    }
    return path.toString();
  }

  private static RunningMock mock(String... options) throws InterruptedException {
    return new RunningMock(
        Stream.concat(Stream.of("--no-discovery"), Stream.of(options)).toArray(String[]::new));
  }

  private static void readUntil(String value, RunningMock mock, String name) {
    assertThat(Stream.generate(() -> mock.read(name)).anyMatch(value::equals)).isTrue();
  }

  @Test
  void startsTheProgramOfAnArchiveAndShowsItsFilesToC3() throws Exception {
    try (RunningMock mock =
        mock("--archive", zip, "--start", "--mode", "AUT", "--server", "c3", "--speed", "20")) {
      readUntil("7", mock, "PARTS");
      readUntil("#P_END", mock, "$PRO_STATE1");
      assertThat(mock.run("program run", "/R1/PICK", "--yes").code()).isZero();
      readUntil("8", mock, "PARTS");
      assertThat(mock.read("$PRO_STATE0")).isEqualTo("#P_ACTIVE");

      assertThat(mock.run("file ls", "KRC:\\R1\\Program").out()).containsIgnoringCase("pick.src");
      Path copy = dir.resolve("copy.src");
      assertThat(mock.run("file get", "/R1/PICK.SRC", copy.toString()).code()).isZero();
      assertThat(Files.readAllBytes(copy)).isEqualTo(PICK.getBytes(WINDOWS));
      assertThat(mock.run("watch", "PARTS", "--count", "2").code()).isZero();
    }
  }

  @Test
  void theSummaryIsOnStderrAndSaysWhatIsNotUnderstood() throws Exception {
    files.put("KRC/R1/Program/bad.src", "DEF BAD( )\nPARTS=\nEND\n");
    try (RunningMock mock = mock("--archive", zip())) {
      assertThat(mock.nextLine()).startsWith("T1, no program, submit SPS #P_ACTIVE line ");
      assertThat(mock.nextErrorLine()).startsWith("archive ").endsWith("cell.zip: name Cell 4");
      assertThat(Stream.of(mock.nextErrorLine(), mock.nextErrorLine(), mock.nextErrorLine()))
          .contains(
              "loaded KRC/R1/System/$config.dat", "loaded with 1 warning KRC/R1/Program/bad.src");
    }
  }

  @Test
  void printsTheSummaryAsJsonAfterTheFirstLine() throws Exception {
    try (RunningMock mock = mock("--archive", zip, "--json")) {
      assertThat(mock.nextLine())
          .isEqualTo(
              "{\"file\":\"KRC/R1/System/$config.dat\",\"outcome\":\"loaded\",\"problems\":[]}");
      assertThat(mock.nextErrorLine()).startsWith("archive ").endsWith("cell.zip: name Cell 4");
    }
  }

  @Test
  void strictlyAFileWithAnErrorEndsTheCommand() throws Exception {
    files.put("KRC/R1/Program/bad.src", "DEF BAD( )\nPARTS=\nEND\n");

    Cli.Result result = Cli.run("mock", "--port", "0", "--archive", zip(), "--strict");

    assertThat(result.code()).isEqualTo(2);
    assertThat(result.errLines().get(0)).contains("the archive has files with errors:");
    assertThat(result.errLines().get(1)).startsWith("KRC/R1/Program/bad.src:2:");
  }

  @Test
  void saysThatThereIsNoArchive() {
    Cli.run("mock", "--port", "0", "--archive", dir.resolve("no.zip").toString())
        .failsInALine(2)
        .contains("no.zip", "file not found");
  }

  @Test
  void namesTheArchiveThatIsNone() throws Exception {
    String notes = Files.writeString(dir.resolve("notes.txt"), "notes").toString();
    String reason = "cannot read " + notes + ": it is neither a zip nor a .src, .sub or .dat file";

    Cli.run("mock", "--port", "0", "--archive", notes).failsInALine(2).contains(reason);
    Cli.run("krl", "check", zip, notes).failsInALine(2).contains(reason);
    files.clear();
    Cli.run("mock", "--port", "0", "--archive", zip())
        .failsInALine(2)
        .contains("cannot read " + zip + ": there is no .src, .sub or .dat file in it");
  }

  // krl

  @Test
  void checkIsSilentAboutFilesWithoutProblems() {
    Cli.Result result = Cli.run("krl", "check", zip);

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.out()).isEmpty();
    assertThat(result.errLines()).containsExactly("files: 3, problems: 0");
  }

  @Test
  void checkNamesThePlaceOfEachProblem() throws Exception {
    files.put("KRC/R1/Program/bad.src", "DEF BAD( )\nPARTS=\nNOWHERE()\nMISSING=1\nEND\n");

    Cli.Result result = Cli.run("krl", "check", zip());

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.lines())
        .extracting(line -> line.substring(0, line.indexOf(": ")))
        .containsExactly(
            "KRC/R1/Program/bad.src:2:7",
            "KRC/R1/Program/bad.src:3:1",
            "KRC/R1/Program/bad.src:4:1");
    assertThat(Cli.run("krl", "check", zip(), "--json").out())
        .contains("\"outcome\":\"warnings\",\"problems\":[{\"line\":2,\"column\":7,");
  }

  @Test
  void checkWarnsOfLongNamesAndMissingEnds() throws Exception {
    files.put("KRC/R1/Program/cut.dat", "DEFDAT CUT\nINT A_COUNTER_WITH_A_LONG_NAME=1\n");
    files.put("KRC/R1/Program/cut.src", "DEF CUT( )\nA_COUNTER_WITH_A_LONG_NAME=2\n");

    Cli.Result result = Cli.run("krl", "check", zip());

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.lines())
        .containsExactly(
            "KRC/R1/Program/cut.dat:2:5: a name has at most 24 characters,"
                + " A_COUNTER_WITH_A_LONG_NAME has 26",
            "KRC/R1/Program/cut.dat:3:1: expected ENDDAT, found the end of the file",
            "KRC/R1/Program/cut.src:3:1: expected END, found the end of the file");
  }

  @Test
  void checkRefusesFilesWithErrorsIfStrict() throws Exception {
    files.put("KRC/R1/Program/bad.src", "DEF BAD( )\nPARTS=\nNOWHERE()\nEND\n");

    Cli.Result result = Cli.run("krl", "check", zip(), "--strict", "--json");

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.lines())
        .filteredOn(line -> line.contains("bad.src"))
        .singleElement()
        .asString()
        .contains("\"outcome\":\"refused\",\"problems\":[{\"line\":2,\"column\":7,")
        .doesNotContain("NOWHERE");
    files.remove("KRC/R1/Program/bad.src");
    assertThat(Cli.run("krl", "check", zip(), "--strict").code()).isZero();
  }

  @Test
  void checkIncludesTheDataListNextToAProgram() throws Exception {
    Path program = Files.writeString(dir.resolve("own.src"), "DEF OWN( )\nN=N+1\nEND\n");
    assertThat(Cli.run("krl", "check", program.toString()).code()).isEqualTo(1);

    Files.writeString(dir.resolve("own.dat"), "DEFDAT OWN\nINT N=1\nENDDAT\n");

    assertThat(Cli.run("krl", "check", program.toString()).code()).isZero();
  }

  @Test
  void runPrintsARowForEachMotionOfAProgramOfTheArchive() {
    Cli.Result result = Cli.run("krl", "run", "pick.src", "--archive", zip);

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.lines()).hasSize(3);
    assertThat(result.lines().get(0))
        .startsWith("time,$POS_FOR.X,")
        .endsWith(",$AXIS_FOR.A5,$AXIS_FOR.A6");
    assertThat(List.of(result.lines().get(1).split(",", -1)).get(7)).isEqualTo("10.0000");
    assertThat(List.of(result.lines().get(2).split(",", -1)).get(7)).isEqualTo("20.0000");
  }

  @Test
  void runPrintsShortAndApproximatedMotionsToo() throws Exception {
    Path program =
        Files.writeString(
            dir.resolve("short.src"),
            """
            DEF SHORT( )
            INT I
            PTP {A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0}
            PTP {A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0}
            FOR I=1 TO 5
            LIN_REL {Z 0.01} C_DIS
            ENDFOR
            LIN_REL {X -40} C_DIS
            LIN_REL {Y 40} C_DIS
            PTP {A1 10} C_PTP
            PTP {A1 20}
            PTP {A1 20}
            END
            """);

    Cli.Result result = Cli.run("krl", "run", program.toString());

    assertThat(result.code()).as(result.err()).isZero();
    List<List<String>> rows =
        result.lines().stream().skip(1).map(row -> List.of(row.split(",", -1))).toList();
    assertThat(rows).hasSize(12);
    double z = Double.parseDouble(rows.get(1).get(3));
    for (int i = 1; i <= 5; i++) {
      assertThat(Double.parseDouble(rows.get(1 + i).get(3))).isEqualTo(z + i * 0.01, within(1e-3));
    }
    double x = Double.parseDouble(rows.get(6).get(1));
    assertThat(Double.parseDouble(rows.get(7).get(1))).isEqualTo(x - 40, within(1e-3));
    assertThat(Double.parseDouble(rows.get(8).get(2))).isEqualTo(40, within(1e-3));
    assertThat(rows.subList(9, 12))
        .extracting(row -> row.get(7))
        .containsExactly("10.0000", "20.0000", "20.0000");
  }

  @Test
  void runPrintsEachPointOfASplineBlock() throws Exception {
    Path program =
        Files.writeString(
            dir.resolve("block.src"),
            """
            DEF BLOCK( )
            PTP {A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0}
            PTP_SPLINE
            SPTP {A1 10}
            SPTP {A1 20,A2 -80}
            SPTP {A1 30,A2 -90}
            ENDSPLINE
            END
            """);

    Cli.Result result = Cli.run("krl", "run", program.toString());

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.lines().stream().skip(2).map(row -> row.split(",", -1)[7]))
        .containsExactly("10.0000", "20.0000", "30.0000");
  }

  @Test
  void runEndsWithOneIfTheProgramStops() throws Exception {
    Path program = Files.writeString(dir.resolve("stops.src"), "DEF STOPS( )\nNOWHERE()\nEND\n");

    Cli.Result result = Cli.run("krl", "run", program.toString());

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.err())
        .contains("stops.src:2:1", "the program did not reach its end")
        .doesNotContain("not started");
  }

  @Test
  void runFindsAProgramOfTheArchiveByItsFileAndSaysWhyOneWasRefused() throws Exception {
    files.put("KRC/R1/Program/drop_2.src", PICK.replace("PICK", "DROP"));
    files.put("KRC/R1/Program/pick_old.src", PICK);

    assertThat(Cli.run("krl", "run", "DROP_2.SRC", "--archive", zip()).lines()).hasSize(3);
    Cli.run("krl", "run", "pick_old.src", "--archive", zip)
        .fails(2)
        .contains("another file has its module PICK, and is loaded: KRC/R1/Program/pick.src");
  }

  @Test
  void runNamesTheLimitThatEndsIt() {
    Cli.Result result = Cli.run("krl", "run", "pick.src", "--archive", zip, "--limit", "24ms");

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.errLines()).contains("the simulated time of --limit is over");
  }

  @Test
  void runAnswersDialoguesAndConfirmsMessagesOfTheProgram() throws Exception {
    Path program =
        Files.writeString(
            dir.resolve("asks.src"),
            """
            DEF ASKS( )
            INT ANSWER
            MSGDIALOG(ANSWER,"Go on?",,,,"Yes","No")
            MSGNOTIFY("answer %1",,ANSWER)
            MSGQUIT("please confirm")
            PTP {A1 10}
            END
            """);

    Cli.Result result = Cli.run("krl", "run", program.toString());

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.lines()).hasSize(2);
    assertThat(result.errLines())
        .containsSubsequence(
            "0 Go on? [2 Yes, 3 No]",
            "answered: 2 Yes",
            "0 answer 6",
            "0 please confirm",
            "confirmed messages: 1");
  }

  @Test
  void runNamesTheLineThatStillWaitsAtTheLimit() throws Exception {
    Path program =
        Files.writeString(
            dir.resolve("waits.src"), "DEF WAITS( )\nPTP {A1 1}\nWAIT FOR $IN[7]\nEND\n");

    Cli.Result result = Cli.run("krl", "run", program.toString(), "--limit", "60s");

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.errLines())
        .contains(
            "the simulated time of --limit is over; the program waits for a condition (WAIT FOR):"
                + " WAITS #P_ACTIVE line 3");
  }

  @Test
  void runPrintsNoRowOfAMotionThatCannotReachItsTarget() throws Exception {
    Path program =
        Files.writeString(
            dir.resolve("far.src"),
            """
            DEF FAR( )
            PTP {A1 0,A2 -90,A3 90,A4 0,A5 45,A6 0}
            LIN_REL {X 100000}
            END
            """);

    Cli.Result result = Cli.run("krl", "run", program.toString());

    assertThat(result.code()).isEqualTo(1);
    assertThat(result.lines()).hasSize(2);
    assertThat(result.err()).contains("far.src:3:1: ");
  }

  @Test
  void runRefusesAPeriodBetweenTwoCycles() {
    Cli.run("krl", "run", "pick.src", "--archive", zip, "--period", "20ms")
        .fails(2)
        .contains("--period must be a multiple of 12 ms, is 20 ms");
  }

  @Test
  void runNamesTheNumberOfWarningsThatAreNotShown() throws Exception {
    files.put("KRC/R1/Program/bad.src", "DEF BAD( )\n" + "PARTS=\n".repeat(25) + "END\n");

    Cli.Result result = Cli.run("krl", "run", "pick.src", "--archive", zip());

    assertThat(result.code()).isZero();
    assertThat(result.errLines())
        .contains("warning: KRC/R1/Program/bad.src: 5 more; krl check shows all");
  }

  @Test
  void runStartsAProgramAgainAfterAMessageThatItCleared() throws Exception {
    Path program =
        Files.writeString(
            dir.resolve("clears.src"),
            """
            DEF CLEARS( )
            DECL KRLMSG_T M
            DECL KRLMSGPAR_T P[3]
            DECL INT H
            DECL BOOL DONE
            M={MODUL[] "CELL",NR 4711,MSG_TXT[] "check"}
            H=SET_KRLMSG(#QUIT,M,P[])
            DONE=CLEAR_KRLMSG(H)
            HALT
            END
            """);

    Cli.Result result = Cli.run("krl", "run", program.toString());

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.err()).contains("4711");
  }

  @Test
  void runPrintsTheExternalAxesThatExist() throws Exception {
    files.put(
        "KRC/R1/Mada/$machine.dat",
        """
        DEFDAT $MACHINE PUBLIC
        INT $EX_AX_NUM=1
        $AXIS_TYPE[7]=3
        $SOFTN_END[7]=-90.0
        $SOFTP_END[7]=90.0
        $VEL_AXIS_MA[7]=3000.0
        $RAT_MOT_AX[7]={N 180,D 1}
        ENDDAT
        """);
    files.put("KRC/R1/Program/turn.src", "DEF TURN( )\nPTP {E1 30.0}\nEND\n");

    Cli.Result result = Cli.run("krl", "run", "turn.src", "--archive", zip());

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.lines().get(0)).endsWith(",$AXIS_FOR.A6,$AXIS_FOR.E1");
    assertThat(result.lines().get(1)).endsWith(",30.0000");
    assertThat(Cli.run("krl", "run", "turn.src", "--archive", zip, "--period", "12ms").lines())
        .first()
        .asString()
        .endsWith(",$AXIS_ACT.A6,$AXIS_ACT.E1");
  }

  @Test
  void runPrintsThePositionAtAPeriod() {
    Cli.Result result = Cli.run("krl", "run", "pick.src", "--archive", zip, "--period", "24ms");

    assertThat(result.code()).as(result.err()).isZero();
    assertThat(result.lines().get(2)).startsWith("0.024,");
    assertThat(result.lines().get(0)).contains("$AXIS_ACT.A1");
  }
}
