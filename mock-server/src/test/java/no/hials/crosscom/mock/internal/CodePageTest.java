package no.hials.crosscom.mock.internal;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class CodePageTest {

  @ParameterizedTest
  @CsvSource({
    "A, A",
    "\u007F, \u007F",
    "\u0080, \u20AC",
    "\u0081, \u0081",
    "\u009F, \u0178",
    "\u00A0x, \u00A0x",
    "\u00FF, \u00FF"
  })
  void translatesBothWays(String narrow, String wide) {
    assertThat(CodePage.widen(narrow)).isEqualTo(wide);
    assertThat(CodePage.narrow(wide)).isEqualTo(narrow);
  }
}
