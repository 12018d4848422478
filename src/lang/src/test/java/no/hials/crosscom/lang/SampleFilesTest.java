package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.show;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

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
}
