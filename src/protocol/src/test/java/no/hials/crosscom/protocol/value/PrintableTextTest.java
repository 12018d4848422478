package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class PrintableTextTest {
  @Test
  void escapesControlCharacters() {
    assertThat(PrintableText.of("\0a\t\r\n\u001B[2J\u007F\u0085\u009F"))
        .isEqualTo("\\x00a\\x09\\x0D\\x0A\\x1B[2J\\x7F\\x85\\x9F");
  }

  @Test
  void escapesWhatChangesTheDirectionOfTextOrEndsALine() {
    String unsafe = "\u061C\u200E\u200F\u202A\u202E\u2066\u2069\u2028\u2029";

    assertThat(PrintableText.of(unsafe))
        .isEqualTo("\\u061C\\u200E\\u200F\\u202A\\u202E\\u2066\\u2069\\u2028\\u2029");
  }

  @Test
  void keepsAllOtherCharacters() {
    String safe = " ~\u00A0\u00E9\u0141\u05D0\u4F60\u200B\u202F\u2065\u206A C:\\x1B \uD83D\uDE00";

    assertThat(PrintableText.of(safe)).isSameAs(safe);
  }

  @Test
  void leavesOutTheMiddleOfALongText() {
    String ends = "\u001B" + "a".repeat(1999) + "b\n";

    assertThat(PrintableText.shortened(ends))
        .isEqualTo(
            "\\x1B" + "a".repeat(999) + "... (2002 characters) ..." + "a".repeat(998) + "b\\x0A");
    assertThat(PrintableText.shortened("a\n".repeat(1000))).isEqualTo("a\\x0A".repeat(1000));
  }

  @Test
  void isAppliedToTheMessageOfASyntaxError() {
    assertThatThrownBy(() -> KrlValue.parse("\u001B[31m\r\nforged"))
        .isInstanceOf(KrlSyntaxException.class)
        .hasMessageContaining("\\x1B[31m\\x0D\\x0Aforged")
        .message()
        .doesNotContain("\u001B", "\n");
  }
}
