package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.CharacterCodingException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class KrlEncodingTest {
  @Test
  void keepsEveryByteOfAFileThatIsNotUtf8() {
    byte[] bytes = {(byte) 0x80, (byte) 0x81, (byte) 0xFC, 0, 'A'};

    assertThat(KrlEncoding.decode(bytes)).isEqualTo("\u20AC\u0081\u00FC\u0000A");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"plain?", "\u00FC\u20AC\u0081", "\u00C3\u00BC", "\u0080", "\u4E2D", "\uFEFFA"})
  void readsWhatItWrote(String text) throws CharacterCodingException {
    assertThat(KrlEncoding.decode(KrlEncoding.encode(text))).isEqualTo(text);
  }

  @Test
  void writesWindows1252IfItCan() throws CharacterCodingException {
    assertThat(KrlEncoding.encode("\u20AC\u0081?")).containsExactly(0x80, 0x81, '?');
    assertThat(KrlEncoding.encode("\u0080")).containsExactly(0xEF, 0xBB, 0xBF, 0xC2, 0x80);
  }

  @Test
  void writesOnlyWindows1252IfTold() {
    assertThat(KrlEncoding.encodeWindows("\u00C3\u00BC\u20AC\u0081?"))
        .containsExactly(0xC3, 0xBC, 0x80, 0x81, '?');
  }

  @ParameterizedTest
  @CsvSource({
    "ab\u0080c, U+0080 at index 2",
    "\u4E2D, U+4E2D at index 0",
    "a\uD83E\uDD16b, U+1F916 at index 1",
    "\uD83E, U+D83E at index 0",
    "\uFEFFA, U+FEFF at index 0"
  })
  void refusesWhatWindows1252DoesNotHave(String text, String place) {
    assertThatThrownBy(() -> KrlEncoding.encodeWindows(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("the text must be Windows-1252, has " + place);
  }
}
