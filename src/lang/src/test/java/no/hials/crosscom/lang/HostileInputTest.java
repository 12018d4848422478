package no.hials.crosscom.lang;

import static no.hials.crosscom.lang.Snippets.errors;
import static no.hials.crosscom.lang.Snippets.routine;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class HostileInputTest {
  private static final long SEED = Long.getLong("seed", 1);
  private static final String TOO_DEEP = "an expression with more than 250 operators and brackets";

  private static final List<String> WORDS =
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
  void limitsTheNumberOfErrors() {
    List<String> errors = errors(routine("FOO\n".repeat(20_000)));

    assertThat(errors).hasSize(10_001);
    assertThat(errors.get(10_000))
        .isEqualTo("10002:1 more than 10000 errors; the rest is not listed");
  }

  @Test
  void keepsMessagesShort() {
    assertThat(errors(routine("A=" + "B".repeat(1000) + " " + "C".repeat(1000))))
        .containsExactly("2:1004 expected the end of the line, found " + "C".repeat(40) + "...");
  }

  @Test
  void neverThrowsForAnyText() {
    forAll(500, HostileInputTest::text, result -> assertThat(result.errors()).isNotEmpty());
  }

  @Test
  void neverThrowsForAnyWords() {
    forAll(
        500,
        random -> "DEF A()\n" + words(random),
        result ->
            assertThat(result.errors())
                .doesNotHaveDuplicates()
                .allSatisfy(error -> assertThat(error.position().line()).isPositive()));
  }

  @Test
  void neverThrowsForAMutatedFile() throws Exception {
    List<String> files = List.of(sample("config.dat"), sample("actuator.src"), sample("sps.sub"));

    forAll(
        300,
        random -> mutated(random, files.get(random.nextInt(files.size()))),
        result -> assertThat(result.errors()).doesNotHaveDuplicates());
  }

  /** Parses many random texts, the same in every run; a failure names the text. */
  private static void forAll(
      int tries, Function<Random, String> texts, Consumer<ParseResult> expectation) {
    Random random = new Random(SEED);
    for (int i = 0; i < tries; i++) {
      String text = texts.apply(random);
      assertThatCode(() -> expectation.accept(KrlParser.parse("T", text)))
          .as("text %d with -Dseed=%d: %s", i, SEED, text)
          .doesNotThrowAnyException();
    }
  }

  private static String text(Random random) {
    int last = random.nextBoolean() ? Character.MAX_VALUE : 127;
    StringBuilder text = new StringBuilder();
    for (int length = random.nextInt(256); length > 0; length--) {
      text.append((char) random.nextInt(last + 1));
    }
    return text.toString();
  }

  private static String words(Random random) {
    return random
        .ints(random.nextInt(61), 0, WORDS.size())
        .mapToObj(WORDS::get)
        .collect(Collectors.joining(" "));
  }

  private static String mutated(Random random, String file) {
    int begin = Math.min(random.nextInt(4001), file.length());
    int end = Math.min(begin + random.nextInt(41), file.length());
    return file.substring(0, begin) + words(random) + file.substring(end);
  }

  private static String sample(String name) throws Exception {
    return Files.readString(SampleFilesTest.path(name), StandardCharsets.ISO_8859_1);
  }
}
