package no.hials.crosscom.simulator.internal.program;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** SWRITE and SREAD, which need the types of the controller. */
class KssTextsTest {
  private static final String HEAD =
      """
      DEF TEST()
      ENUM CMD_STAT CMD_OK,DATA_END,FMT_ERR
      STRUC STATE_T CMD_STAT RET1,INT MSG_NO,INT HITS,INT LENGTH
      DECL STATE_T S
      INT OFFSET
      OFFSET = 0
      """;
  private static final String TAIL =
      """

      J = S.HITS
      K = OFFSET
      B = S.RET1 == #CMD_OK
      END
      """;

  private static Rig run(String body) {
    return new Rig().run(HEAD + body + TAIL);
  }

  private static String state(Rig rig) {
    return rig.get("B") + " " + rig.get("J") + " " + rig.get("K");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "SWRITE(TEXT[],S,OFFSET,\"%d\",42) | 42 | TRUE 1 2",
        "SWRITE(TEXT[],S,OFFSET,\"%4d;%x\",42,255) | `  42;ff` | TRUE 2 7",
        "SWRITE(TEXT[],S,OFFSET,\"%0.2d%.2d%+.4d\",3,-3,14) | 03-03+0014 | TRUE 3 10",
        "SWRITE(TEXT[],S,OFFSET,\"%5.3x;\",10) | `  00a;` | TRUE 1 6",
        "SWRITE(TEXT[],S,OFFSET,\"%.2f\",1.005) | 1.00 | TRUE 1 4",
        "SWRITE(TEXT[],S,OFFSET,\"%05d%%\",7) | 00007% | TRUE 1 6",
        "SWRITE(TEXT[],S,OFFSET,\"%005d\",7) | 00007 | TRUE 1 5",
        "SWRITE(TEXT[],S,OFFSET,\"%++5d\",7) | `   +7` | TRUE 1 5",
        "SWRITE(TEXT[],S,OFFSET,\"%--5d;\",7) | `7    ;` | TRUE 1 6",
        "SWRITE(TEXT[],S,OFFSET,\"%  d\",7) | ` 7` | TRUE 1 2",
        "SWRITE(TEXT[],S,OFFSET,\"%0-+ #05.1f\",7.5) | `+7.5 ` | TRUE 1 5",
        "SWRITE(TEXT[],S,OFFSET,\"%s=%c\",\"ab\",C) | ab=x | TRUE 2 4",
        "SWRITE(TEXT[],S,OFFSET,\"%d,%d\",1) | `1,` | FALSE 1 2",
        "SWRITE(TEXT[],S,OFFSET,\"%d\",TRUE) | ` ` | FALSE 0 0",
        "SWRITE(TEXT[],S,OFFSET,\"too long a text\") | too long a | FALSE 0 10",
      })
  void writesValuesToAText(String statement, String text, String state) {
    Rig rig = run(statement);

    assertThat(rig.get("TEXT[]")).isEqualTo("\"" + text + "\"");
    assertThat(state(rig)).isEqualTo(state);
  }

  @Test
  void writesAfterTheOffset() {
    Rig rig = run("SWRITE(TEXT[],S,OFFSET,\"ab\")\nSWRITE(TEXT[],S,OFFSET,\"%d\",5)");

    assertThat(rig.get("TEXT[]")).isEqualTo("\"ab5\"");
    assertThat(state(rig)).isEqualTo("TRUE 1 3");
  }

  @ParameterizedTest
  @CsvSource({"9, ab, FALSE 0 10", "10, '', TRUE 0 10", "10, a, FALSE 0 10", "11, '', FALSE 0 10"})
  void writesNothingAfterTheEndOfTheText(int offset, String text, String state) {
    assertThat(state(run("OFFSET = " + offset + "\nSWRITE(TEXT[],S,OFFSET,\"" + text + "\")")))
        .isEqualTo(state);
  }

  @Test
  void writesNothingAtTheLargestOffset() {
    Rig rig = run("TEXT[] = \"ab\"\nOFFSET = 2147483647\nSWRITE(TEXT[],S,OFFSET,\"%d\",42)");

    assertThat(rig.get("TEXT[]").strip()).startsWith("\"ab");
    assertThat(state(rig)).isEqualTo("FALSE 1 10");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "12;3.5 | SREAD(TEXT[],S,OFFSET,\"%d;%f\",I,R) | 12 3.5 | TRUE 2 6",
        "`  7  8` | SREAD(TEXT[],S,OFFSET,\"%d %f\",I,R) | 7 8.0 | TRUE 2 6",
        "12345 | SREAD(TEXT[],S,OFFSET,\"%2d%f\",I,R) | 12 345.0 | TRUE 2 5",
        "fF -1 | SREAD(TEXT[],S,OFFSET,\"%x %f\",I,R) | 255 -1.0 | TRUE 2 5",
        "12 | SREAD(TEXT[],S,OFFSET,\"%d %f\",I,R) | 12 0.0 | FALSE 1 2",
        "12,3 | SREAD(TEXT[],S,OFFSET,\"%d;%f\",I,R) | 12 0.0 | FALSE 1 2",
        "99999999999 | SREAD(TEXT[],S,OFFSET,\"%d\",I) | 0 0.0 | FALSE 0 10",
      })
  void readsValuesOfAText(String text, String statement, String values, String state) {
    String padded = text.length() > 10 ? text.substring(0, 10) : text;
    Rig rig = run("TEXT[] = \"" + padded + "\"\n" + statement);

    assertThat(rig.get("I") + " " + rig.get("R")).isEqualTo(values);
    assertThat(state(rig)).isEqualTo(state);
  }

  @Test
  void readsAWordAndACharacter() {
    Rig rig = run("TEXT[] = \"ab cd\"\nSREAD(TEXT[],S,OFFSET,\"%s %c\",OTHER[],C)");

    assertThat(rig.get("OTHER[]") + rig.get("C")).isEqualTo("\"ab\"\"c\"");
  }
}
