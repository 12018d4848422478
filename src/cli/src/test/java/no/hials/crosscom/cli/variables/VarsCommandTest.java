package no.hials.crosscom.cli.variables;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import no.hials.crosscom.cli.base.Cli;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class VarsCommandTest {
  @TempDir private Path dir;

  private Path file(String... lines) throws IOException {
    return Files.write(dir.resolve("test.dat"), List.of(lines));
  }

  @Test
  void findsAWordInAnyColumnInAnyCase() {
    Cli.run("vars", "OVERRIDE", "ov_pro")
        .succeeds()
        .containsExactly(
            "NAME     TYPE  UNIT  ACCESS  MEANING",
            "$OV_PRO  INT   %     RW      program override");
    assertThat(Cli.run("vars", "nm", "real", "highest").out()).contains("$TORQUE_AXIS_MAX[12]");
  }

  @Test
  void listsAllWithoutAWord() {
    assertThat(Cli.run("vars").lines())
        .hasSizeGreaterThan(200)
        .anyMatch(line -> line.startsWith("$POS_ACT "))
        .anyMatch(line -> line.startsWith("TOOL_DATA[16] "))
        .noneMatch(line -> line.startsWith("MYPOS"));
  }

  @Test
  void saysSoIfThereIsNothing() {
    Cli.Result result = Cli.run("vars", "torque", "unicorn");

    assertThat(result.out()).isEmpty();
    assertThat(result.errLines())
        .containsExactly("jopenshowvar: no variable matches torque and unicorn");
    assertThat(result.code()).isEqualTo(1);
  }

  @Test
  void printsJsonLines() {
    assertThat(Cli.run("vars", "$TORQUE_AXIS_MAX", "--json").lines())
        .containsExactly(
            "{\"name\":\"$TORQUE_AXIS_MAX\",\"type\":\"REAL\",\"dimensions\":[12],\"unit\":\"Nm\","
                + "\"access\":\"RO\",\"meaning\":\"highest permitted torque of each axis\"}");
  }

  @Test
  void listsWhatADataListDeclares() throws IOException {
    Path file =
        file(
            "DEFDAT CELL PUBLIC",
            "GLOBAL STRUC BOX REAL SIZE[3], INT PARTS",
            "ENUM COLOUR RED,GREEN",
            "DECL GLOBAL BOX BOXES[4] ;in the rack",
            "DECL CONST INT LIMIT=-5+2",
            "REAL HEIGHT=1.5E3",
            "DECL FRAME PLACE={X 1.0,Y -2.0}",
            "BOXES[1].PARTS=7",
            "CHAR TITLE[8]",
            "TITLE[]=\"cell\"",
            "SIGNAL LAMP $OUT[3] TO $OUT[5]",
            "ENDDAT");

    Cli.run("vars", "--declared", file.toString())
        .succeeds()
        .containsExactly(
            "LINE  NAME            TYPE    SCOPE   COMMENT      VALUE",
            "   2  BOX             STRUC   GLOBAL  -            REAL SIZE[3], INT PARTS",
            "   3  COLOUR          ENUM    -       -            #RED, #GREEN",
            "   4  BOXES[4]        BOX     GLOBAL  in the rack  -",
            "   5  LIMIT           INT     CONST   -            (-5+2)",
            "   6  HEIGHT          REAL    -       -            1500.0",
            "   7  PLACE           FRAME   -       -            {X 1.0,Y -2.0}",
            "   8  BOXES[1].PARTS  -       -       -            7",
            "   9  TITLE[8]        CHAR    -       -            -",
            "  10  TITLE[]         -       -       -            \"cell\"",
            "  11  LAMP            SIGNAL  -       -            $OUT[3] TO $OUT[5]");
  }

  @Test
  void searchesADataListAndPrintsItAsJson() throws IOException {
    Path file = file("DEFDAT CELL", "DECL GLOBAL CONST INT LIMIT=5 ;parts", "REAL X", "ENDDAT");

    assertThat(Cli.run("vars", "--json", "--declared", file.toString(), "PARTS").lines())
        .containsExactly(
            "{\"name\":\"LIMIT\",\"type\":\"INT\",\"value\":\"5\",\"global\":true,\"const\":true,"
                + "\"line\":2,\"comment\":\"parts\"}");
  }

  @Test
  void printsTheErrorsOfADataListWithTheirPlaces() throws IOException {
    Path file = file("DEFDAT CELL", "DECL INT", "REAL X", "ENDDAT");

    Cli.Result result = Cli.run("vars", "--declared", file.toString());

    assertThat(result.err()).startsWith("jopenshowvar: " + file + ":2:");
    assertThat(result.code()).isEqualTo(2);
  }

  @Test
  void callsItWrongUsageIfTheFileIsNoDataList() throws IOException {
    Cli.run("vars", "--declared", file("DEF X()", "END").toString())
        .fails(2)
        .contains("is a program, and not a data list");

    Cli.run("vars", "--declared", dir.resolve("none.dat").toString())
        .fails(2)
        .contains("none.dat: file not found");
  }
}
