package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ExpressionTest {

  private static String result(String variable, String expression) {
    return new Rig().execute(variable + " = " + expression).get(variable);
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      value = {
        "2+3*4, 14",
        "(2+3)*4, 20",
        "10/4, 2",
        "-10/4, -2",
        "7-10, -3",
        "+5, 5",
        "-(3), -3",
        "'B0101' B_AND 'B0011', 1",
        "5 B_OR 3, 7",
        "5 B_EXOR 3, 6",
        "B_NOT 10, -11",
        "'HFF', 255",
        "2147483647, 2147483647",
      })
  void computesWithIntegers(String expression, String expected) {
    assertThat(result("I", expression)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({
    "10.0/4, 2.5",
    "10/4.0, 2.5",
    "1+0.5, 1.5",
    "2*0.25, 0.5",
    "1-0.5, 0.5",
    "-0.5, -0.5",
    "+0.5, 0.5",
    "10/4, 2.0",
    "16777216.0+1.0, 1.6777216E7",
  })
  void computesWithReals(String expression, String expected) {
    assertThat(Float.parseFloat(result("R", expression))).isEqualTo(Float.parseFloat(expected));
  }

  @ParameterizedTest
  @CsvSource({"2.5, 3", "2.4, 2", "-2.5, -2", "-2.6, -3", "10/4.0*2, 5"})
  void roundsARealThatIsAssignedToAnInt(String expression, String expected) {
    assertThat(result("I", expression)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      value = {"\"A\", 65", "C, 120", "\"\u20AC\", 128", "\"\u00FC\", 252", "TEXT[2], 98"})
  void assignsTheCodeOfACharToAnInt(String expression, String expected) {
    Rig rig = new Rig().set("TEXT[]", "\"abc\"").execute("I = " + expression);

    assertThat(rig.get("I")).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({"65, A", "128, \u20AC", "252, \u00FC", "129, \u0081", "40+2, *"})
  void assignsTheCharacterOfACodeToAChar(String expression, String expected) {
    Rig rig = new Rig().execute("C = " + expression + "\nTEXT[1] = " + expression);

    assertThat(rig.get("C")).isEqualTo("\"" + expected + "\"");
    assertThat(rig.get("TEXT[1]")).isEqualTo("\"" + expected + "\"");
  }

  @Test
  void assignsContAndApoToEachOther() {
    Rig rig =
        new Rig().execute("BLEND = ROUNDING\nBLEND.CVEL = 9\nROUNDING = BLEND\nBLEND.CVEL = 8");

    assertThat(rig.get("BLEND")).isEqualTo("{CVEL 8,CPTP 2,CDIS 3.0,CORI 4.0}");
    assertThat(rig.get("ROUNDING")).isEqualTo("{CVEL 9,CPTP 2,CDIS 3.0,CORI 4.0}");
  }

  @ParameterizedTest
  @CsvSource({
    "1 == 1.0, TRUE",
    "1 <> 2, TRUE",
    "2 < 1, FALSE",
    "1 <= 1, TRUE",
    "1.5 > 1, TRUE",
    "1 >= 2, FALSE",
    "TRUE == FALSE, FALSE",
    "TRUE <> FALSE, TRUE",
    "#RED == #red, TRUE",
    "COL <> #BLUE, TRUE",
    "C == \"x\", TRUE",
    "C == \"Ł\", FALSE",
    "C == 120, TRUE",
    "120.0 <> C, FALSE",
    "C >= 'H30', TRUE",
    "13 > C, FALSE",
    "C < \"y\", TRUE",
    "TRUE AND FALSE, FALSE",
    "TRUE OR FALSE, TRUE",
    "TRUE EXOR TRUE, FALSE",
    "NOT FALSE, TRUE",
    "NOT (1 == 2) AND 3 > 2, TRUE",
  })
  void compares(String expression, String expected) {
    assertThat(result("B", expression)).isEqualTo(expected);
  }

  @Test
  void evaluatesBothOperandsOfAnd() {
    Rig rig =
        new Rig()
            .run(
                """
                DEF TEST()
                  B = FALSE AND TOUCH()
                END
                DEFFCT BOOL TOUCH()
                  J = J + 1
                  RETURN TRUE
                ENDFCT
                """);

    assertThat(rig.get("J")).isEqualTo("1");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "I = 1/0 | 9005 line 2: a divisor must not be 0, the dividend is 1",
        "R = 1.0/0.0 | 9005 line 2: a divisor must not be 0, the dividend is 1.00000",
        "I = 2147483647+1 | 9006 line 2: an INT has 32 bits, the result would be 2147483648",
        "I = 65536*65536 | 9006 line 2: an INT has 32 bits, the result would be 4294967296",
        "R = 1.0E30*1.0E30 | 9006 line 2: a REAL is at most 3.4E+38, the result would be",
        "I = 3.0E9 | 1422 line 2: I: an INT has 32 bits, was given 3.00000E+09",
        "I = EMPTY | 1422 line 2: EMPTY: has no value yet",
        "F = NOWHERE | 1422 line 2: NOWHERE: has no value yet",
        "R = NOWHERE.X | 1422 line 2: NOWHERE.X: has no value yet",
        "I = ARR[6] | 1444 line 2: ARR[6]: an index is 1 to 5, was given [6]",
        "ARR[0] = 1 | 1444 line 2: ARR[0]: an index is 1 to 5, was given [0]",
        "ARR[TRUE] = 1 | 1446 line 2: needs INT, was given TRUE",
        "I = TRUE | 1446 line 2: I: needs INT, was given TRUE",
        "C = 256 | 1422 line 2: C: the code of a CHAR is 0 to 255, was given 256",
        "C = -1 | 1422 line 2: C: the code of a CHAR is 0 to 255, was given -1",
        "I = \"ab\" | 1446 line 2: I: needs INT, was given \"ab\"",
        "BLEND = {FRAME: CVEL 1} | 1446 line 2: BLEND: needs APO, was given {FRAME: CVEL 1}",
        "B = 1 | 1446 line 2: B: needs BOOL, was given 1",
        "B = 1 AND TRUE | 1446 line 2: needs BOOL, was given 1",
        "B = NOT 1 | 1446 line 2: needs BOOL, was given 1",
        "I = 1.0 B_AND 1 | 1446 line 2: needs INT, was given 1.00000",
        "I = TRUE + 1 | 1446 line 2: needs a number, was given TRUE",
        "I = -TRUE | 1446 line 2: needs a number, was given TRUE",
        "I = +TRUE | 1446 line 2: needs a number, was given TRUE",
        "B = TRUE < FALSE | 1446 line 2: only numbers and CHAR, two BOOL or two ENUM",
        "B = #RED == 1 | 1446 line 2: only numbers and CHAR, two BOOL or two ENUM",
        "B = \"ab\" == C | 1446 line 2: only numbers and CHAR, two BOOL or two ENUM",
        "COL = #PINK | 1422 line 2: COL: ENUM COLOUR has no #PINK",
        "LIMIT = 8 | 1388 line 2: LIMIT: may only be read",
        "TEXT[] = \"far too long\" | 1422 line 2: TEXT[]: holds 10 characters, was given 12",
        "F = {X 1,W 2} | 1446 line 2: F: FRAME has no .W",
        "F = {X 1,X 2} | 1446 line 2: field X is there twice",
        "F = F : 1 | 1446 line 2: needs FRAME, POS or E6POS, was given 1",
        "F = XHOME : F | 1446 line 2: needs FRAME, POS or E6POS, was given {E6AXIS:",
        "F = F : {X 1} | 1422 line 2: component Y of {X 1} has no value yet",
      })
  void stopsWithAMessageWhereAValueIsNotPossible(String statement, String message) {
    assertThat(new Rig().faultIn(statement)).startsWith(message);
  }

  // structures, arrays, texts

  @Test
  void setsTheComponentsThatAnAggregateNames() {
    Rig rig = new Rig().execute("I = 4\nF = {X 2*I,C -1.5}");

    assertThat(rig.get("F")).isEqualTo("{X 8.0,Y 2.0,Z 3.0,A 0.0,B 0.0,C -1.5}");
  }

  @Test
  void copiesStructuresByValue() {
    Rig rig = new Rig().execute("NOWHERE = F\nF.X = 100");

    assertThat(rig.get("NOWHERE.X")).isEqualTo("1.0");
  }

  @Test
  void roundsWithinAggregates() {
    Rig rig = new Rig().execute("PARTS[1] = {NUMBER 2.6,SIZE 1,NAME[] \"bolt\"}");

    assertThat(rig.get("PARTS[1]")).isEqualTo("{NUMBER 3,SIZE 1.0,NAME[] \"bolt\"}");
  }

  @Test
  void evaluatesNestedAggregates() {
    Rig rig =
        new Rig()
            .load("DEF TEST()\nDECL LOAD L\nL = {M 1.5,CM {X I+1}}\nR = L.CM.X\nEND\n")
            .select("TEST");
    rig.interpreter.start();

    assertThat(rig.cycle().get("R")).isEqualTo("1.0");
  }

  @Test
  void computesIndices() {
    Rig rig =
        new Rig().execute("I = 2\nARR[I+1] = 30\nGRID[I,ARR[3]/10] = 5\nPARTS[I].COUNTS[I] = 6");

    assertThat(rig.get("ARR[3]")).isEqualTo("30");
    assertThat(rig.get("GRID[2,3]")).isEqualTo("5");
    assertThat(rig.get("PARTS[2].COUNTS[2]")).isEqualTo("6");
  }

  @Test
  void copiesWholeArraysAndRoundsTheirElements() {
    Rig rig =
        new Rig()
            .execute(
                """
                ARR[] = 1.6
                I = ARR[5]
                ARR[1] = 4
                TAKE(ARR[])
                END
                DEF TAKE(A[]:IN)
                DECL INT A[]
                DECL INT MINE[5]
                MINE[] = A[]
                J = MINE[1]""");

    assertThat(rig.get("I")).isEqualTo("2");
    assertThat(rig.get("J")).isEqualTo("4");
  }

  @Test
  void setsTextsAndTheirCharacters() {
    Rig rig =
        new Rig().execute("TEXT[] = \"hello\"\nTEXT[1] = \"J\"\nC = TEXT[2]\nROWS[2,] = \"row\"");

    assertThat(rig.get("TEXT[]")).isEqualTo("\"Jello\"");
    assertThat(rig.get("C")).isEqualTo("\"e\"");
    assertThat(rig.get("ROWS[2,]")).isEqualTo("\"row\"");
  }

  @Test
  void readsAndWritesSignals() {
    Rig rig = new Rig().set("$IN[5]", "TRUE").execute("B = SENSOR\nNIBBLE = 5\nI = NIBBLE");

    assertThat(rig.get("B")).isEqualTo("TRUE");
    assertThat(rig.get("$OUT[3]")).isEqualTo("TRUE");
    assertThat(rig.get("I")).isEqualTo("5");
  }

  // geometry

  @Test
  void putsOneFrameIntoAnother() {
    Rig rig = new Rig().execute("NOWHERE = G : F");

    // G turns by 90 degrees about Z, so that the X of F points along Y
    assertThat(rig.get("NOWHERE")).isEqualTo("{X 8.0,Y 1.0,Z 3.0,A 90.0,B 0.0,C 0.0}");
  }

  @Test
  void givesTheProductTheTypeOfTheRightOperand() {
    Rig rig = new Rig().execute("P = G : P");

    assertThat(rig.get("P")).isEqualTo("{X 10.0,Y 1.0,Z 0.0,A 90.0,B 0.0,C 0.0,S 2,T 34}");
  }
}
