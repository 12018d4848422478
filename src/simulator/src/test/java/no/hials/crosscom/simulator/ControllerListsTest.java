package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.protocol.value.KrlEncoding;
import no.hials.crosscom.simulator.LoadReport.FileReport;
import no.hials.crosscom.simulator.LoadReport.Outcome;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Loads data lists in the style of a controller, leniently. */
class ControllerListsTest {
  private static final Path TYPES_PAGE = Path.of("..", "..", "docs", "reference", "krl-types.md");
  private static final List<String> LISTS =
      List.of("$config.dat", "$machine.dat", "$custom.dat", "$robcor.dat", "$option.dat");

  private final Cell cell = new Cell();

  @AfterEach
  void close() {
    cell.close();
  }

  private static Path list(String name) {
    try {
      return Path.of(
          Objects.requireNonNull(ControllerListsTest.class.getResource("lists/" + name)).toURI());
    } catch (URISyntaxException e) {
      throw new AssertionError(e);
    }
  }

  private static String text(String name) {
    try {
      return KrlEncoding.decode(Files.readAllBytes(list(name)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private LoadReport load(String name, String... lines) {
    String text = "DEFDAT " + name + "\n" + String.join("\n", lines) + "\nENDDAT\n";
    return cell.controller.load("x.dat", text, LoadingMode.LENIENT);
  }

  private List<String> warnings(String name, String... lines) {
    LoadReport report = load(name, lines);
    assertThat(report.anyRefused()).isFalse();
    return report.problems().stream().map(KrlError::toString).toList();
  }

  @Nested
  class WholeLists {

    @ParameterizedTest
    @EnumSource(LoadingMode.class)
    void canHaveStatesOfWorkspacesAndTheLargestTool(LoadingMode mode) {
      String list =
          """
          DEFDAT $MACHINE
          $AXWORKSPACE[1]={A1_N 0.0,A1_P 0.0,MODE #OFF,STATE FALSE}
          $WORKSPACE[1]={X 0.0,Y 0.0,MODE #OFF,STATE TRUE}
          DECL MAXTOOL $SR_MAX_TOOL
          $SR_MAX_TOOL={LOAD_CM_R 1.0,LOAD_CM_Z 2.0,LOAD_M 3.0,LOAD_J 4.0,TOOL_R 5.0,TOOL_Z 6.0}
          ENDDAT
          """;

      assertThat(cell.controller.load("machine.dat", list, mode).problems()).isEmpty();
      assertThat(cell.get("$WORKSPACE[1].STATE")).isEqualTo("TRUE");
      assertThat(cell.get("$SR_MAX_TOOL.TOOL_Z")).isEqualTo("6.00000");
    }

    @ParameterizedTest
    @ValueSource(strings = {"$machine.dat", "$robcor.dat", "$option.dat"})
    void areLoadedWithoutAWarning(String name) throws IOException {
      LoadReport report = cell.controller.load(list(name), LoadingMode.LENIENT);

      assertThat(report.problems()).isEmpty();
      assertThat(report.files())
          .singleElement()
          .extracting(FileReport::path, FileReport::outcome)
          .containsExactly(name, Outcome.LOADED);
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = {
          "$config.dat | $config.dat:240:17: a name has at most 24 characters,"
              + " COUNTER_OF_ALL_PARTS_OF_THIS_SHIFT has 34;"
              + "$config.dat:273:29: a name has at most 24 characters,"
              + " MY_ENERGY_MEASURING_STRUC has 25",
          "$custom.dat | $custom.dat:32:1: expected ENDDAT, found the end of the file"
        })
    void areLoadedWithAWarningForLongNamesAndAMissingEnd(String name, String warnings)
        throws IOException {
      LoadReport report = cell.controller.load(list(name), LoadingMode.LENIENT);

      assertThat(report.files()).extracting(FileReport::outcome).containsExactly(Outcome.WARNINGS);
      assertThat(report.problems())
          .extracting(KrlError::toString)
          .containsExactly(warnings.split(";"));
    }

    @Test
    void declareSystemVariablesAgainWithoutValuesAndKeepTheirs() {
      String position = cell.get("$POS_ACT");
      List<String> problems =
          warnings(
              "$OPERATE PUBLIC",
              "INT $OV_PRO",
              "E6POS $POS_ACT",
              "INT $MODE_OP",
              "FRAME $WORLD",
              "BOOL $IN[1024]",
              "REAL $VEL_AXIS[6]",
              "BOOL $STOPMESS",
              "CHAR $TRAFONAME[8]",
              "INT $TIMER[64]",
              "$TIMER[2]=5");

      assertThat(problems).isEmpty();
      assertThat(cell.get("$OV_PRO")).isEqualTo("100");
      assertThat(cell.get("$POS_ACT")).isEqualTo(position);
      assertThat(cell.get("$MODE_OP")).isEqualTo("#AUT");
      assertThat(cell.get("$WORLD.Z")).isEqualTo("0.0");
      assertThat(cell.get("$IN[1025]")).isEqualTo("TRUE");
      assertThat(cell.get("$VEL_AXIS[6]")).isEqualTo("100.000");
      assertThat(cell.get("$STOPMESS")).isEqualTo("FALSE");
      assertThat(cell.get("$TRAFONAME[]")).isEqualTo("\"#KR6R900 C4SR FLR 230\"");
      assertThat(cell.get("$TIMER[1]")).isEqualTo("0");
      assertThat(cell.get("$TIMER[2]")).isEqualTo("5");
    }

    @Test
    void variablesOfTypesThatAreMissingKeepWhatIsWritten() throws Exception {
      LoadReport list =
          cell.controller.load(
              "pick.dat",
              """
              DEFDAT PICK
              DECL SPOT_T S1={GUN 2,THICK 1.5,NAME[] "A"}
              DECL SPOT_T ALL[3]
              ALL[2]={GUN 7}
              ENDDAT
              """,
              LoadingMode.LENIENT);
      LoadReport program =
          cell.controller.load(
              "pick.src",
              """
              DEF PICK( )
              DECL STATUS_T RET
              MYINT=S1.GUN+ALL[2].GUN
              WELD(S1)
              RET=MYINT
              RET={NR 4}
              MYINT=MYINT+RET.NR
              END
              DEF WELD(S:IN)
              DECL SPOT_T S
              MYREAL=S.THICK
              END
              """,
              LoadingMode.LENIENT);

      assertThat(list.problems())
          .extracting(KrlError::message)
          .hasSize(2)
          .allMatch(message -> message.endsWith("type SPOT_T is not declared"));
      assertThat(program.problems()).isEmpty();
      assertThat(cell.controller.check("PICK"))
          .extracting(KrlError::message)
          .containsExactly("type STATUS_T is not declared", "type SPOT_T is not declared");
      cell.controller.robot().select("PICK");
      cell.controller.start();
      cell.runToTheEnd();
      assertThat(cell.get("MYINT")).isEqualTo("13");
      assertThat(cell.get("MYREAL")).isEqualTo("1.50000");
    }

    @Test
    void loadAProgramWithoutEnd() {
      LoadReport report =
          cell.controller.load(
              "cut.src", "DEF CUT()\nINT A_COUNTER_WITH_A_LONG_NAME\nHALT", LoadingMode.LENIENT);

      assertThat(report.problems())
          .extracting(KrlError::toString)
          .containsExactly(
              "cut.src:2:5: a name has at most 24 characters, A_COUNTER_WITH_A_LONG_NAME has 26",
              "cut.src:3:5: expected END, found the end of the file");
      assertThat(cell.controller.programs()).contains("CUT");
    }

    @Test
    void useEveryTypeOfKss() throws IOException {
      String all = LISTS.stream().map(ControllerListsTest::text).collect(Collectors.joining());
      try (Stream<String> lines = Files.lines(TYPES_PAGE)) {
        List<String> types =
            lines
                .filter(line -> line.startsWith("| STRUC") || line.startsWith("| ENUM"))
                .map(line -> line.split("`", -1)[1])
                .toList();
        assertThat(types)
            .hasSizeGreaterThan(150)
            .allSatisfy(type -> assertThat(all).contains("DECL " + type + " "));
      }
    }

    @Test
    void setTheirVariables() throws IOException {
      for (String name : LISTS) {
        cell.controller.load(list(name), LoadingMode.LENIENT);
      }
      assertThat(cell.get("TOOL_NAME[3,]")).isEqualTo("\"D\u00FCse 3 mm\"");
      assertThat(cell.get("BASE_DATA[32].X")).isEqualTo("969.250");
      assertThat(cell.get("LDEFAULT.CB.AUX_PT.ORI")).isEqualTo("#CONSIDER");
      assertThat(cell.get("FDEFAULT.TQ_STATE")).isEqualTo("FALSE");
      assertThat(cell.get("CELL_NAME[]")).isEqualTo("\"Zelle 7 - S\u00FCd; Linie A\"");
      assertThat(cell.get("SEAMS[2].SPEED")).isEqualTo("0.0120000");
      assertThat(cell.get("STATION[1].PARTS[3]")).isEqualTo("12");
      assertThat(cell.get("PALLET[2,3]")).isEqualTo("23.5000");
      assertThat(cell.get("STACK[2,3,1]")).isEqualTo("231");
      assertThat(cell.get("SEPARATOR_CODE")).isEqualTo("59");
      assertThat(cell.get("NEWLINE")).isEqualTo("\"\n\"");
      assertThat(cell.get("SPARE_CODE")).isEqualTo("0");
      assertThat(cell.get("COUNTER_OF_ALL_PARTS_OF_THIS_SHIFT")).isEqualTo("0");
      assertThat(cell.get("$FLAG[12]")).isEqualTo("TRUE");
      assertThat(cell.get("$VEL.CP")).isEqualTo("0.300000");
      assertThat(cell.get("$LOAD.M")).isEqualTo("-1.00000");
      assertThat(cell.get("$SOFTN_END[1]")).isEqualTo("-165.000");
      assertThat(cell.get("$EX_KIN.ET1")).startsWith("#");
      assertThat(cell.get("$PSER_1")).startsWith("{SER: PROTO");
      assertThat(cell.get("$V_CUSTOM[]")).isEqualTo("\"V1.0/SAMPLE\"");
      assertThat(cell.controller.variables().describe("CELL_NAME").orElseThrow().access())
          .isEqualTo(Access.READ_ONLY);
    }

    @Test
    void canBeSavedAndLoadedAgain() throws IOException {
      for (String name : LISTS) {
        cell.controller.load(list(name), LoadingMode.LENIENT);
      }
      String saved = cell.controller.variables().toDataList("SAVED");
      VariableTable table = VariableTable.krc4();

      assertThat(table.load("saved.dat", saved, LoadingMode.LENIENT).problems())
          .extracting(KrlError::message)
          .containsExactly(
              "a name has at most 24 characters, COUNTER_OF_ALL_PARTS_OF_THIS_SHIFT has 34",
              "a name has at most 24 characters, MY_ENERGY_MEASURING_STRUC has 25");
      assertThat(table.get("SEAMS[2]")).isEqualTo(cell.get("SEAMS[2]"));
      assertThat(table.get("NEWLINE")).isEqualTo("\"\n\"");
    }

    @Test
    void ofTheControllerAndOfTheRobotAreLoadedOneAfterTheOther() {
      String steu =
          """
          DEFDAT $MACHINE PUBLIC
          CHAR $V_STEUMADA[32]
          $V_STEUMADA[]="V2"
          INT $NUM_AX=9
          DECL ESYS $ESYS=#EASYS
          ENDDAT
          """;
      LoadReport first = cell.controller.load("$machine.dat", steu, LoadingMode.LENIENT);
      LoadReport second =
          cell.controller.load("$machine.dat", text("$machine.dat"), LoadingMode.LENIENT);

      assertThat(first.problems()).isEmpty();
      assertThat(second.problems()).isEmpty();
      assertThat(cell.get("$NUM_AX")).isEqualTo("6");
      assertThat(cell.get("$V_STEUMADA[]")).isEqualTo("\"V2\"");
    }

    @Test
    void leaveARobotThatRunsPrograms() throws Exception {
      for (String name : LISTS) {
        cell.controller.load(list(name), LoadingMode.LENIENT);
      }
      cell.run("PTP XHOME\nLIN_REL {X 20.0}\nTOOL_DATA[1] = $BASE");
      assertThat(cell.get("$STOPMESS")).isEqualTo("FALSE");
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = {
          "$config.dat | a name has at most 24 characters",
          "$custom.dat | expected ENDDAT",
        })
    void areRefusedByAStrictLoadAsBefore(String name, String reason) throws IOException {
      VariableTable before = cell.controller.variables().copy();
      LoadReport report = cell.controller.load(list(name), LoadingMode.STRICT);

      assertThat(report.anyRefused()).isTrue();
      assertThat(report.problems()).extracting(KrlError::message).anyMatch(m -> m.contains(reason));
      assertThat(cell.controller.variables().names()).isEqualTo(before.names());
      assertThatThrownBy(() -> cell.controller.load(list(name)))
          .isInstanceOf(KrlFileException.class)
          .hasMessageContaining(reason);
    }
  }

  @Nested
  class ALineThatIsNotUnderstood {

    @Test
    void isAWarningWithItsPlaceAndTheRestCounts() {
      LoadReport report =
          load(
              "$CONFIG",
              "INT A=1",
              "INT B=TRUE",
              "DECL NOTHING C",
              "INT D=)(",
              "CHAR E[3]=\"abcd\"",
              "FRAME F={X 1,Q 2,Y 3}",
              "F.X=\"x\"",
              "$OUT[9000]=TRUE",
              "INT A=5",
              "PTP XHOME",
              "INT G=7");

      assertThat(report.files()).extracting(FileReport::outcome).containsExactly(Outcome.WARNINGS);
      assertThat(report.problems())
          .extracting(error -> error.position().line())
          .containsExactly(3, 4, 5, 6, 7, 8, 9, 10, 11);
      assertThat(report.toString())
          .startsWith("x.dat WARNINGS: 9\n  x.dat:3:7: B: needs INT, was given TRUE\n")
          .contains("x.dat:4:1: a type is declared before it is used, type NOTHING");
      assertThat(cell.get("A")).isEqualTo("1");
      assertThat(cell.get("F")).isEqualTo("{FRAME: X 1.00000, Y 3.00000}");
      assertThat(cell.get("G")).isEqualTo("7");
    }

    @Test
    void leavesItsVariableWithoutAValue() {
      assertThat(warnings("$CONFIG", "INT B=TRUE", "B=4", "CHAR E[3]=\"abcd\"")).hasSize(2);
      assertThat(cell.get("B")).isEqualTo("4");
      assertThatThrownBy(() -> cell.get("E[]")).hasMessageContaining("has no value yet");
    }

    @Test
    void refusesAFileThatIsNoKrl() {
      LoadReport report =
          cell.controller.load("x.dat", "a letter\nto nobody\n", LoadingMode.LENIENT);
      assertThat(report.files()).extracting(FileReport::outcome).containsExactly(Outcome.REFUSED);
      assertThat(report.problems()).isNotEmpty();
      assertThat(report.toString()).startsWith("x.dat REFUSED\n  x.dat:1:1: expected DEF");
    }
  }

  @Test
  void aChannelIsAnErrorOfAStrictLoadOnly() {
    assertThat(warnings("$CUSTOM", "CHANNEL :SER_1 :SER_1 $PSER_1")).isEmpty();
    assertThatThrownBy(
            () ->
                cell.controller.load(
                    "x.dat", "DEFDAT $CUSTOM\nCHANNEL :SER_1 :SER_1 $PSER_1\nENDDAT\n"))
        .hasMessage("x.dat:2:1: CHANNEL is not supported by this simulation");
  }

  @Nested
  class TheListOfAProgram {
    @TempDir Path folder;

    private LoadReport loadProgram(String data, LoadingMode mode) throws IOException {
      Files.writeString(folder.resolve("weld.src"), "DEF WELD()\nN = 2\nEND\n");
      return cell.controller.load(
          Files.writeString(folder.resolve("weld.dat"), data).resolveSibling("weld.src"), mode);
    }

    @Test
    void isLoadedWithoutItsWrongLines() throws Exception {
      LoadReport report =
          loadProgram("DEFDAT WELD\nINT N=1\nINT M=TRUE\nENDDAT\n", LoadingMode.LENIENT);

      assertThat(report.files())
          .extracting(FileReport::path, FileReport::outcome)
          .containsExactly(tuple("weld.src", Outcome.LOADED), tuple("weld.dat", Outcome.WARNINGS));
      assertThat(report.problems()).hasToString("[weld.dat:3:7: M: needs INT, was given TRUE]");
      cell.controller.robot().select("WELD");
      cell.controller.robot().start();
      cell.runToTheEnd();
    }

    @Test
    void refusesBothInAStrictLoad() throws Exception {
      LoadReport report =
          loadProgram("DEFDAT WELD\nINT N=1\nINT M=TRUE\nENDDAT\n", LoadingMode.STRICT);

      assertThat(report.files())
          .extracting(FileReport::path, FileReport::outcome)
          .containsExactly(tuple("weld.src", Outcome.REFUSED), tuple("weld.dat", Outcome.REFUSED));
      assertThat(cell.controller.programs()).isEmpty();
    }

    @Test
    void thatIsNoDataListIsRefusedAlone() throws Exception {
      LoadReport report = loadProgram("INT N=1\n", LoadingMode.LENIENT);

      assertThat(report.files())
          .extracting(FileReport::outcome)
          .containsExactly(Outcome.LOADED, Outcome.REFUSED);
      assertThat(cell.controller.programs()).containsExactly("WELD");
    }
  }

  @Nested
  class Types {

    @Test
    void canBeUsedBeforeTheirDeclaration() {
      assertThat(
              warnings(
                  "$CONFIG",
                  "DECL OUTER_T O={I {N 3}}",
                  "STRUC OUTER_T INNER_T I",
                  "STRUC INNER_T INT N,KIND_T K",
                  "ENUM KIND_T A,B"))
          .isEmpty();
      assertThat(cell.get("O.I.N")).isEqualTo("3");
    }

    @Test
    void ofADifferentDeclarationReplaceThoseInStructures() throws Exception {
      cell.set("LDEFAULT.CB.AUX_PT.ORI", "#CONSIDER");
      assertThat(
              warnings(
                  "$CONFIG",
                  "STRUC AUX_PT_MODE AUX_PT_VALUES ORI,E1",
                  "ENUM ORI_TYPE VAR,CONSTANT,JOINT,IGNORE",
                  "LDEFAULT.ORI_TYP=#IGNORE"))
          .hasSize(2);
      assertThat(cell.get("LDEFAULT"))
          .contains("ORI_TYP #IGNORE", "CB {CIRC_MODE: AUX_PT {AUX_PT_MODE: ORI #CONSIDER}}");
      VariableTable saved = VariableTable.empty();
      saved.load("saved.dat", cell.controller.variables().toDataList("SAVED"));
      assertThat(saved.get("LDEFAULT")).isEqualTo(cell.get("LDEFAULT"));
    }

    @Test
    void thatContainTheOneTheyReplaceAreWarnings() {
      assertThat(warnings("$CONFIG", "STRUC AUX_PT_MODE LDAT L,INT N", "DECL AUX_PT_MODE M={N 3}"))
          .hasSize(1);
      assertThat(cell.get("M.N")).isEqualTo("3");
      assertThat(cell.get("LDEFAULT.VEL")).isEqualTo("2.00000");
    }

    @Test
    void ofPositionsWithThreeExternalAxesAreKnown() throws Exception {
      assertThat(
              warnings(
                  "$CONFIG",
                  "DECL E3POS P={X 500.0,Y 0.0,Z 800.0,A 0.0,B 90.0,C 0.0,S 2,T 2,E1 0.0,E3 4.0}",
                  "DECL E3AXIS Q={A1 0.0,A2 -90.0,A3 90.0,A4 0.0,A5 30.0,A6 0.0,E1 0.0}"))
          .isEmpty();
      cell.run("PTP Q\nXHOME = Q\nMYPOS = P");
      assertThat(cell.get("XHOME.A5")).isEqualTo("30.0000");
      assertThat(cell.get("MYPOS.E3")).isEqualTo("4.00000");
      assertThat(cell.get("$AXIS_ACT.A5")).isEqualTo("30.0000");
    }

    @Test
    void thatContainEachOtherAreWarnings() {
      assertThat(warnings("$CONFIG", "STRUC P Q X", "STRUC Q P X", "INT A=1")).hasSize(2);
      assertThat(cell.get("A")).isEqualTo("1");
    }

    @Test
    void thatKssHasCanBeDeclaredAgain() {
      assertThat(
              warnings(
                  "$CONFIG",
                  "STRUC pdat REAL VEL,ACC,REAL APO_DIST,APO_MODE_T APO_MODE,REAL GEAR_JERK,INT"
                      + " EXAX_IGN",
                  "ENUM APO_MODE_T CPTP,CDIS",
                  "DECL PDAT P={VEL 50.0}"))
          .isEmpty();
    }

    @Test
    void ofADifferentDeclarationReplaceThoseOfKssWithAWarning() throws Exception {
      assertThat(
              warnings("$CONFIG", "STRUC PDAT REAL VEL,ACC,APO_DIST,INT EXTRA", "PDAT_ACT.EXTRA=4"))
          .containsExactly(
              "x.dat:2:1: type PDAT is known with other parts; this declaration replaces it");
      assertThat(cell.get("PDAT_ACT"))
          .isEqualTo("{PDAT: VEL 100.000, ACC 100.000, APO_DIST 100.000, EXTRA 4}");
      assertThat(warnings("$CONFIG", "STRUC PDAT REAL VEL,ACC,APO_DIST,INT EXTRA")).isEmpty();
      assertThat(cell.controller.variables().toDataList("X")).contains("INT EXTRA");
    }
  }

  @Nested
  class UnknownSystemVariables {

    @Test
    void keepWhatAListWritesAfterOneWarning() {
      assertThat(
              warnings(
                  "$CUSTOM",
                  "$TORQMON_X[1]=200",
                  "$TORQMON_X[2]=150",
                  "$MSG_X={VALID FALSE,TYPE #INFO,NAME[] \"M\"}",
                  "$MSG_X.VALID=TRUE",
                  "$TEXT_X[]=\"abc\""))
          .containsExactly(
              "x.dat:2:1: the system variable $TORQMON_X is not known; it keeps what is written to"
                  + " it",
              "x.dat:4:1: the system variable $MSG_X is not known; it keeps what is written to it",
              "x.dat:6:1: the system variable $TEXT_X is not known; it keeps what is written to"
                  + " it");
      assertThat(cell.get("$TORQMON_X[2]")).isEqualTo("150");
      assertThat(cell.get("$MSG_X")).isEqualTo("{VALID TRUE, TYPE #INFO, NAME[] \"M\"}");
      assertThat(cell.get("$TEXT_X[]")).isEqualTo("\"abc\"");
      assertThatThrownBy(() -> cell.get("$TORQMON_X[3]")).hasMessageContaining("has no value yet");
      assertThat(cell.controller.variables().describe("$MSG_X").orElseThrow().type())
          .isEqualTo("UNKNOWN");
    }

    @Test
    void keepWhatAProgramWritesAfterOneWarning() throws Exception {
      String program = "DEF TEST()\n$TORQMON_X[1] = 200\n$TORQMON_X[2] = $TORQMON_X[1]/4\nEND\n";
      assertThat(cell.controller.load("test.src", program, LoadingMode.LENIENT).problems())
          .isEmpty();
      assertThat(cell.controller.check("TEST"))
          .hasToString(
              "[test.src:2:1: the system variable $TORQMON_X is not known; it keeps what is"
                  + " written to it]");
      cell.controller.robot().select("TEST");
      cell.controller.robot().start();
      cell.runToTheEnd();
      assertThat(cell.get("$TORQMON_X[2]")).isEqualTo("50");
      cell.controller.load("other.src", "DEF OTHER()\nEND\n", LoadingMode.LENIENT);
      assertThat(cell.controller.check("TEST")).hasSize(1);
      assertThat(cell.get("$TORQMON_X[2]")).isEqualTo("50");
    }

    @Test
    void stopAProgramThatReadsThemBeforeAWrite() throws Exception {
      String program = "DEF TEST()\nIF $COLLMON_X THEN\nHALT\nENDIF\nEND\n";
      cell.controller.load("test.src", program, LoadingMode.LENIENT);
      cell.controller.robot().select("TEST");
      cell.controller.robot().start();
      cell.until(() -> !cell.controller.messages().isEmpty());
      assertThat(cell.message()).contains("$COLLMON_X: has no value yet");
    }

    @Test
    void areErrorsOfAStrictProgram() throws Exception {
      cell.load("DEF TEST()\n$TORQMON_X = 200\nEND\n");
      assertThat(cell.controller.check("TEST"))
          .hasToString("[test.src:2:1: no variable $TORQMON_X is declared]");
    }

    @Test
    void areErrorsOfAStrictLoad() {
      assertThatThrownBy(() -> cell.controller.load("x.dat", "DEFDAT $X\n$TORQMON_X=1\nENDDAT\n"))
          .hasMessage("x.dat:2:1: no variable $TORQMON_X is declared");
    }

    @Test
    void areNotSetByTheListOfAProgram() {
      assertThat(warnings("WELD", "$TORQMON_X=1"))
          .containsExactly(
              "x.dat:2:1: a data list sets only its own variables, $TORQMON_X is not declared in"
                  + " it");
      assertThat(cell.controller.variables().contains("$TORQMON_X")).isFalse();
    }
  }
}
