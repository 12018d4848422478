package no.hials.crosscom.cli.lab;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import no.hials.crosscom.cli.base.Cli;
import no.hials.crosscom.lab.plot.Pictures;
import no.hials.crosscom.mock.MockServer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PlotCommandTest {
  private static final String RECORDING =
      """
      time,seconds,$POS_ACT.X,$POS_ACT.Y,$POS_ACT.Z,$POS_ACT.A,$POS_ACT.S,$POS_ACT.E1,$OV_PRO,$MODE_OP,$PERI_RDY,access_ms,status
      2026-05-04T10:15:30.000000Z,0.000000,500.0,0.0,800.0,90.0,2,0.0,100,#T1,TRUE,2.1,
      2026-05-04T10:15:30.100000Z,0.100000,510.0,10.0,810.0,91.0,2,0.0,100,#T1,FALSE,2.2,
      2026-05-04T10:15:30.200000Z,0.200000,,,,,,,,,,,connection lost
      2026-05-04T10:15:30.300000Z,0.300000,530.0,20.0,830.0,93.0,2,0.0,50,#AUT,TRUE,2.4,
      2026-05-04T10:15:30.400000Z,0.400000,540.0,30.0,840.0,94.0,2,0.0,50,#AUT,TRUE,2.5,
      """;

  @TempDir private Path folder;
  private Path csv;
  private Path svg;

  @BeforeEach
  void writeRecording() throws IOException {
    csv = folder.resolve("run.csv");
    svg = folder.resolve("out.svg");
    Files.writeString(csv, RECORDING);
  }

  private Cli.Result plot(String... args) {
    String[] all = new String[args.length + 4];
    all[0] = "plot";
    all[1] = csv.toString();
    System.arraycopy(args, 0, all, 2, args.length);
    all[args.length + 2] = "--out";
    all[args.length + 3] = svg.toString();
    return Cli.run(all);
  }

  @Test
  void drawsWidePictures() throws IOException {
    plot("--size", "3840x1000").succeeds().containsExactly("wrote " + svg);
    assertThat(Pictures.svg(svg).getDocumentElement().getAttribute("width")).isEqualTo("3840");
  }

  @Test
  void drawsAPanelForEachStructureAndUnit() throws IOException {
    plot().succeeds().containsExactly("wrote " + svg);
    assertThat(Pictures.texts(svg).lines())
        .containsExactly(
            "run.csv, 2026-05-04 10:15:30 UTC",
            "$POS_ACT [mm] over time [s]; $POS_ACT.X, $POS_ACT.Y, $POS_ACT.Z",
            "$POS_ACT [°] over time [s]; $POS_ACT.A",
            "$OV_PRO [%] over time [s]; $OV_PRO",
            "$PERI_RDY [TRUE is 1] over time [s]; $PERI_RDY");
  }

  @Test
  void drawsTheFieldsOfAStructureInAPanelForEachUnit() throws IOException {
    Files.writeString(
        csv,
        """
        time,seconds,$LOAD.M,$LOAD.CM.X,$LOAD.CM.A,$LOAD.J.X,$VEL.CP,$VEL.ORI1,$H_POS.X,$H_POS.A,access_ms,status
        2026-05-04T10:15:30.000000Z,0.0,5,100,90,1,2,200,500,45,2.1,
        2026-05-04T10:15:30.100000Z,0.1,5,110,91,1,2,200,500,45,2.1,
        """);

    plot().succeeds().containsExactly("wrote " + svg);
    assertThat(Pictures.texts(svg).lines().skip(1))
        .containsExactly(
            "$LOAD [kg] over time [s]; $LOAD.M",
            "$LOAD [mm] over time [s]; $LOAD.CM.X",
            "$LOAD [°] over time [s]; $LOAD.CM.A",
            "$LOAD [kg m²] over time [s]; $LOAD.J.X",
            "$VEL [m/s] over time [s]; $VEL.CP",
            "$VEL [°/s] over time [s]; $VEL.ORI1",
            "$H_POS [mm] over time [s]; $H_POS.X",
            "$H_POS [°] over time [s]; $H_POS.A");
  }

  @Test
  void drawsAPngBesideTheRecordingIfNotToldWhere() throws IOException {
    Cli.Result result = Cli.run("plot", csv.toString(), "$POS_ACT", "--size", "640x480");

    Path png = folder.resolve("run.png");
    assertThat(result.lines()).containsExactly("wrote " + png);
    BufferedImage image = Pictures.png(png);
    assertThat(image.getWidth()).isEqualTo(640);
    assertThat(image.getHeight()).isEqualTo(480);
    assertThat(Pictures.colors(png)).containsKeys(0x0072B2, 0xD55E00, 0x009E73);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "$POS_ACT.X  | $POS_ACT [mm] over time [s]; $POS_ACT.X",
        "$pos_act.a  | $POS_ACT [°] over time [s]; $POS_ACT.A",
        "$POS_ACT.S  | $POS_ACT over time [s]; $POS_ACT.S",
        "$OV_PRO     | $OV_PRO [%] over time [s]; $OV_PRO",
        "access_ms   | access_ms [ms] over time [s]; access_ms",
      })
  void drawsTheColumnThatIsNamed(String name, String panel) throws IOException {
    assertThat(plot(name).code()).isZero();

    assertThat(Pictures.texts(svg).lines().skip(1)).containsExactly(panel);
  }

  @Test
  void takesCellsThatAreGuardedAgainstBeingFormulas() throws IOException {
    Files.writeString(csv, "time,'-force\n0,'-1.5\n1,-2\n");

    plot().succeeds().containsExactly("wrote " + svg);
    assertThat(Pictures.texts(svg).lines().skip(1)).containsExactly("-force over time; -force");
  }

  @Test
  void drawsOneColumnOverAnother() throws IOException {
    Cli.Result result = plot("--xy", "$POS_ACT.X,$POS_ACT.Y", "--title", "From above");

    assertThat(result.err()).isEmpty();
    assertThat(Pictures.texts(svg).lines())
        .containsExactly(
            "From above",
            "$POS_ACT.Y [mm] over $POS_ACT.X [mm]; $POS_ACT.Y over $POS_ACT.X, start, end");
  }

  @Test
  void drawsAPathInSpace() throws IOException {
    Cli.Result result = plot("--xyz");

    assertThat(result.err()).isEmpty();
    assertThat(Pictures.texts(svg))
        .contains("from above: Y [mm] over X [mm]; $POS_ACT, start, end")
        .contains("isometric");
  }

  @Test
  void drawsWhatRecordWrote() throws IOException {
    Path recorded = folder.resolve("recorded.csv");
    try (MockServer server = MockServer.start()) {
      Cli.Result result =
          Cli.runOn(
              server,
              "record",
              "--out",
              recorded.toString(),
              "--period",
              "1ms",
              "--count",
              "5",
              "$AXIS_ACT",
              "$TORQUE_AXIS_ACT[]");
      assertThat(result.code()).isZero();
    }

    csv = recorded;
    assertThat(plot().err()).isEmpty();
    assertThat(Pictures.texts(svg).lines().skip(1))
        .containsExactly(
            "$AXIS_ACT [°] over time [s]; $AXIS_ACT.A1, $AXIS_ACT.A2, $AXIS_ACT.A3, $AXIS_ACT.A4,"
                + " $AXIS_ACT.A5, $AXIS_ACT.A6",
            "$TORQUE_AXIS_ACT [Nm] over time [s]; $TORQUE_AXIS_ACT[1], $TORQUE_AXIS_ACT[2],"
                + " $TORQUE_AXIS_ACT[3], $TORQUE_AXIS_ACT[4], $TORQUE_AXIS_ACT[5],"
                + " $TORQUE_AXIS_ACT[6]");
  }

  @Test
  void drawsAnyCsvWithNumbersInItsFirstColumn() throws IOException {
    Files.writeString(csv, "distance [m],force [N],note\n0,1.5,a\n1,2.5,\n2,,b\n");

    assertThat(plot().err()).isEmpty();
    assertThat(Pictures.texts(svg).lines())
        .containsExactly("run.csv", "force [N] over distance [m]; force");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", " "})
  void leavesAGapWhereThereIsNoNumber(String cell) throws IOException {
    Files.writeString(csv, "s,force [N]\n0,1\n1," + cell + "\n2,3\n3,4\n");

    Cli.Result result = plot();

    assertThat(result.err()).isEmpty();
    assertThat(Pictures.texts(svg).lines()).containsExactly("run.csv", "force [N] over s; force");
  }

  @ParameterizedTest
  @ValueSource(strings = {"NaN", "nan", "inf", "-Infinity", "1e999"})
  void countsTheNumbersThatAreNotFinite(String cell) throws IOException {
    Files.writeString(csv, "s,force [N]\n0,1\n1," + cell + "\n2,3\n3,4\n");

    plot().succeeds().containsExactly("wrote " + svg);
    assertThat(Pictures.texts(svg).lines().skip(1))
        .containsExactly("force [N] over s; force; 1 value without a finite number is not shown");
  }

  @Test
  @Timeout(value = 60, threadMode = ThreadMode.SEPARATE_THREAD)
  void drawsARecordingWithTheLargestNumbersOfKrl() throws IOException {
    String big = "2026-05-04T10:15:30.500000Z,0.5,%s,0.0,800.0,90.0,2,0.0,100,#T1,TRUE,2.1,\n";
    Files.writeString(
        csv, RECORDING + big.formatted("3.40282E+38") + big.formatted("-1.00000E+30"));

    plot("$POS_ACT.X").succeeds().containsExactly("wrote " + svg);
    assertThat(Pictures.texts(svg).lines().skip(1))
        .containsExactly(
            "$POS_ACT [mm] over time [s]; $POS_ACT.X; 2 values beyond 1e15 are not shown");
  }

  @Test
  void saysWhichTextKeepsAColumnOfNumbersFromBeingDrawn() throws IOException {
    Files.writeString(csv, "s,a,b\n0,1,1\n1,3,two\n");

    Cli.Result all = plot();

    assertThat(all.errLines()).containsExactly("not drawn: b, which has also two");
    assertThat(all.code()).isZero();
    assertThat(plot("b", "--yes").errLines().get(0))
        .isEqualTo("jopenshowvar: b cannot be drawn: it has texts, such as two");
  }

  @Test
  void drawsAFileWithAByteOrderMark() throws IOException {
    Files.writeString(csv, "\ufeff" + RECORDING);

    assertThat(plot("$OV_PRO").err()).isEmpty();
    assertThat(Pictures.texts(svg)).contains("$OV_PRO [%] over time [s]");
  }

  @Test
  void saysThatSemicolonsAreNoCommas() throws IOException {
    Files.writeString(csv, "s;a\n0;1,5\n1;2\n");

    assertThat(plot().errLines())
        .containsExactly(
            "jopenshowvar: cannot draw "
                + csv
                + ": line 1 must have commas between the names, has semicolons; numbers need a"
                + " decimal point");
  }

  @Test
  void doesNotOverwriteUnlessToldTo() throws IOException {
    Files.writeString(svg, "mine");

    plot()
        .failsInLines(2)
        .containsExactly("jopenshowvar: " + svg + " already exists; --yes overwrites it");
    assertThat(svg).hasContent("mine");
    assertThat(plot("--yes").code()).isZero();
    assertThat(Pictures.texts(svg)).contains("$OV_PRO");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "$POS_AC                   | there is no column $POS_AC in FILE, it has: $POS_ACT $OV_PRO"
            + " $MODE_OP $PERI_RDY access_ms",
        "$MODE_OP                  | $MODE_OP cannot be drawn: it has texts, such as #T1",
        "--xy=$POS_ACT.X           | --xy must be two names with a comma between them, is"
            + " $POS_ACT.X",
        "--xy=$POS_ACT.X,$POS_ACT  | --xy must be two columns, $POS_ACT is 6, such as $POS_ACT.X",
        "--size=100x100            | invalid value for option '--size': width must be 300 to 10000"
            + " pixels, is 100",
        "--size=1000               | invalid value for option '--size': must be like 1200x800, is"
            + " 1000",
        "--size=300x200            | a picture of 300x200 is too small for its 4 panels: it must be"
            + " at least 588 pixels high",
      })
  void saysWhatCannotBeDrawn(String argument, String message) {
    Cli.Result result = plot(argument);

    assertThat(result.code()).isEqualTo(2);
    assertThat(result.errLines().get(0))
        .isEqualTo("jopenshowvar: " + message.replace("FILE", csv.toString()));
    assertThat(svg).doesNotExist();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "''                 | cannot draw FILE: it must have a line of names and lines of numbers",
        "'a,b;1,2;x,3'      | cannot draw FILE: line 3 must begin with a number, begins with x",
        "'1,2;3,4'          | cannot draw FILE: the first line must name the columns, begins with"
            + " 1",
        "'a;1'              | nothing in FILE can be drawn: it has no numbers",
        "'a,b;1,2;3'        | cannot draw FILE: line 3 must have 2 fields, has 1",
        "'a,b;1,2;3,\"4;5,6' | cannot read FILE: unclosed quoted field at end of input (record"
            + " starting at line 3)",
        "'a,\"b\"c;1,2'     | cannot read FILE: unexpected character after closing quote: 'c'"
            + " (0x63) (record starting at line 1)",
        "'a\tb;1\t2'        | cannot draw FILE: line 1 must have commas between the names, has"
            + " tabs; numbers need a decimal point",
        "'a,b;1,x;2,y'      | nothing in FILE can be drawn: it has no numbers",
        "'time,seconds,x;1,2,3' | FILE is not a recording: the first line must be"
            + " time,seconds,...,access_ms,status, is time,seconds,x",
      })
  void saysWhichFileIsNoTable(String text, String message) throws IOException {
    Files.writeString(csv, text.replace(';', '\n'));

    Cli.Result result = plot();

    assertThat(result.code()).isEqualTo(2);
    assertThat(result.errLines().get(0))
        .isEqualTo("jopenshowvar: " + message.replace("FILE", csv.toString()));
  }

  @Test
  void saysThatAFolderIsNoTable() {
    csv = folder;

    assertThat(plot().errLines())
        .containsExactly("jopenshowvar: cannot read " + folder + ": it is a folder");
    assertThat(plot().code()).isEqualTo(2);
  }

  @Test
  void saysThatJsonLinesAreNoCsv() throws IOException {
    csv = folder.resolve("run.jsonl");
    Files.writeString(csv, "{\"time\":\"2026-01-02T03:04:05Z\",\"seconds\":0.0}\n");

    assertThat(plot().errLines())
        .containsExactly("jopenshowvar: cannot read " + csv + ": it must be CSV, not JSON Lines");
  }

  @Test
  void saysWhichFileIsNotThere() {
    csv = folder.resolve("none.csv");

    assertThat(plot().errLines())
        .containsExactly("jopenshowvar: cannot read " + csv + ": file not found");
    assertThat(plot().code()).isEqualTo(2);
  }

  @Test
  void refusesAPictureWhoseNameIsNone() {
    Cli.Result result =
        Cli.run("plot", csv.toString(), "--out", folder.resolve("a.gif").toString());

    assertThat(result.code()).isEqualTo(2);
    assertThat(result.errLines().get(0))
        .startsWith("jopenshowvar: the name of a picture must end with .png or .svg, is ");
  }
}
