package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BuiltinsTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ABS(-2.5) | 2.5",
        "ABS(-3) | 3",
        "SQRT(2.25) | 1.5",
        "SIN(30) | 0.5",
        "COS(60) | 0.5",
        "TAN(45) | 1",
        "ACOS(0) | 90",
        "ATAN2(1,-1) | 135",
        "ATAN2(-1,0) | -90",
      })
  void computesInDegrees(String expression, double expected) {
    String result = new Rig().execute("R = " + expression).get("R");

    assertThat(Double.parseDouble(result)).isCloseTo(expected, within(1e-6));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "R = SQRT(-1) | 1422 line 2: SQRT takes a number of at least 0, was given -1.0",
        "R = ACOS(1.5) | 1422 line 2: ACOS takes a number from -1 to 1, was given 1.5",
        "R = ATAN2(0,0) | 1422 line 2: ATAN2 takes two numbers that are not both 0",
        "R = SIN(TRUE) | 1446 line 2: needs a number, was given TRUE",
        "F = INV_POS(XHOME) | 1446 line 2: needs FRAME, POS or E6POS, was given {E6AXIS:",
        "EP = FORWARD(1,I) | 1446 line 2: needs a position, was given 1",
        "B = STRCOMP(TEXT[],OTHER[]) | 1422 line 2: TEXT[]: needs a CHAR array with a value",
        "I = STRLEN(ROWS[3,]) | 1444 line 2: ROWS[3,]: an index is 1 to 2, was given [3,]",
        "B = STRCLEAR(I) | 1446 line 2: I: needs a CHAR array",
        "I = STRFIND(TRUE,TEXT[],TEXT[]) | 1446 line 2: needs INT, was given TRUE",
        "BAS(1,0) | 1446 line 2: needs a command of BAS, was given 1",
        "BAS(#NOSUCH) | 9010 line 2: BAS(#NOSUCH) is not supported",
        "BAS(#TOOL,17) | 1446 line 2: BAS: TOOL_DATA[17]: no variable TOOL_DATA",
        "BAS(#VEL_CP,1) | 1446 line 2: BAS: $VEL.CP: no variable $VEL",
      })
  void refusesArgumentsThatAreNotPossible(String statement, String message) {
    assertThat(new Rig().faultIn(statement)).startsWith(message);
  }

  @Test
  void invertsAFrame() {
    Rig rig = new Rig().execute("NOWHERE = G : INV_POS(G)\nP = INV_POS(P)");

    assertThat(rig.get("NOWHERE")).isEqualTo("{X 0.0,Y 0.0,Z 0.0,A 0.0,B 0.0,C 0.0}");
    assertThat(rig.get("P")).startsWith("{X -1.0").endsWith("S 2,T 34}");
  }

  @Test
  void asksTheRobotForItsKinematics() {
    Rig rig = new Rig().execute("EP = FORWARD(XHOME,I)\nXHOME = INVERSE(EP,XHOME,J)");

    assertThat(rig.get("EP.X")).isEqualTo("1.5");
    assertThat(rig.get("XHOME.A1")).isEqualTo("2.5");
    assertThat(rig.get("I") + rig.get("J")).isEqualTo("00");
  }

  @Test
  void saysWhenTheKinematicsHaveNoAnswer() {
    Rig rig = new Rig();
    rig.robot.reaches = false;

    rig.execute("EP = FORWARD(XHOME,I)\nXHOME = INVERSE(F,XHOME,J)");

    assertThat(rig.get("I") + rig.get("J")).isEqualTo("-1-1");
    assertThat(rig.get("XHOME.A2")).isEqualTo("-90.0");
  }

  @Test
  void stopsTheProgramIfTheRoutineItselfFails() {
    Rig rig = new Rig();
    rig.robot.broken = true;

    assertThat(rig.faultIn("EP = FORWARD(XHOME,I)"))
        .isEqualTo(
            "9107 line 2: FORWARD has failed:"
                + " java.lang.UnsupportedOperationException: broken on purpose");
  }

  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      value = {
        "I, #INITIALIZED",
        "EMPTY, #DECLARED",
        "GHOST, #UNKNOWN",
        "SENSOR, #INITIALIZED",
        "F.W, #UNKNOWN",
        "XHOME.A1, #INITIALIZED",
        "not a name, #UNKNOWN",
      })
  void saysWhetherAVariableHasAValue(String name, String state) {
    assertThat(new Rig().execute("B = VARSTATE(\"" + name + "\") == " + state).get("B"))
        .isEqualTo("TRUE");
  }

  @Test
  void takesTheNameOfAVariableFromAText() {
    assertThat(new Rig().execute("TEXT[] = \"EMPTY\"\nB = VARSTATE(TEXT[]) == #DECLARED").get("B"))
        .isEqualTo("TRUE");
  }

  @Test
  void worksWithTexts() {
    Rig rig =
        new Rig()
            .execute(
                """
                TEXT[] = "abc"
                ARR[1] = STRLEN(TEXT[])
                ARR[2] = STRDECLLEN(TEXT[])
                ARR[3] = STRADD(TEXT[],"def")
                B = STRCOPY(OTHER[],TEXT[])
                ARR[4] = STRFIND(2,OTHER[],"DE")
                ARR[5] = STRADD(OTHER[],"ghijklm")
                """);

    assertThat(rig.get("ARR[]").strip()).isEqualTo("3 10 6 4 10");
    assertThat(rig.get("TEXT[]")).isEqualTo("\"abcdef\"");
    assertThat(rig.get("OTHER[]")).isEqualTo("\"abcdefghij\"");
    assertThat(rig.get("B")).isEqualTo("TRUE");
  }

  @Test
  void copiesNoTextThatIsTooLong() {
    Rig rig = new Rig().execute("TEXT[] = \"a\"\nB = STRCOPY(TEXT[],\"0123456789x\")");

    assertThat(rig.get("B")).isEqualTo("FALSE");
    assertThat(rig.get("TEXT[]")).isEqualTo("\"a\"");
  }

  @Test
  void clearsATextWholly() {
    Rig rig = new Rig().execute("TEXT[] = \"abc\"\nB = STRCLEAR(TEXT[])\nI = STRLEN(TEXT[])");

    assertThat(rig.get("B")).isEqualTo("TRUE");
    assertThat(rig.get("I")).isEqualTo("0");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "STRCOMP(\"abc\",\"ABC\") | TRUE",
        "STRCOMP(\"abc\",\"ABC\",#NOT_CASE_SENS) | TRUE",
        "STRCOMP(\"abc\",\"ABC\",#CASE_SENS) | FALSE",
        "STRCOMP(\"abc\",\"abd\") | FALSE",
        "STRFIND(1,\"abc\",\"B\",#CASE_SENS) == -1 | TRUE",
        "STRFIND(3,\"abcb\",\"b\") == 4 | TRUE",
      })
  void comparesTexts(String expression, String expected) {
    assertThat(new Rig().execute("B = " + expression).get("B")).isEqualTo(expected);
  }
}
