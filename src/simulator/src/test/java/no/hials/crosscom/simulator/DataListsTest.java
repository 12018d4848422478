package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.lang.KrlError;
import no.hials.crosscom.lang.Position;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlString;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Loading the user's own data lists into the table, and saving its state as one. */
class DataListsTest {
  private final VariableTable table = VariableTable.krc4();

  @TempDir Path directory;

  private static String userConfig() throws IOException {
    try (InputStream in = DataListsTest.class.getResourceAsStream("user-config.dat")) {
      return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
    }
  }

  private static String system(String... lines) {
    return "DEFDAT $CONFIG PUBLIC\n" + String.join("\n", lines) + "\nENDDAT\n";
  }

  private List<KrlError> errorsOf(String text) {
    KrlFileException e =
        catchThrowableOfType(KrlFileException.class, () -> table.load("x.dat", text));
    assertThat(e).isNotNull();
    return e.errors();
  }

  @Nested
  class Loading {

    @Test
    void takesAUsersConfig() throws Exception {
      table.load("user-config.dat", userConfig());

      assertThat(table.get("TOOL_DATA[1].Y")).isEqualTo("-0.250000");
      assertThat(table.get("TOOL_NAME[1,]")).isEqualTo("\"Fr\u00e4ser \u00d88\"");
      assertThat(table.get("TOOL_NAME[2,]")).isEqualTo("\"probe; not {a} comment\"");
      assertThat(table.get("LOAD_DATA[1].CM.X")).isEqualTo("10.0000");
      assertThat(table.get("JOB.STATIONS[]")).isEqualTo("#MILL #PROBE ");
      assertThat(table.get("JOB.POINTS[1].AT.Z")).isEqualTo("-3.00000");
      assertThat(table.get("JOB.POINTS[1].LABEL[]")).isEqualTo("\"start\"");
      assertThat(table.get("JOB.POINTS[4].LABEL[]")).isEqualTo("\"end\"");
      assertThat(table.get("MASK")).isEqualTo("5");
      assertThat(table.get("LIMIT")).isEqualTo("255");
      assertThat(table.get("SUM[4]")).isEqualTo("-7");
      assertThat(table.get("GRID[2,3]")).isEqualTo("-0.100000");
      assertThat(table.get("STATUS[]")).isEqualTo("\"l\u00e4uft\"");
      assertThat(table.get("LETTER")).isEqualTo("\"Z\"");
      assertThat(table.get("PART_SEEN")).isEqualTo("TRUE");
      assertThat(table.get("GRIPPER_OPEN")).isEqualTo("FALSE");
      assertThat(table.get("PART_NO")).isEqualTo("0");
      assertThat(table.get("POINT_COUNT")).isEqualTo("4");
    }

    @Test
    void letsClientsWriteWhatIsDeclaredUnlessItIsConst() throws Exception {
      table.load("user-config.dat", userConfig());
      table.write("JOB.POINTS[2].SPEED", "0.5", 255);
      assertThat(table.get("JOB.POINTS[2].SPEED")).isEqualTo("0.500000");
      assertThatExceptionOfType(RefusedException.class)
          .isThrownBy(() -> table.write("POINT_COUNT", "5", 255))
          .matches(e -> e.reason() == Refusal.READ_ONLY);
    }

    @Test
    void replacesWhatTheControllerHasAndKeepsTheRest() throws Exception {
      assertThat(table.get("TOOL_DATA[3].X")).isEqualTo("0.0");
      table.load("user-config.dat", userConfig());
      assertThat(table.get("TOOL_DATA[3]")).isEqualTo("{FRAME: }");
      assertThat(table.get("DEF_VEL_PTP")).isEqualTo("80");
      assertThat(table.get("$OV_PRO")).isEqualTo("100");
    }

    @Test
    void keepsTheRightsOfClientsToSystemVariables() throws Exception {
      table.load(
          "machine.dat",
          """
          DEFDAT $MACHINE PUBLIC
          INT $NUM_AX=4
          REAL $SOFTN_END[12]
          $SOFTN_END[1]=-100.0
          ENDDAT\
          """);
      assertThat(table.get("$NUM_AX")).isEqualTo("4");
      assertThat(table.describe("$NUM_AX").orElseThrow().access()).isEqualTo(Access.READ_ONLY);
      table.write("$SOFTN_END[1]", "-90.0", 255);
    }

    @Test
    void setsElementsOfSystemVariablesThatAreNotDeclaredAgain() throws Exception {
      table.load("c.dat", system("$SOFTP_END[1]=100.0", "$BASE.X=5.0"));
      assertThat(table.get("$SOFTP_END[1]")).isEqualTo("100.000");
      assertThat(table.get("$SOFTP_END[2]")).isEqualTo("45.0000");
      assertThat(table.get("$BASE")).startsWith("{FRAME: X 5.00000, Y 0.0");
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n"})
    void takesFilesInLatin1WithTheLineEndsOfAnySystem(String lineEnd) throws Exception {
      Path file = directory.resolve("points.dat");
      String text = system("CHAR GREETING[8]", "GREETING[]=\"gr\u00fc\u00df\"", "INT NEXT=1");
      Files.write(file, text.replace("\n", lineEnd).getBytes(StandardCharsets.ISO_8859_1));
      table.load(file);
      assertThat(table.value("GREETING[]")).isEqualTo(new KrlString("gr\u00fc\u00df"));
      assertThat(table.get("NEXT")).isEqualTo("1");
    }

    @Test
    void showsClientsOfAModuleOnlyWhatItMakesGlobal() throws Exception {
      table.load("m.dat", "DEFDAT M PUBLIC\nGLOBAL INT SHARED=1\nINT OWN=2\nENDDAT");
      assertThat(table.get("SHARED")).isEqualTo("1");
      assertThat(table.contains("OWN")).isFalse();
    }

    @Test
    void changesNothingIfAnythingIsWrong() {
      String before = table.toDataList("X");
      List<KrlError> errors =
          errorsOf(
              system(
                  "STRUC S INT A",
                  "ENUM MODE_OP ONLY",
                  "INT $OV_PRO=5",
                  "INT MYINT=#T1",
                  "DECL NOTHING N"));
      assertThat(errors).hasSize(2);
      assertThat(table.toDataList("X")).isEqualTo(before);
      assertThat(table.contains("S")).isFalse();
    }

    @Test
    void saysAllThatIsWrongInTheOrderOfTheFile() {
      KrlFileException e =
          catchThrowableOfType(
              KrlFileException.class,
              () ->
                  table.load(
                      "x.dat",
                      system("INT A=TRUE", "INT B=", "CHAR C[3]=\"abcd\"", "$OUT[5000]=TRUE")));
      assertThat(e.errors())
          .extracting(KrlError::position)
          .extracting(Position::file, Position::line)
          .containsExactly(
              tuple("x.dat", 2), tuple("x.dat", 3), tuple("x.dat", 4), tuple("x.dat", 5));
      assertThat(e.getMessage().lines())
          .hasSize(4)
          .contains(
              "x.dat:2:7: A: needs INT, was given TRUE",
              "x.dat:4:11: C: holds 3 characters, was given 4",
              "x.dat:5:1: $OUT[5000]: an index is 1 to 4096, was given [5000]");
    }

    @Test
    void showsTheFirstTwentyErrorsInItsMessage() {
      String[] lines = new String[22];
      for (int i = 0; i < lines.length; i++) {
        lines[i] = "INT X" + i + "=FALSE";
      }
      KrlFileException e =
          catchThrowableOfType(KrlFileException.class, () -> table.load("x.dat", system(lines)));
      assertThat(e.errors()).hasSize(22);
      assertThat(e.getMessage().lines()).hasSize(21).last().isEqualTo("and 2 more");
    }

    @Test
    void refusesWhatIsNoDataList() {
      assertThat(errorsOf("DEF MAIN()\nPTP NOWHERE {\nEND\n"))
          .singleElement()
          .hasToString("x.dat:1:1: a data list begins with DEFDAT, found the program MAIN");
      assertThat(errorsOf(""))
          .singleElement()
          .extracting(KrlError::position)
          .isEqualTo(new Position("x.dat", 1, 1));
      assertThat(errorsOf("; only a comment\n")).hasSize(1);
    }

    @Test
    void saysWhyAFileCannotBeRead() {
      Path missing = directory.resolve("missing.dat");
      assertThatThrownBy(() -> table.load(missing))
          .isInstanceOf(NoSuchFileException.class)
          .hasMessageContainingAll(missing.toString(), "the data list does not exist");
      assertThatThrownBy(() -> table.load(directory))
          .isInstanceOf(FileSystemException.class)
          .hasMessageContainingAll(directory.toString(), "this is a directory");
    }

    @Test
    void namesTheFileInItsMessages() throws IOException {
      Path file = directory.resolve("wrong.dat");
      Files.writeString(file, system("INT A=TRUE"));
      assertThatThrownBy(() -> table.load(file))
          .hasMessage(file + ":2:7: A: needs INT, was given TRUE");
    }

    @Test
    void keepsWhatIsBoundFollowingItsSource() throws Exception {
      table.scope().bind("$OV_ACT", () -> new KrlInt(42));
      table.load("c.dat", system("INT $OV_ACT=7"));
      assertThat(table.get("$OV_ACT")).isEqualTo("42");
      assertThat(errorsOf(system("REAL $OV_ACT=7.0", "SIGNAL $OV_ACT FALSE")))
          .extracting(KrlError::message)
          .containsExactly(
              "the controller sets $OV_ACT, expected INT, found REAL",
              "a data list declares a name once, $OV_ACT is declared again");
      assertThat(errorsOf(system("SIGNAL $OV_ACT FALSE")))
          .extracting(KrlError::message)
          .containsExactly("the controller sets $OV_ACT, expected INT, found SIGNAL");
      table.scope().bind("$CURR_ACT", () -> new KrlReal(1));
      assertThat(errorsOf(system("REAL $CURR_ACT[6]")))
          .extracting(KrlError::message)
          .containsExactly("the controller sets $CURR_ACT, expected REAL[12], found REAL[6]");
    }
  }

  @Nested
  class Describing {

    @Test
    void tellsWhatTheBuiltInListsSay() {
      assertThat(table.describe("$pos_act"))
          .contains(
              new VariableInfo(
                  "$POS_ACT",
                  "E6POS",
                  List.of(),
                  Access.READ_ONLY,
                  "mm/deg",
                  "commanded tool centre point in the base frame",
                  "FIW RSIB VSC"));
      assertThat(table.describe("TOOL_NAME").orElseThrow().dimensions()).containsExactly(16, 24);
      assertThat(table.describe("$T1").orElseThrow().type()).isEqualTo("SIGNAL");
      assertThat(table.describe("$OV_PRO").orElseThrow().unit()).isEqualTo("%");
      assertThat(table.describe("$NUM_AX").orElseThrow().unit()).isEmpty();
      assertThat(table.describe("NO_SUCH")).isEmpty();
    }

    @Test
    void takesTheCommentOfAUsersDeclarationAsItsMeaning() throws Exception {
      table.load("user-config.dat", userConfig());
      assertThat(table.describe("JOB"))
          .contains(
              new VariableInfo(
                  "JOB", "PATH_T", List.of(), Access.READ_WRITE, "", "what the cell works on", ""));
      assertThat(table.describe("PART_NO").orElseThrow().meaning())
          .isEqualTo("number of the part on the table");
    }

    @Test
    void forgetsWhatNoLongerHolds() {
      table.declare("$SOFTN_END[2]", "REAL", null);
      assertThat(table.describe("$SOFTN_END").orElseThrow().meaning()).isEmpty();
      table.declare("$T1", "SIGNAL", "$OUT[5]");
      assertThat(table.describe("$T1").orElseThrow().meaning()).isEmpty();
      table.remove("$T2");
      table.declare("$T2", "BOOL", "TRUE");
      assertThat(table.describe("$T2").orElseThrow().meaning()).isEmpty();
      assertThat(VariableTable.krc4().describe("$T1").orElseThrow().meaning()).isNotEmpty();
    }

    @Test
    void isKeptByCopies() {
      assertThat(table.copy().describeAll()).isEqualTo(table.describeAll());
    }
  }

  @Nested
  class Saving {
    private final VariableTable small = VariableTable.empty();

    private VariableTable savedAndLoaded(VariableTable from) throws KrlFileException {
      VariableTable loaded = VariableTable.empty();
      loaded.load("saved.dat", from.toDataList("SAVED"));
      assertThat(loaded.toDataList("SAVED")).isEqualTo(from.toDataList("SAVED"));
      assertThat(loaded.describeAll()).isEqualTo(from.describeAll());
      return loaded;
    }

    @Test
    void givesBackTheStateOfAUsersOwnVariables() throws Exception {
      table.load("user-config.dat", userConfig());
      table.write("JOB.POINTS[3].SPEED", "1.75", 255);
      VariableTable loaded = savedAndLoaded(table);
      assertThat(loaded.get("JOB")).isEqualTo(table.get("JOB"));
      assertThat(loaded.get("GRID[2,3]")).isEqualTo("-0.100000");
      assertThatThrownBy(() -> loaded.get("UNSET")).hasMessageContaining("no value");
    }

    @Test
    void savesATextThatWindows1252CannotHold() throws Exception {
      small.declare("GREETING[5]", "CHAR", "\"\u4F60\u597D\"");
      Path file = directory.resolve("state.dat");
      small.save(file);
      VariableTable loaded = VariableTable.empty();
      loaded.load(file);
      assertThat(loaded.get("GREETING[]")).isEqualTo("\"\u4F60\u597D\"");
    }

    @Test
    void givesBackEveryCharacterOfATextThatALineCanHold() throws Exception {
      StringBuilder all = new StringBuilder();
      for (char c = 0; c <= 0xFF; c++) {
        if (c != '"' && c != '\n' && c != '\r') {
          all.append(c);
        }
      }
      KrlString text = new KrlString(all.toString());
      small.declare("EVERYTHING[256]", "CHAR", null);
      small.set("EVERYTHING[]", text);
      Path file = directory.resolve("state.dat");
      small.save(file);
      VariableTable loaded = VariableTable.empty();
      loaded.load(file);
      assertThat(loaded.value("EVERYTHING[]")).isEqualTo(text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"two\nlines", "two\rlines"})
    void refusesATextWithALineBreak(String text) {
      small.declare("TOOL_NAME[3,24]", "CHAR", null);
      small.set("TOOL_NAME[3,]", new KrlString(text));
      assertThatThrownBy(() -> small.toDataList("X"))
          .isInstanceOf(IllegalStateException.class)
          .hasMessage("a text in a data list has no line break, TOOL_NAME[3,] has one");
    }

    @Test
    void givesBackNumbersAtTheirLimits() throws Exception {
      small.declare("MYINTS[2]", "INT", null);
      small.declare("MYREALS[6]", "REAL", null);
      small.set("MYINTS[1]", new KrlInt(Integer.MIN_VALUE));
      small.set("MYINTS[2]", new KrlInt(Integer.MAX_VALUE));
      float[] reals = {Float.MIN_VALUE, Float.MAX_VALUE, -Float.MIN_NORMAL, 1f / 3, 1e19f, 123456};
      for (int i = 0; i < reals.length; i++) {
        small.set("MYREALS[" + (i + 1) + "]", new KrlReal(reals[i]));
      }
      VariableTable loaded = savedAndLoaded(small);
      assertThat(loaded.value("MYINTS[]")).isEqualTo(small.value("MYINTS[]"));
      assertThat(loaded.value("MYREALS[]")).isEqualTo(small.value("MYREALS[]"));
    }

    @Test
    void givesBackArraysInStructuresInArrays() throws Exception {
      small.declareEnum("COLOUR", "red", "Green");
      small.declareStruc("STRUC INNER CHAR NAME[5],NAMES[2,5], COLOUR C[2]");
      small.declareStruc("STRUC OUTER INNER I[2],ONE, BOOL GRID[2,2]");
      small.declare("DEEP[2]", "OUTER", null);
      small.declare("$DEEP[2]", "OUTER", null);
      small.set("DEEP[2].I[1].NAMES[2,]", "\"ab\"");
      small.set("DEEP[2].I[1].C[2]", "#GREEN");
      small.set("DEEP[2].GRID[2,1]", "TRUE");
      small.set("DEEP[1].ONE", "{NAME[] \"x\",C[1] #red}");
      small.set("$DEEP[1].ONE.C[1]", "#RED");
      VariableTable loaded = savedAndLoaded(small);
      for (String name : List.of("DEEP[1]", "DEEP[2]", "$DEEP[1]", "$DEEP[2]")) {
        assertThat(loaded.get(name)).isEqualTo(small.get(name));
      }
    }

    @Test
    void keepsWhatIsUninitialisedSo() throws Exception {
      small.declareStruc("STRUC POINT REAL X,Y");
      small.declare("PARTLY[3]", "POINT", null);
      small.set("PARTLY[2]", "{Y 2.0}");
      small.declare("$MOST[3]", "INT", "7");
      small.set("$MOST[2]", "8");
      small.declare("$SOME[3]", "INT", null);
      small.set("$SOME[2]", "8");
      small.declare("$PAIRS[3]", "POINT", "{X 1,Y 2}");
      VariableTable loaded = savedAndLoaded(small);
      assertThat(loaded.get("PARTLY[1]")).isEqualTo("{POINT: }");
      assertThat(loaded.get("PARTLY[2]")).isEqualTo("{POINT: Y 2.00000}");
      assertThat(loaded.get("$MOST[]")).isEqualTo("7 8 7 ");
      assertThat(loaded.get("$PAIRS[3]")).isEqualTo("{POINT: X 1.00000, Y 2.00000}");
      assertThatThrownBy(() -> loaded.get("$SOME[1]")).hasMessageContaining("no value");
    }

    @Test
    void keepsRightsAndWiring() throws Exception {
      small.declare("$OUT[8]", "BOOL", "FALSE");
      small.declare("FIXED", "INT", Access.READ_ONLY, "5");
      small.declare("FIXED_LIST[2]", "INT", Access.READ_ONLY, "5 6");
      small.declare("MY_SIGNAL", "SIGNAL", "$OUT[5] TO $OUT[8]");
      assertThat(small.toDataList("X")).contains("\r\nCONST INT FIXED=5\r\n");
      VariableTable loaded = savedAndLoaded(small);
      assertThat(loaded.describe("FIXED").orElseThrow().access()).isEqualTo(Access.READ_ONLY);
      assertThat(loaded.describe("FIXED_LIST").orElseThrow().access()).isEqualTo(Access.READ_ONLY);
      loaded.set("MY_SIGNAL", "9");
      assertThat(loaded.get("$OUT[8]")).isEqualTo("TRUE");
    }

    @Test
    void writesWhatIsBoundAsItsValue() throws Exception {
      small.declare("$OV_ACT", "INT", "1");
      small.scope().bind("$OV_ACT", () -> new KrlInt(42));
      assertThat(savedAndLoaded(small).get("$OV_ACT")).isEqualTo("42");
      small.scope().bind("$OV_ACT", () -> new KrlString("no number"));
      assertThatThrownBy(() -> small.toDataList("X"))
          .isInstanceOf(IllegalStateException.class)
          .hasMessageContainingAll("$OV_ACT", "needs INT");
    }

    @Test
    void savesSomeVariablesWithTheTypesTheyUse() throws Exception {
      table.load("user-config.dat", userConfig());
      Path file = directory.resolve("my.points-1.dat");
      table.save(file, name -> name.equals("JOB"));
      String text = Files.readString(file, StandardCharsets.ISO_8859_1);
      assertThat(text)
          .startsWith("&ACCESS RVP\r\nDEFDAT $MY_POINTS_1 PUBLIC\r\n")
          .contains("STRUC FRAME ", "STRUC POINT_T ", "ENUM STATION_T ", "DECL PATH_T JOB=")
          .doesNotContain("E6POS", "GRID");
      VariableTable loaded = VariableTable.empty();
      loaded.load(file);
      assertThat(loaded.names()).containsExactly("JOB");
    }

    @ParameterizedTest
    @CsvSource({
      "STATE,$STATE",
      "$state,$STATE",
      "my points.2.dat,$MY_POINTS_2",
      "a-name-that-is-far-too-long-for-krl,$A_NAME_THAT_IS_FAR_TOO_",
    })
    void givesTheListANameThatKrlAllows(String name, String krlName) throws Exception {
      String text = small.toDataList(name);
      assertThat(text).contains("DEFDAT " + krlName + " PUBLIC\r\n");
      small.load("x.dat", text);
    }

    @Test
    void refusesTwoTypesOfOneName() {
      small.declareStruc("STRUC S INT A");
      small.declare("OLD", "S", null);
      small.declareStruc("STRUC S INT B");
      assertThatThrownBy(() -> small.toDataList("X"))
          .isInstanceOf(IllegalStateException.class)
          .hasMessageContaining("two types S");
    }
  }
}
