package no.hials.crosscom.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import no.hials.crosscom.lang.Access;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.protocol.value.KrlString;
import no.hials.crosscom.protocol.value.KrlStruct;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The accesses of clients, and the printed values. */
class VariableTableTest {
  private final VariableTable table = VariableTable.krc4();

  private String read(String name) {
    try {
      return table.read(name);
    } catch (RefusedException e) {
      throw new AssertionError(name + " was refused: " + e.getMessage(), e);
    }
  }

  private void write(String name, String value) {
    try {
      table.write(name, value, 255);
    } catch (RefusedException e) {
      throw new AssertionError(name + " was refused: " + e.getMessage(), e);
    }
  }

  private void assertReadRefused(String name, Refusal reason) {
    RefusedException e = catchThrowableOfType(RefusedException.class, () -> table.read(name));
    assertThat(e).as("read of " + name).isNotNull();
    assertThat(e.reason()).as(e.getMessage()).isEqualTo(reason);
  }

  private void assertWriteRefused(String name, String value, Refusal reason) {
    RefusedException e =
        catchThrowableOfType(RefusedException.class, () -> table.write(name, value, 255));
    assertThat(e).as("write of " + name + " = " + value).isNotNull();
    assertThat(e.reason()).as(e.getMessage()).isEqualTo(reason);
  }

  @Test
  @SuppressWarnings("NullAway") // on purpose
  void aDeclarationWithoutNameTypeOrAccessIsRefused() {
    assertThatNullPointerException()
        .isThrownBy(() -> table.declare(null, "INT", null))
        .withMessage("name");
    assertThatNullPointerException()
        .isThrownBy(() -> table.declare("X", null, null))
        .withMessage("type");
    assertThatNullPointerException()
        .isThrownBy(() -> table.declare("X", "INT", null, null))
        .withMessage("access");
    assertThat(table.contains("null")).isFalse();
  }

  @Nested
  class Reading {

    @Test
    void printsPositionsAsAKrc4() {
      assertThat(read("$POS_ACT"))
          .isEqualTo(
              "{E6POS: X 525.000, Y 0.0, Z 890.000, A 0.0, B 90.0000, C 0.0, S 2, T 2,"
                  + " E1 0.0, E2 0.0, E3 0.0, E4 0.0, E5 0.0, E6 0.0}");
      assertThat(read("$AXIS_ACT"))
          .isEqualTo(
              "{E6AXIS: A1 0.0, A2 -90.0000, A3 90.0000, A4 0.0, A5 0.0, A6 0.0,"
                  + " E1 0.0, E2 0.0, E3 0.0, E4 0.0, E5 0.0, E6 0.0}");
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        quoteCharacter = '\0',
        value = {
          "$OV_PRO|100",
          "$ov_pro|100",
          " $OV_PRO |100",
          "$MODE_OP|#T1",
          "$MOVE_BCO|FALSE",
          "$VEL_ACT|0.0",
          "$VEL.CP|2.00000",
          "$NEARPATHTOL|200.000",
          "MYCHAR|\"A\"",
          "$MODEL_NAME[]|\"#KR6R900 C4SR FLR 230\"",
          "$PRO_NAME1[]|\" \"",
          "$POS_ACT.X|525.000",
          "$Pos_Act.x|525.000",
          "$MAMES[2]|-90.0000",
          "LOAD_DATA[1].M|2.50000",
          "LOAD_DATA[2].M|-1.00000",
          "LOAD_DATA[1].CM.X|0.0",
          "LOAD_DATA[1].CM|{FRAME: X 0.0, Y 0.0, Z 0.0, A 0.0, B 0.0, C 0.0}",
          "LOAD_DATA[ 1 ].J|{INERTIA: X 0.0, Y 0.0, Z 0.0}",
          "$AXIS_SEQ[]|1 2 3 4 5 6 ",
          "TOOL_TYPE[3]|#NONE",
          "TOOL_NAME[1,]|\"FLANGE\"",
          "TOOL_NAME[2,]|\" \"",
          "TOOL_NAME[1,2]|\"L\"",
          "TOOL_NAME[1,7]|\" \"",
          "$MODEL_NAME[2]|\"K\"",
          "$PRO_IP0.NAME[]|\" \"",
          "$PRO_IP0.SI01.SNR|0",
        })
    void printsWhatANameStandsFor(String name, String text) {
      // the annotation strips unquoted columns
      assertThat(read(name).strip()).isEqualTo(text.strip());
    }

    @Test
    void endsTheTextOfAWholeArrayWithABlank() {
      assertThat(read("$AXIS_DIR[]")).isEqualTo("-1 1 1 -1 -1 -1 0 0 0 0 0 0 ");
      assertThat(read("$MAMES[]"))
          .isEqualTo("0.0 -90.0000 90.0000 0.0 0.0 0.0 0.0 0.0 0.0 0.0 0.0 0.0 ");
      assertThat(read("MYBOOLS[]"))
          .isEqualTo("FALSE FALSE FALSE FALSE FALSE FALSE FALSE FALSE FALSE FALSE ");
      assertThat(read("TOOL_TYPE[]")).startsWith("#NONE #NONE ").hasSize(6 * 16);
    }

    @Test
    void printsOnlyTheInitialisedComponents() {
      table.declare("PARTLY", "E6POS", "{X 1,E1 2.5}");
      table.declare("HOLLOW", "LOAD", "{CM {Z 3}}");
      table.declare("EMPTY", "E6POS", null);
      assertThat(read("PARTLY")).isEqualTo("{E6POS: X 1.00000, E1 2.50000}");
      assertThat(read("HOLLOW")).isEqualTo("{LOAD: CM {FRAME: Z 3.00000}}");
      assertThat(read("EMPTY")).isEqualTo("{E6POS: }");
      assertThat(read("HOLLOW.J")).isEqualTo("{INERTIA: }");
      assertReadRefused("PARTLY.Y", Refusal.NOT_INITIALISED);
    }

    @Test
    void failsForWhatHasNoValue() {
      table.declare("EMPTY", "INT", null);
      table.declare("NONE[3]", "INT", null);
      table.declare("TEXT[3]", "CHAR", null);
      table.set("NONE[2]", "5");
      assertReadRefused("EMPTY", Refusal.NOT_INITIALISED);
      assertReadRefused("NONE[1]", Refusal.NOT_INITIALISED);
      assertReadRefused("NONE[]", Refusal.NOT_INITIALISED);
      assertReadRefused("TEXT[]", Refusal.NOT_INITIALISED);
      assertReadRefused("TEXT[1]", Refusal.NOT_INITIALISED);
      assertThat(read("NONE[2]")).isEqualTo("5");
    }

    @ParameterizedTest
    @CsvSource({
      "NOSUCH,UNKNOWN_VARIABLE",
      "NOSUCH.X,UNKNOWN_VARIABLE",
      "'',UNKNOWN_VARIABLE",
      "' ',UNKNOWN_VARIABLE",
      "1A,UNKNOWN_VARIABLE",
      "$POS_ACT..X,UNKNOWN_VARIABLE",
      "$POS_ACT X,UNKNOWN_VARIABLE",
      "'$OUT[1,2,3,4]',UNKNOWN_VARIABLE",
      "$OUT[-1],UNKNOWN_VARIABLE",
      "$OUT[1;2],UNKNOWN_VARIABLE",
      "$OUT[1]x,UNKNOWN_VARIABLE",
      "$POS_ACT.Q,UNKNOWN_COMPONENT",
      "$OV_PRO.X,UNKNOWN_COMPONENT",
      "$POS_ACT.X.Y,UNKNOWN_COMPONENT",
      "$T1.X,UNKNOWN_COMPONENT",
      "$OV_PRO[1],BAD_INDEX",
      "$OV_PRO[],BAD_INDEX",
      "$POS_ACT[1],BAD_INDEX",
      "$POS_ACT.X[1],BAD_INDEX",
      "$T1[1],BAD_INDEX",
      "$OUT,BAD_INDEX",
      "$OUT[0],BAD_INDEX",
      "$OUT[4097],BAD_INDEX",
      "$OUT[9999999999],BAD_INDEX",
      "'$OUT[1,2]',BAD_INDEX",
      "'$OUT[1,]',BAD_INDEX",
      "$MODEL_NAME,BAD_INDEX",
      "$MODEL_NAME[0],BAD_INDEX",
      "$MODEL_NAME[33],BAD_INDEX",
      "'$MODEL_NAME[1,1]',BAD_INDEX",
      "TOOL_NAME,BAD_INDEX",
      "TOOL_NAME[],BAD_INDEX",
      "TOOL_NAME[1],BAD_INDEX",
      "'TOOL_NAME[17,]',BAD_INDEX",
      "'TOOL_NAME[1,25]',BAD_INDEX",
      "LOAD_DATA[17].M,BAD_INDEX",
      "LOAD_DATA.M,BAD_INDEX",
      "LOAD_DATA,BAD_INDEX",
      "LOAD_DATA[],WHOLE_ARRAY",
    })
    void failsForWhatIsNotThere(String name, Refusal reason) {
      assertReadRefused(name, reason);
    }

    @Test
    void findsElementsOfTwoDimensions() {
      table.declare("M[2,3]", "INT", "11 12 13 21 22 23");
      assertThat(read("M[1,1]")).isEqualTo("11");
      assertThat(read("M[1,3]")).isEqualTo("13");
      assertThat(read("M[2,1]")).isEqualTo("21");
      assertThat(read("m[ 2 , 3 ]")).isEqualTo("23");
      assertReadRefused("M[2]", Refusal.BAD_INDEX);
      assertReadRefused("M[3,1]", Refusal.BAD_INDEX);
      assertReadRefused("M[1,4]", Refusal.BAD_INDEX);
      assertReadRefused("M[1,]", Refusal.BAD_INDEX);
      assertReadRefused("M[]", Refusal.BAD_INDEX);
    }
  }

  @Nested
  class Writing {

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        quoteCharacter = '\0',
        value = {
          "MYINT|-2147483648|-2147483648",
          "MYINT|'B0101'|5",
          "MYINT|'HFF'|255",
          "myint| 7 |7",
          "MYREAL|1.5|1.50000",
          "MYINT|50.0|50",
          "MYINT|-2.0E+03|-2000",
          "MYREAL|3|3.00000",
          "MYREAL|1E5|100000.0",
          "MYBOOL|TRUE|TRUE",
          "MYBOOL|true|TRUE",
          "MYBOOL|FaLsE|FALSE",
          "MYCHAR|\"B\"|\"B\"",
          "MYENUM|#AUT|#AUT",
          "MYENUM|#aut|#AUT",
          "MYSTRING[]|\"a,{b}\"|\"a,{b}\"",
          "MYSTRING[]|\"\"|\" \"",
          "MYSTRING[]|\"12345678901234567890123456789012\"|\"12345678901234567890123456789012\"",
          "MYINTS[10]|5|5",
          "MYBOOLS[1]|TRUE|TRUE",
          "TOOL_NAME[16,]|\"GRIPPER\"|\"GRIPPER\"",
          "TOOL_NAME[1,1]|\"X\"|\"X\"",
          "TOOL_TYPE[2]|#TCP|#TCP",
          "$BASE.X|12|12.0000",
          "LOAD_DATA[3].CM.Z|0.5|0.500000",
          "$VEL.CP|1|1.00000",
          "$OUT[1]|TRUE|TRUE",
        })
    void storesWhatIsOfTheVariablesType(String name, String value, String read) {
      write(name, value);
      assertThat(read(name)).isEqualTo(read);
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        quoteCharacter = '\0',
        value = {
          "MYINT|1.5|WRONG_TYPE",
          "MYINT|3E9|WRONG_TYPE",
          "MYINT|TRUE|WRONG_TYPE",
          "MYINT|#T1|WRONG_TYPE",
          "MYINT|\"1\"|WRONG_TYPE",
          "MYINT|{X 1}|WRONG_TYPE",
          "MYINT|1 2|WRONG_TYPE",
          "MYINT|2147483648|NO_VALUE",
          "MYINT|x|NO_VALUE",
          "MYINT||NO_VALUE",
          "MYREAL|TRUE|WRONG_TYPE",
          "MYREAL|1E40|NO_VALUE",
          "MYBOOL|1|WRONG_TYPE",
          "MYBOOL|#TRUE|WRONG_TYPE",
          "MYCHAR|\"AB\"|OUT_OF_RANGE",
          "MYCHAR|\"\"|OUT_OF_RANGE",
          "MYCHAR|1|WRONG_TYPE",
          "MYENUM|T1|NO_VALUE",
          "MYENUM|#NOSUCH|OUT_OF_RANGE",
          "MYENUM|1|WRONG_TYPE",
          "MYSTRING[]|text|NO_VALUE",
          "MYSTRING[]|1|WRONG_TYPE",
          "MYSTRING[]|\"123456789012345678901234567890123\"|OUT_OF_RANGE",
          "MYSTRING|\"text\"|BAD_INDEX",
          "MYSTRING[33]|\"A\"|BAD_INDEX",
          "MYSTRING[1]|\"AB\"|OUT_OF_RANGE",
          "MYINTS[11]|1|BAD_INDEX",
          "MYINTS[0]|1|BAD_INDEX",
          "MYINTS|1|BAD_INDEX",
          "MYINTS[]|1 2 3 4 5 6 7 8 9 10|WHOLE_ARRAY",
          "MYINTS[]|1|WHOLE_ARRAY",
          "MYPOSITIONS[]|{X 1}|WHOLE_ARRAY",
          "MYPOS|1|WRONG_TYPE",
          "MYPOS|{FRAME: X 1}|WRONG_TYPE",
          "MYPOS|{X 1|NO_VALUE",
          "MYPOS.Q|1|UNKNOWN_COMPONENT",
          "MYINT.X|1|UNKNOWN_COMPONENT",
          "NOSUCH|1|UNKNOWN_VARIABLE",
          "$POS_ACT|{X 1}|READ_ONLY",
          "$POS_ACT.X|1|READ_ONLY",
          "$MODE_OP|#AUT|READ_ONLY",
          "$IN[1]|TRUE|READ_ONLY",
          "$MODEL_NAME[]|\"KR\"|READ_ONLY",
          "$T1|FALSE|READ_ONLY",
          "$OUT[993]|FALSE|READ_ONLY",
          "$OUT[4097]|TRUE|BAD_INDEX",
        })
    void refusesEverythingElse(String name, String value, Refusal reason) {
      assertWriteRefused(name, value == null ? "" : value, reason);
    }

    @Test
    void takesAnAggregateWithOrWithoutItsTypeName() {
      write("MYFRAME", "{X 1,Y 2}");
      write("MYFRAME", "{frame: Z 3, A 4}");
      assertThat(read("MYFRAME"))
          .isEqualTo("{FRAME: X 1.00000, Y 2.00000, Z 3.00000, A 4.00000, B 0.0, C 0.0}");
    }

    @Test
    void changesOnlyTheFieldsOfAPartialAggregate() {
      write("LOAD_DATA[2]", "{CM {Y 5},M 7}");
      assertThat(read("LOAD_DATA[2]"))
          .isEqualTo(
              "{LOAD: M 7.00000, CM {FRAME: X 0.0, Y 5.00000, Z 0.0, A 0.0, B 0.0, C 0.0},"
                  + " J {INERTIA: X 0.0, Y 0.0, Z 0.0}}");
      assertThat(read("LOAD_DATA[3].M")).isEqualTo("-1.00000");
      write("LOAD_DATA[2]", "{}");
      assertThat(read("LOAD_DATA[2].M")).isEqualTo("7.00000");
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        quoteCharacter = '\0',
        value = {
          "{M 1,CM {X 1},Q 1}|UNKNOWN_COMPONENT",
          "{M 1,CM {Q 1}}|UNKNOWN_COMPONENT",
          "{M 1,CM {X TRUE}}|WRONG_TYPE",
          "{M 1,CM {POS: X 1}}|WRONG_TYPE",
          "{M 1,CM 1}|WRONG_TYPE",
          "{M 1,M 2}|NO_VALUE",
          "{M[1] 1}|BAD_INDEX",
        })
    void changesNothingIfOneFieldIsRefused(String aggregate, Refusal reason) {
      String before = read("LOAD_DATA[1]");
      assertWriteRefused("LOAD_DATA[1]", aggregate, reason);
      assertThat(read("LOAD_DATA[1]")).isEqualTo(before);
    }

    @Test
    void initialisesComponentByComponent() {
      write("MYPOSITIONS[50].X", "1");
      write("MYPOSITIONS[50]", "{T 2}");
      assertThat(read("MYPOSITIONS[50]")).isEqualTo("{E6POS: X 1.00000, T 2}");
      assertThat(read("MYPOSITIONS[49]")).isEqualTo("{E6POS: }");
    }

    @Test
    void writesTheCharactersOfAText() {
      table.declare("TEXT[5]", "CHAR", null);
      write("TEXT[3]", "\"c\"");
      assertThat(read("TEXT[]")).isEqualTo("\"  c\"");
      write("TEXT[1]", "\"a\"");
      assertThat(read("TEXT[]")).isEqualTo("\"a c\"");
    }

    @Test
    void takesBackWhatItPrinted() {
      for (String name : List.of("MYPOS", "LOAD_DATA[1]", "$BASE", "MYSTRING[]", "MYENUM")) {
        String text = read(name);
        write(name, text);
        assertThat(read(name)).isEqualTo(text);
      }
    }

    @Test
    void countsTheTextOfAnAggregateAsItCame() throws RefusedException {
      assertThatExceptionOfType(RefusedException.class)
          .isThrownBy(() -> table.write("MYPOS", "{X 1} ", 5))
          .satisfies(e -> assertThat(e.reason()).isEqualTo(Refusal.TOO_LONG));
      table.write("MYPOS", "{X 1}", 5);
      table.write("MYSTRING[]", "\"longer than five\"", 5);
    }
  }

  @Nested
  class Signals {

    @Test
    void readThroughToTheInputOrOutput() {
      assertThat(read("$T1")).isEqualTo("TRUE");
      assertThat(read("$T2")).isEqualTo("FALSE");
      table.set("$OUT[994]", "TRUE");
      assertThat(read("$T2")).isEqualTo("TRUE");
      assertThat(read("$DRIVES_ON")).isEqualTo("FALSE");
      table.set("$IN[140]", "TRUE");
      assertThat(read("$DRIVES_ON")).isEqualTo("TRUE");
    }

    @Test
    void knowTheConstantInputs() {
      assertThat(read("$IN[1025]")).isEqualTo("TRUE");
      assertThat(read("$IN[1026]")).isEqualTo("FALSE");
      assertThat(read("$MOVE_ENABLE")).isEqualTo("TRUE");
      assertThat(read("$EXT_START")).isEqualTo("FALSE");
    }

    @Test
    void readFalseIfNotWired() {
      assertThat(read("$COLLISION")).isEqualTo("FALSE");
      assertThatThrownBy(() -> table.set("$COLLISION", "TRUE")).hasMessageContaining("not wired");
    }

    @Test
    void areAnIntWithTheFirstBitLowest() {
      table.declare("GROUP", "SIGNAL", "$OUT[5] TO $OUT[8]");
      write("GROUP", "6");
      assertThat(read("GROUP")).isEqualTo("6");
      assertThat(read("$OUT[5]")).isEqualTo("FALSE");
      assertThat(read("$OUT[6]")).isEqualTo("TRUE");
      assertThat(read("$OUT[7]")).isEqualTo("TRUE");
      assertThat(read("$OUT[8]")).isEqualTo("FALSE");
      write("$OUT[8]", "TRUE");
      assertThat(read("GROUP")).isEqualTo("14");
      write("GROUP", "0");
      assertThat(read("$OUT[8]")).isEqualTo("FALSE");
    }

    @Test
    void takeAllBitsOf32() {
      table.declare("WIDE", "SIGNAL", "$out[1] to $out[32]");
      write("WIDE", "-2147483647");
      assertThat(read("WIDE")).isEqualTo("-2147483647");
      assertThat(read("$OUT[1]")).isEqualTo("TRUE");
      assertThat(read("$OUT[2]")).isEqualTo("FALSE");
      assertThat(read("$OUT[32]")).isEqualTo("TRUE");
    }

    @Test
    void refuseWhatDoesNotFit() {
      table.declare("ONE", "SIGNAL", "$OUT[5]");
      table.declare("GROUP", "SIGNAL", "$OUT[5] TO $OUT[8]");
      assertWriteRefused("ONE", "1", Refusal.WRONG_TYPE);
      assertWriteRefused("GROUP", "TRUE", Refusal.WRONG_TYPE);
      assertWriteRefused("GROUP", "16", Refusal.OUT_OF_RANGE);
      assertWriteRefused("GROUP", "-1", Refusal.OUT_OF_RANGE);
      write("ONE", "TRUE");
      assertThat(read("GROUP")).isEqualTo("1");
    }

    @Test
    void cannotBeWrittenByClientsOnInputsOrUnwired() {
      table.declare("INPUT", "SIGNAL", "$IN[5]");
      table.declare("LOOSE", "SIGNAL", "FALSE");
      assertWriteRefused("INPUT", "TRUE", Refusal.READ_ONLY);
      assertWriteRefused("LOOSE", "TRUE", Refusal.READ_ONLY);
      table.set("INPUT", "TRUE");
      assertThat(read("$IN[5]")).isEqualTo("TRUE");
    }

    @Test
    void keepClientsFromTheOutputsOfTheSystem() {
      table.declare("MINE", "SIGNAL", "$OUT[993]");
      table.declare("AROUND", "SIGNAL", "$OUT[992] TO $OUT[993]");
      assertWriteRefused("MINE", "FALSE", Refusal.READ_ONLY);
      assertWriteRefused("AROUND", "1", Refusal.READ_ONLY);
      assertThat(read("$OUT[992]")).isEqualTo("FALSE");
      write("$OUT[992]", "TRUE");
      table.remove("$T1");
      write("$OUT[993]", "FALSE");
      table.declare("$T1", "SIGNAL", Access.READ_ONLY, "$OUT[993]");
      assertWriteRefused("$OUT[993]", "TRUE", Refusal.READ_ONLY);
      table.set("$T1", "TRUE");
      assertThat(read("MINE")).isEqualTo("TRUE");
    }

    @Test
    void failIfTheirWiringLeadsNowhere() {
      table.declare("BEYOND", "SIGNAL", "$OUT[5000]");
      table.declare("NOWHERE", "SIGNAL", "$NOSUCH[1]");
      table.declare("ODD", "SIGNAL", "MYINTS[1] TO MYINTS[2]");
      table.declare("LOOP", "SIGNAL", "LOOP[1]");
      assertReadRefused("BEYOND", Refusal.BAD_INDEX);
      assertReadRefused("NOWHERE", Refusal.UNKNOWN_VARIABLE);
      assertReadRefused("ODD", Refusal.WRONG_TYPE);
      assertReadRefused("LOOP", Refusal.UNKNOWN_VARIABLE);
      assertWriteRefused("BEYOND", "TRUE", Refusal.BAD_INDEX);
      assertWriteRefused("NOWHERE", "TRUE", Refusal.UNKNOWN_VARIABLE);
      assertWriteRefused("ODD", "1", Refusal.WRONG_TYPE);
      assertWriteRefused("LOOP", "TRUE", Refusal.BAD_INDEX);
    }

    @ParameterizedTest
    @ValueSource(
        strings = {
          "TRUE",
          "",
          "$OUT",
          "$OUT[]",
          "$OUT[1] TO",
          "$OUT[1] TO $IN[2]",
          "$OUT[2] TO $OUT[1]",
          "$OUT[1] TO $OUT[33]",
          "1[1]"
        })
    void areNotDeclaredWithAWiringThatMakesNoSense(String wiring) {
      assertThatThrownBy(() -> table.declare("S", "SIGNAL", wiring))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("a SIGNAL is");
    }
  }

  @Nested
  class Declaring {

    @Test
    void knowsStructuresOfTheUsersOwn() {
      table.declareEnum("MEDIUM", "WATER", "OIL");
      table.declareStruc(
          "STRUC WELD REAL SPEED, INT SEAM,COUNTS[3], CHAR NAME[24],LINES[2,8], FRAME OFFSET,"
              + " BOOL ON, MEDIUM MEDIUM, CHAR MARK, FRAME VIA[2], INT GRID[2,2]");
      table.declare("MYWELD", "WELD", null);
      assertThat(table.get("MYWELD")).isEqualTo("{WELD: }");
      write("MYWELD.SPEED", "1");
      write(
          "MYWELD",
          "{SEAM 2,COUNTS[] 1 2 3,NAME[] \"a, b\",LINES[2,] \"two\",OFFSET {X 1},ON true,"
              + "MEDIUM #oil,MARK \"m\",VIA[2] {Y 2},GRID[1,2] 12}");
      assertThat(table.get("MYWELD"))
          .isEqualTo(
              "{WELD: SPEED 1.00000, SEAM 2, COUNTS[] 1 2 3, NAME[] \"a, b\", LINES[2,] \"two\","
                  + " OFFSET {FRAME: X 1.00000}, ON TRUE, MEDIUM #OIL, MARK \"m\","
                  + " VIA[2] {FRAME: Y 2.00000}, GRID[1,2] 12}");
      assertThat(read("MYWELD.NAME[]")).isEqualTo("\"a, b\"");
      assertThat(read("MYWELD.LINES[2,]")).isEqualTo("\"two\"");
      assertThat(read("MYWELD.LINES[2,1]")).isEqualTo("\"t\"");
      assertThat(read("MYWELD.COUNTS[]")).isEqualTo("1 2 3 ");
      assertThat(read("MYWELD.COUNTS[2]")).isEqualTo("2");
      assertThat(read("MYWELD.VIA[2].Y")).isEqualTo("2.00000");
      write("MYWELD.COUNTS[2]", "7");
      write("MYWELD.VIA[1].X", "8");
      write("MYWELD", "{COUNTS[3] 9}");
      assertThat(read("MYWELD.COUNTS[]")).isEqualTo("1 7 9 ");
      assertThat(read("MYWELD.VIA[1]")).isEqualTo("{FRAME: X 8.00000}");
      assertWriteRefused("MYWELD", "{COUNTS[] 1 2}", Refusal.OUT_OF_RANGE);
      assertWriteRefused("MYWELD", "{NAME \"x\"}", Refusal.BAD_INDEX);
      assertWriteRefused("MYWELD.COUNTS[]", "1 2 3", Refusal.WHOLE_ARRAY);
      assertReadRefused("MYWELD.VIA[]", Refusal.WHOLE_ARRAY);
    }

    @Test
    void printsTheInitialisedElementsOfAPartlyInitialisedComponent() {
      table.declareStruc("STRUC S INT A[3]");
      table.declare("PARTLY", "S", "{A[3] 3,A[1] 1}");
      assertThat(read("PARTLY")).isEqualTo("{S: A[1] 1, A[3] 3}");
      assertReadRefused("PARTLY.A[]", Refusal.NOT_INITIALISED);
    }

    @Test
    void givesEveryElementTheOneValueOrEachItsOwn() {
      table.declare("SAME[3]", "REAL", "1");
      table.declare("EACH[3]", "REAL", "1 2.5 3");
      table.declare("POINTS[2]", "FRAME", "{X 1}");
      table.declare("TEXTS[2,5]", "CHAR", "\"ab\"");
      table.declare("CUBE[2,2,2]", "INT", "1 2 3 4 5 6 7 8");
      assertThat(table.get("SAME[]")).isEqualTo("1.00000 1.00000 1.00000 ");
      assertThat(table.get("EACH[]")).isEqualTo("1.00000 2.50000 3.00000 ");
      assertThat(table.get("POINTS[2]")).isEqualTo("{FRAME: X 1.00000}");
      assertThat(table.get("TEXTS[2,]")).isEqualTo("\"ab\"");
      assertThat(table.get("CUBE[2,1,2]")).isEqualTo("6");
    }

    @Test
    void replacesAVariableOfTheSameName() {
      table.declare("myint", "REAL", Access.READ_ONLY, "1");
      assertThat(read("MYINT")).isEqualTo("1.00000");
      assertWriteRefused("MYINT", "2", Refusal.READ_ONLY);
    }

    @Test
    void removesVariables() {
      assertThat(table.contains("myint")).isTrue();
      assertThat(table.remove("myint")).isTrue();
      assertThat(table.remove("MYINT")).isFalse();
      assertThat(table.contains("MYINT")).isFalse();
      assertReadRefused("MYINT", Refusal.UNKNOWN_VARIABLE);
    }

    @Test
    void startsEmptyIfWanted() {
      VariableTable empty = VariableTable.empty();
      assertThat(empty.names()).isEmpty();
      empty.declare("B", "INT", "1");
      empty.declare("$A[3]", "REAL", "1");
      assertThat(empty.names()).containsExactly("$A", "B");
      assertThatThrownBy(() -> empty.declare("P", "E6POS", null))
          .hasMessageContaining("type E6POS is not declared");
    }

    @Test
    void copiesShareNothing() {
      VariableTable copy = table.copy();
      copy.set("MYINT", "5");
      copy.set("MYINTS[1]", "5");
      copy.declareEnum("MODE_OP", "X");
      table.declare("M", "MODE_OP", "#T1");
      assertThat(read("MYINT")).isEqualTo("0");
      assertThat(read("MYINTS[1]")).isEqualTo("0");
      assertThat(copy.get("MYINT")).isEqualTo("5");
      assertThat(copy.contains("M")).isFalse();
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = {
          "|INT|1",
          "1A|INT|1",
          "A B|INT|1",
          "A[]|INT|1",
          "A[0]|INT|1",
          "A[1,2,3,4]|INT|1",
          "A[2000000]|INT|1",
          "A[9999999,9999999]|INT|1",
          "A|NOSUCH|1",
          "A|INT|1.5",
          "A|INT|x",
          "A[3]|INT|1 2",
          "A[3]|INT|TRUE",
          "A[3]|SIGNAL|$OUT[1]",
          "A|SIGNAL|",
        })
    void refusesDeclarationsThatMakeNoSense(String name, String type, String value) {
      assertThatThrownBy(() -> table.declare(name == null ? "" : name, type, value))
          .isInstanceOf(IllegalArgumentException.class);
      assertThat(table.contains("A")).isFalse();
    }

    @Test
    void refusesTypesThatMakeNoSense() {
      for (String components :
          List.of(
              "", "REAL", "REAL X,", "REAL X; INT Y", "X", "NOSUCH X", "REAL X,x", "REAL X[0]")) {
        assertThatThrownBy(() -> table.declareStruc("STRUC S " + components))
            .as(components)
            .isInstanceOf(IllegalArgumentException.class);
      }
      assertThatThrownBy(() -> table.declareStruc("STRUC 1 REAL X"))
          .hasMessageContaining("is 'STRUC 1 REAL X': expected a name, found 1");
      assertThatThrownBy(() -> table.declareStruc("REAL X"))
          .hasMessage("a type is declared as in STRUC WELD REAL SPEED, CHAR NAME[24], is 'REAL X'");
      assertThatThrownBy(() -> table.declare("S INT A", "STRUC", null))
          .hasMessageContaining("a declaration is a type and a name");
      assertThatThrownBy(() -> table.declareStruc("STRUC int REAL X"))
          .hasMessageContaining("base type of KRL");
      assertThatThrownBy(() -> table.declareEnum("E")).hasMessageContaining("at least one");
      assertThatThrownBy(() -> table.declareEnum("E", "A", "a")).hasMessageContaining("twice");
      assertThatThrownBy(() -> table.declareEnum("E", "1"))
          .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void refusesStructuresThatNestTooDeep() {
      table.declareStruc("STRUC S1 INT X");
      for (int depth = 2; depth <= 64; depth++) {
        table.declareStruc("STRUC S" + depth + " S" + (depth - 1) + " X");
      }
      table.declare("DEEP", "S64", null);
      table.set("DEEP" + ".X".repeat(64), "5");
      assertThat(table.get("DEEP")).endsWith("{S1: X 5" + "}".repeat(64));
      assertThatThrownBy(() -> table.declareStruc("STRUC S65 S64 X"))
          .hasMessageContaining("64 deep");
    }
  }

  @Nested
  class FromJava {

    @Test
    void writesWhatClientsMayNot() {
      table.set("$OV_ACT", "50");
      table.set("$POS_ACT.X", "1.5");
      table.set("$MODE_OP", "#AUT");
      table.set("MYINTS[]", "1 2 3 4 5 6 7 8 9 10");
      assertThat(table.get("$OV_ACT")).isEqualTo("50");
      assertThat(table.get("$POS_ACT.X")).isEqualTo("1.50000");
      assertThat(table.get("$MODE_OP")).isEqualTo("#AUT");
      assertThat(table.get("MYINTS[]")).isEqualTo("1 2 3 4 5 6 7 8 9 10 ");
      table.set("MYINTS[]", "4");
      assertThat(table.get("MYINTS[10]")).isEqualTo("4");
    }

    @Test
    void readsAndWritesValues() {
      assertThat(table.value("$OV_PRO")).isEqualTo(new KrlInt(100));
      assertThat(table.value("$T1").print()).isEqualTo("TRUE");
      assertThat(table.value("MYPOS")).isInstanceOf(KrlStruct.class);
      table.set("MYSTRING[]", new KrlString("x"));
      assertThat(table.value("MYSTRING[]")).isEqualTo(new KrlString("x"));
    }

    @Test
    void saysWhatIsWrong() {
      assertThatThrownBy(() -> table.get("NOSUCH"))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage("NOSUCH: no variable NOSUCH");
      assertThatThrownBy(() -> table.value("MYPOS.Q")).hasMessage("MYPOS.Q: E6POS has no .Q");
      assertThatThrownBy(() -> table.set("MYINT", "1.5"))
          .hasMessage("MYINT: needs INT, was given 1.50000");
      assertThatThrownBy(() -> table.set("MYINT", new KrlString("x")))
          .hasMessage("MYINT: needs INT, was given \"x\"");
      assertThatThrownBy(() -> table.set("MYINT", "x")).hasMessageContaining("expected");
    }

    @Test
    void keepsTextsOfAnyScript() {
      table.set("MYSTRING[]", "\"\u4f60\u597d\"");
      table.set("MYCHAR", "\"\u20ac\"");

      assertThat(table.get("MYSTRING[]")).isEqualTo("\"\u4f60\u597d\"");
      assertThat(table.get("MYCHAR")).isEqualTo("\"\u20ac\"");
    }

    @Test
    void seesEveryWriteWholeFromOtherThreads() throws Exception {
      ExecutorService threads = Executors.newFixedThreadPool(2);
      try {
        List<Future<?>> writers = new ArrayList<>();
        for (int value : new int[] {1, 2}) {
          table.set("MYFRAME", "{X 1,Y 1,Z 1,A 1,B 1,C 1}");
          String text = "{X v,Y v,Z v,A v,B v,C v}".replace("v", String.valueOf(value));
          writers.add(
              threads.submit(
                  () -> {
                    for (int i = 0; i < 1000; i++) {
                      table.set("MYFRAME", text);
                    }
                  }));
        }
        while (!writers.stream().allMatch(Future::isDone)) {
          KrlStruct frame = (KrlStruct) table.value("MYFRAME");
          assertThat(frame.fields())
              .extracting(KrlStruct.Field::value)
              .containsOnly(frame.fields().get(0).value());
        }
        for (Future<?> writer : writers) {
          writer.get();
        }
      } finally {
        threads.shutdownNow();
      }
    }
  }
}
