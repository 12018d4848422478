package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.errors;
import static no.hials.crosscom.lang.Snippets.routine;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HostileInputTest {
  private static final String TOO_DEEP = "an expression with more than 250 operators and brackets";

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "( | ) | 253",
        "A[ | ] | 504",
        "F( | ) | 504",
        "~{X ~ | } | 753",
        "~NOT ~ | | 1003",
        "- | | 253",
        "~1+~ | | 504"
      })
  void boundsTheDepthOfExpressions(String open, String close, int column) {
    String end = close == null ? "" : close;

    assertThat(errors(routine("A=" + open.repeat(250) + "1" + end.repeat(250)))).isEmpty();
    assertThat(errors(routine("A=" + open.repeat(251) + "1" + end.repeat(251))))
        .containsExactly("2:" + column + " " + TOO_DEEP);
    assertThat(errors(routine("A=" + open.repeat(300_000)))).hasSize(1);
  }

  @Test
  void addsTheDepthOfWhatParenthesesHold() {
    String hundred = "(" + "1+".repeat(100) + "1)";

    assertThat(errors(routine("A=" + hundred + "+" + hundred))).isEmpty();
    assertThat(errors(routine("A=" + hundred + "+" + hundred + "+" + hundred)))
        .containsExactly("2:613 " + TOO_DEEP);
  }

  @Test
  void doesNotAddTheDepthOfArguments() {
    assertThat(errors(routine("A=F(" + "-1,".repeat(10_000) + "-1)"))).isEmpty();
  }

  @Test
  void survivesClosingBracketsWithoutOpeningOnes() {
    assertThat(errors(routine("A=1" + ")".repeat(10))))
        .containsExactly("2:4 expected the end of the line, found )");
  }

  @Test
  void boundsTheDepthOfBlocks() {
    assertThat(errors(routine("LOOP\n".repeat(100) + "ENDLOOP\n".repeat(100)))).isEmpty();
    assertThat(errors(routine("LOOP\n".repeat(100_000) + "GOTO X\n" + "ENDIF\n".repeat(10))))
        .containsExactly("102:1 blocks nested deeper than 100");
  }

  @Test
  void keepsMessagesShort() {
    assertThat(errors(routine("A=" + "B".repeat(1000) + " " + "C".repeat(1000))))
        .containsExactly("2:1004 expected the end of the line, found " + "C".repeat(40) + "...");
  }

  @Property(tries = 500)
  void neverThrowsForAnyText(@ForAll String text) {
    assertThat(KrlParser.parse("T", text).errors()).isNotEmpty();
  }

  @Property(tries = 500)
  void neverThrowsForAnyWords(@ForAll("words") String text) {
    assertThat(KrlParser.parse("T", "DEF A()\n" + text).errors())
        .doesNotHaveDuplicates()
        .allSatisfy(error -> assertThat(error.position().line()).isPositive());
  }

  @Provide
  Arbitrary<String> words() {
    List<String> words =
        List.of(
            "DEF",
            "END",
            "DEFDAT",
            "ENDDAT",
            "IF",
            "THEN",
            "ELSE",
            "ENDIF",
            "SWITCH",
            "CASE",
            "DEFAULT",
            "ENDSWITCH",
            "LOOP",
            "ENDLOOP",
            "REPEAT",
            "UNTIL",
            "EXIT",
            "GOTO",
            "DECL",
            "INT",
            "GLOBAL",
            "INTERRUPT",
            "PTP",
            "CIRC",
            "SPLINE",
            "ENDSPLINE",
            "A",
            "B",
            "1",
            "2.5",
            "#X",
            "\"t\"",
            "'HF'",
            "=",
            "==",
            "(",
            ")",
            "[",
            "]",
            "{",
            "}",
            ",",
            ":",
            ".",
            "-",
            "NOT",
            "AND",
            ";",
            "&",
            "\n",
            "\r\n",
            "!");
    return Arbitraries.of(words).list().ofMaxSize(60).map(list -> String.join(" ", list));
  }

  @Property(tries = 300)
  void neverThrowsForAMutatedFile(
      @ForAll("samples") String sample,
      @ForAll @IntRange(max = 4000) int from,
      @ForAll @IntRange(max = 40) int length,
      @ForAll("words") String instead) {
    int begin = Math.min(from, sample.length());
    int end = Math.min(begin + length, sample.length());

    ParseResult result =
        KrlParser.parse("T", sample.substring(0, begin) + instead + sample.substring(end));

    assertThat(result.errors()).doesNotHaveDuplicates();
  }

  @Provide
  Arbitrary<String> samples() throws Exception {
    return Arbitraries.of(sample("config.dat"), sample("actuator.src"), sample("sps.sub"));
  }

  private static String sample(String name) throws Exception {
    return Files.readString(SampleFilesTest.path(name), StandardCharsets.ISO_8859_1);
  }
}
