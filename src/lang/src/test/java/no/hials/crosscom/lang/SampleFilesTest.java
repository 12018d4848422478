package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.show;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import no.hials.crosscom.protocol.value.KrlEncoding;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Complete files as found on a controller (docs/reference/krl-language.md#files). */
class SampleFilesTest {
  static Path path(String name) throws URISyntaxException {
    return Path.of(SampleFilesTest.class.getResource(name).toURI());
  }

  private static KrlFile parse(String name) throws IOException, URISyntaxException {
    ParseResult result = KrlParser.parse(path(name));
    assertThat(result.errors()).isEmpty();
    return result.file().orElseThrow();
  }

  @Test
  void readsAConfigDat() throws Exception {
    DataList config = (DataList) parse("config.dat");

    assertThat(config.name()).isEqualTo("$CONFIG");
    assertThat(config.declarations()).hasSize(28);
    assertThat(config.headers()).containsEntry("PARAM", "DISKPATH = KRC:\\R1\\System");
    assertThat(show(config.declarations().get(3)))
        .isEqualTo("Variables(false, false, INT, [Declarator(MAXFRAME, [], 32)], tools and bases)");
    assertThat(show(config.declarations().get(9)))
        .isEqualTo("InitialValue(TOOL_NAME[2]+open, \"Gr\u00F6\u00DFe\", latin-1)");
  }

  @Test
  void readsAnActuatorProgram() throws Exception {
    SourceFile file = (SourceFile) parse("actuator.src");

    assertThat(file.routines()).extracting(Routine::name).containsExactly("Actuator", "LIMIT");
    Routine actuator = file.routines().get(0);
    assertThat(actuator.declarations()).hasSize(4);
    assertThat(show(actuator.body().get(0)))
        .isEqualTo(
            "InterruptDeclaration(true, 3, ($STOPMESS EQUAL true), CallStatement(IR_STOPM, []))");
    assertThat(actuator.body().get(12)).isInstanceOf(Statement.Loop.class);
    assertThat(actuator.end().line()).isEqualTo(62);
  }

  @Test
  void readsASubmitProgram() throws Exception {
    SourceFile file = (SourceFile) parse("sps.sub");

    assertThat(file.name()).isEqualTo("SPS");
    Statement.Loop loop = (Statement.Loop) file.routines().get(0).body().get(5);
    assertThat(show(((Statement.If) loop.body().get(1)).condition()))
        .isEqualTo("((($MODE_OP EQUAL #AUT) OR ($MODE_OP EQUAL #EX)) AND ($OV_PRO GREATER 10))");
    assertThat(show(((Statement.If) loop.body().get(3)).condition()))
        .isEqualTo("((STATUS B_AND 4) EQUAL 4)");
  }

  @Test
  void readsMachineData() throws Exception {
    DataList machine = (DataList) parse("machine.dat");

    assertThat(machine.name()).isEqualTo("$MACHINE");
    assertThat(machine.declarations()).hasSize(38);
    assertThat(show(machine.declarations().get(12)))
        .isEqualTo("InitialValue($RAT_MOT_AX[1], {N (MINUS 1003), D 10}, )");
  }

  @Test
  void readsTheListOfANewerController() throws Exception {
    ParseResult result = KrlParser.parse(path("globals.dat"));

    assertThat(Snippets.errors(result))
        .containsExactly(
            "20:17 a name has at most 24 characters, COUNTER_OF_ALL_PARTS_OF_A_SHIFT has 31");
    DataList list = (DataList) result.file().orElseThrow();
    assertThat(list.declarations()).hasSize(17);
    assertThat(show(list.declarations().get(3)))
        .isEqualTo(
            "Variables(false, false, INT, [Declarator(PERCEPT, [], 100)],"
                + " VORBELEGUNG \u00C4\u00D6\u00DC \u00DF \u20AC \u00A7 \u00BB\u00AB)");
  }

  @Test
  void readsAProgramOfANewerController() throws Exception {
    SourceFile file = (SourceFile) parse("newer.src");

    assertThat(file.headers()).containsEntry("COMMENT", "a header between routines");
    assertThat(file.routines()).extracting(Routine::name).containsExactly("newer", "name_of");
    assertThat(file.routines().get(0).body()).noneMatch(Statement.Invalid.class::isInstance);
    assertThat(show(file.routines().get(1)))
        .isEqualTo(
            "Routine(false, CHAR, [16], name_of, [Parameter(number, 0, false)],"
                + " [Variables(false, false, INT, [Declarator(number, [], -)], )],"
                + " [Return(names[number]+open)])");
  }

  @ParameterizedTest
  @CsvSource({"windows-1252, false", "windows-1252, true", "UTF-8, false", "UTF-8, true"})
  void readsTheSameInEachEncodingAndWithEachLineEnd(String encoding, boolean windows)
      throws Exception {
    for (String name : List.of("globals.dat", "newer.src", "machine.dat", "config.dat")) {
      ParseResult expected = KrlParser.parse(path(name));
      String text = KrlEncoding.decode(Files.readAllBytes(path(name))).replace("\r\n", "\n");
      String ended = windows ? text.replace("\n", "\r\n") : text;
      String marked = windows && encoding.equals("UTF-8") ? "\uFEFF" + ended : ended;

      byte[] bytes = marked.getBytes(Charset.forName(encoding));

      assertThat(KrlParser.parse(path(name).toString(), KrlEncoding.decode(bytes)))
          .isEqualTo(expected);
    }
  }

  @Test
  void keepsATreeInSixTimesTheMemoryOfItsFile() {
    String point = "LIN {X 1.0,Y 2.0,Z 3.0,A 10.5,B 20.5,C 30.5} C_DIS\n";
    String text = "DEF CAM()\n" + point.repeat(200_000) + "END\n";
    long before = usedMemory();

    ParseResult result = KrlParser.parse("CAM.SRC", text);

    assertThat(usedMemory() - before).isLessThan(6L * text.length());
    Routine routine = ((SourceFile) result.file().orElseThrow()).routines().get(0);
    assertThat(routine.body()).hasSize(200_000);
    assertThat(routine.body().get(199_999).position().line()).isEqualTo(200_001);
  }

  private static long usedMemory() {
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }
}
