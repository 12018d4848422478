package no.hials.crosscom.cell;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class JsonLineTest {

  /** Returns the line with apostrophes for quotes, and without the text. */
  private static String json(String name, String krl) {
    String line = JsonLine.of(name, krl);
    return line.substring(0, line.indexOf(",\"text\":")).replace('"', '\'') + "}";
  }

  @ParameterizedTest
  @CsvSource({
    "3.50000,3.5",
    "45.0000,45.0",
    "0.0,0.0",
    "2.48660E+06,2486600.0",
    "3.40282E+38,3.40282E38",
    "1794.12939,1794.12939",
    "-4.48259061E-06,-4.48259061E-6",
    ".5,0.5",
    "1.,1.0"
  })
  void printsARealAsTheNumberThatTheControllerPrinted(String krl, String json) {
    assertThat(json("R", krl)).isEqualTo("{'name':'R','type':'REAL','value':" + json + "}");
  }

  @Test
  void hasTheTextOfTheControllerNextToTheValue() {
    assertThat(JsonLine.of("R", "{X 3.50000, B TRUE}"))
        .endsWith("\"value\":{\"X\":3.5,\"B\":true},\"text\":\"{X 3.50000, B TRUE}\"}");
    assertThat(JsonLine.of("PING", "PONG {"))
        .endsWith("\"type\":\"UNKNOWN\",\"value\":\"PONG {\",\"text\":\"PONG {\"}");
  }

  @ParameterizedTest
  @CsvSource({"'''B0101''',5", "'''HFF''',255", "-1,-1"})
  void printsAnIntInDecimal(String krl, int value) {
    assertThat(json("I", krl)).isEqualTo("{'name':'I','type':'INT','value':" + value + "}");
  }

  @Test
  void nestsAggregatesUnderTheNamesOfTheirFields() {
    assertThat(
            json(
                "S",
                "{TOOL: LOAD {LOAD: M 65.0000, CM {FRAME: X 180.000}}, NAME[] \"a, {b}\", C \"x\","
                    + " MODE #T1, ON TRUE, V[] 1 2 3}"))
        .isEqualTo(
            "{'name':'S','type':'STRUC','struc':'TOOL','value':{'LOAD':{'M':65.0,'CM':{'X':180.0}},'NAME[]':'a,"
                + " {b}','C':'x','MODE':'#T1','ON':true,'V[]':[1,2,3]}}");
  }

  @Test
  void printsAnUninitialisedAggregateAsAnEmptyObject() {
    assertThat(json("P", "{E6POS: }"))
        .isEqualTo("{'name':'P','type':'STRUC','struc':'E6POS','value':{}}");
  }

  @ParameterizedTest
  @CsvSource({"V[],7,INT,7", "V[],#T1,ENUM,'''#T1'''", "'V[1,]',TRUE,BOOL,true"})
  void printsAWholeArrayAsAnArrayThoughItHasOneElement(
      String name, String krl, String type, String element) {
    assertThat(json(name, krl))
        .isEqualTo("{'name':'" + name + "','type':'" + type + "[]','value':[" + element + "]}");
  }

  @ParameterizedTest
  @CsvSource({"C,CHAR", "T[3],CHAR", "T[],CHAR[]", "'T[1,]',CHAR[]"})
  void tellsACharFromATextOfOneByTheName(String name, String type) {
    assertThat(json(name, "\"x\""))
        .isEqualTo("{'name':'" + name + "','type':'" + type + "','value':'x'}");
  }

  @Test
  void escapesWhatIsNotAscii() {
    assertThat(json("T[]", "\"B\u00FChne\\\t\""))
        .isEqualTo("{'name':'T[]','type':'CHAR[]','value':'B\\u00FChne\\\\\\t'}");
  }
}
