package no.hials.crosscom.cell.recording;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CsvTextTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "=1",
        "+cmd",
        "-cmd",
        "@SUM",
        "  =1",
        "\u00A0=1",
        "'=1",
        "''=1",
        "\uFF1D1",
        "\uFF0B1",
        "-",
        "-1,5",
        "1.5.=",
        "+1E",
        "-0x1F",
        "x;=1",
        "=1;;''+1",
        "a; \"@SUM",
        "x;-3.5"
      })
  void readsTheTextThatItGuarded(String text) {
    assertThat(CsvText.exact(CsvText.guarded(text))).isEqualTo(text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"=1", "+cmd", "-cmd", "@SUM", " =1", "\t1", "\r1", "\uFF1D1", "-1,5"})
  void guardsWhatMayBeAFormula(String text) {
    assertThat(CsvText.guarded(text)).startsWith("'");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "x;=1           | x;'=1",
        "x; +cmd;y;@SUM | x;' +cmd;y;'@SUM",
        "=1;-1          | '=1;'-1",
        "x;\"=1\"        | x;'\"=1\"",
        "x;'=1          | x;''=1"
      })
  void guardsWhatMayBeAFormulaAfterASemicolon(String text, String guarded) {
    assertThat(CsvText.guarded(text)).isEqualTo(guarded);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "-3.5",
        "1E5",
        "-1.00000E-07",
        "+2",
        ".5",
        "-.5",
        "",
        "#T1",
        "a=b",
        "'a",
        "TRUE",
        "x;y;",
        "x;a=b"
      })
  void leavesNumbersAndOtherTextsAsTheyAre(String text) {
    assertThat(CsvText.guarded(text)).isEqualTo(text);
    assertThat(CsvText.exact(text)).isEqualTo(text);
  }
}
