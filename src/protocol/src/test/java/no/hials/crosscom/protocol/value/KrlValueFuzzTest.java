package no.hials.crosscom.protocol.value;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;

/**
 * Parses what Jazzer makes of the texts in {@code KrlValueFuzzTestInputs}. {@code mvn test} tries
 * those texts only; this looks for more, until it finds something or is stopped:
 *
 * <pre>JAZZER_FUZZ=1 mvn -pl src/protocol test -Dtest=KrlValueFuzzTest</pre>
 */
final class KrlValueFuzzTest {

  @FuzzTest(maxDuration = "0s")
  void anyTextIsAValueThatPrintsOrASyntaxErrorWithinIt(byte[] bytes) {
    String text = new String(bytes, ISO_8859_1);
    KrlValue value;
    try {
      value = KrlValue.parse(text);
    } catch (KrlSyntaxException e) {
      assertThat(e.position()).isBetween(0, text.length());
      assertThat(e.text()).isEqualTo(text);
      return;
    }
    if (value instanceof KrlStruct) {
      KrlScanner scanner = new KrlScanner(text);
      scanner.openStruct();
      while (scanner.nextField()) {
        scanner.skipFieldValue();
      }
      scanner.expectEnd();
    }
    assertThat(KrlValue.parse(value.print())).isEqualTo(value);
    // what is printed for writing has no types, and then stays as it is
    String written = value.printShort();
    assertThat(KrlValue.parse(written).printShort()).isEqualTo(written);
  }
}
