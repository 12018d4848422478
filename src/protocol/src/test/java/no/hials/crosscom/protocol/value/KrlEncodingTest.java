package no.hials.crosscom.protocol.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.CharacterCodingException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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
}
