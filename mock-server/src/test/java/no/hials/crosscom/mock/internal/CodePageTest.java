package no.hials.crosscom.mock.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class CodePageTest {

  @ParameterizedTest
  @CsvSource({
    "1252, A, A",
    "1252, \u0080, \u20AC",
    "1252, \u0081, \u0081",
    "1252, \u009F, \u0178",
    "1252, Gr\u00F6\u00DFe, Gr\u00F6\u00DFe",
    "1251, \u00CF\u00F0\u00E8\u00E2\u00E5\u00F2, \u041F\u0440\u0438\u0432\u0435\u0442",
    "936, \u00C4\u00E3\u00BA\u00C3, \u4F60\u597D",
    "936, Gr\u00F6\u00DFe, Gr\u9C9Ee",
    "950, \u00A7A, \u4F60",
    "932, \u0082\u00A0, \u3042"
  })
  void convertsBothWays(int page, String bytes, String text) {
    assertThat(CodePage.of(page).decode(bytes)).isEqualTo(text);
    assertThat(CodePage.of(page).encode(text)).isEqualTo(bytes);
  }

  @ParameterizedTest
  @CsvSource({
    "1252, \u0141\u00F3d\u017A, L\u00F3dz",
    "936, \u00F6, o",
    "1251, \u0141\u00F3d\u017A, Lodz",
    "1252, \u0416, ?"
  })
  void fitsACharacterThatThePageLacks(int page, String text, String bytes) {
    assertThat(CodePage.of(page).encode(text)).isEqualTo(bytes);
  }

  @Test
  void theFirstByteOfTwoSwallowsAQuote() {
    assertThat(CodePage.of(936).decode("\"\u00F6\"")).isEqualTo("\"?");
  }

  @Test
  void refusesANumberThatIsNoCodePage() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> CodePage.of(7))
        .withMessageContaining("codePage must be a code page of Windows such as 1252")
        .withMessageContaining("is 7");
  }
}
