package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.Arrays;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

final class AnswerFrameTest {
  private final AnswerFrame answer = new AnswerFrame();

  private void wrap(String hex) throws MalformedFrameException {
    byte[] frame = Hex.bytes(hex);
    answer.wrap(frame, frame.length);
  }

  @Test
  void anAnswerShowsItsFieldsAndItsValueInPlace() throws Exception {
    // answer #CHARGE_OK (docs/reference/wire-format.md#examples)
    wrap("01 00  00 10  00  00 0A  23 43 48 41 52 47 45 5F 4F 4B  00 01 01");

    assertThat(answer.id()).isEqualTo(256);
    assertThat(answer.functionUnknown()).isFalse();
    assertThat(answer.function()).isZero();
    assertThat(answer.success()).isTrue();
    assertThat(answer.code()).isEqualTo(1);
    answer.openValue();
    assertThat(answer.length()).isEqualTo(10);
    assertThat(answer.charAt(0)).isEqualTo('#');
    assertThat(answer.charAt(9)).isEqualTo('K');
    assertThat(answer.subSequence(1, 7)).hasToString("CHARGE");
    assertThat(answer).hasToString("#CHARGE_OK");
  }

  @Test
  void aRefusedWriteShowsTheTextThatWasSent() throws Exception {
    wrap("FF FE  00 07  01  00 01  31  00 01 00");

    assertThat(answer.id()).isEqualTo(0xFFFE);
    assertThat(answer.function()).isEqualTo(1);
    assertThat(answer.success()).isFalse();
    assertThat(answer.code()).isEqualTo(1);
    answer.openValue();
    assertThat(answer).hasToString("1");
  }

  @Test
  void functionCodeAndValueAreUnsigned() throws Exception {
    wrap("80 81  00 08  FE  00 02  FF 80  FF FE 80");

    assertThat(answer.id()).isEqualTo(0x8081);
    assertThat(answer.function()).isEqualTo(0xFE);
    assertThat(answer.code()).isEqualTo(0xFFFE);
    assertThat(answer.success()).isTrue();
    answer.openValue();
    assertThat(answer).hasToString("\u00FF\u0080");
    assertThat(answer.charAt(0)).isEqualTo('\u00FF');
  }

  @Test
  void anAnswerToAnUnknownFunctionHasOnlyAnId() throws Exception {
    // "a frame whose length is 0" (docs/reference/kukavarproxy.md#unknown-functions)
    wrap("01 02  00 00");

    assertThat(answer.functionUnknown()).isTrue();
    assertThat(answer.id()).isEqualTo(258);
    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(answer::openValue)
        .withMessage(
            "an answer with a value has at least 6 bytes after its length, has 0,"
                + " frame: 01 02 00 00");
  }

  @Test
  void anEmptyValueIsAnEmptyText() throws Exception {
    wrap("00 07  00 06  00  00 00  00 01 01");

    answer.openValue();

    assertThat(answer.isEmpty()).isTrue();
    assertThat(answer).hasToString("");
    assertThat(answer.functionUnknown()).isFalse();
  }

  @Test
  void theViewMovesToTheNextAnswerInALargerBuffer() throws Exception {
    // the bytes after the frame belong to the previous frame
    byte[] buffer = Hex.bytes("00 00  00 09  00  00 03  31 30 30  00 01 01");
    answer.wrap(buffer, 13);
    answer.openValue();
    assertThat(answer).hasToString("100");

    byte[] second = Hex.bytes("00 01  00 08  01  00 02  35 30  00 01 00");
    System.arraycopy(second, 0, buffer, 0, second.length);
    answer.wrap(buffer, second.length);

    assertThat(answer).as("no value before it is opened").isEmpty();
    assertThat(answer.id()).isEqualTo(1);
    assertThat(answer.success()).isFalse();
    answer.openValue();
    assertThat(answer).hasToString("50");
  }

  @Test
  void theLongestValueIsSeenWhole() throws Exception {
    String value = "0123456789".repeat(6553).substring(0, 65529);
    byte[] frame = Codec.encode(new ValueResponse(0, MessageType.READ, value, Tail.SUCCESS));

    answer.wrap(frame, frame.length);
    answer.openValue();

    assertThat(answer.length()).isEqualTo(65529);
    assertThat(answer).hasToString(value);
  }

  static Stream<Arguments> malformed() {
    return Stream.of(
        arguments("", "a frame has at least 4 bytes, has 0"),
        arguments("00 00 00", "a frame has at least 4 bytes, has 3"),
        arguments("00 00 00 01", "the length field must be 0, is 1"),
        arguments("00 00 00 09 00 00 03 31 30 30 00 01", "the length field must be 8, is 9"),
        arguments("00 00 00 05 00 00 03 31 30 30", "the length field must be 6, is 5"),
        arguments("00 00 00 01 00", "an answer has 0 or at least 4 bytes after its length, has 1"),
        arguments(
            "00 00 00 03 00 01 01", "an answer has 0 or at least 4 bytes after its length, has 3"));
  }

  @ParameterizedTest(name = "{0}: {1}")
  @MethodSource("malformed")
  void bytesThatCannotBeAnAnswerAreRefused(String hex, String rule) {
    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> wrap(hex))
        .withMessage(rule + ", frame: " + hex);
  }

  static Stream<Arguments> withoutValue() {
    return Stream.of(
        arguments(
            "00 00 00 04 00 00 01 01",
            "an answer with a value has at least 6 bytes after its length, has 4"),
        arguments(
            "00 00 00 05 00 00 00 01 01",
            "an answer with a value has at least 6 bytes after its length, has 5"),
        arguments("00 00 00 06 00 00 01 00 01 01", "value length must be 0, is 1"),
        arguments("00 00 00 07 00 00 00 31 00 01 01", "value length must be 1, is 0"),
        arguments("00 00 00 07 00 FF FF 31 00 01 01", "value length must be 1, is 65535"));
  }

  @ParameterizedTest(name = "{0}: {1}")
  @MethodSource("withoutValue")
  void anAnswerWhoseValueDoesNotFillItHasNone(String hex, String rule) throws Exception {
    wrap(hex);

    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(answer::openValue)
        .withMessage(rule + ", frame: " + hex);
    assertThat(answer).isEmpty();
  }

  @Test
  void anErrorOfTheCallerShowsOnlyTheAnswersBytes() throws Exception {
    byte[] buffer = Arrays.copyOf(Hex.bytes("00 01 00 00"), 100);
    answer.wrap(buffer, 4);

    assertThat(answer.malformed("id must be 2, is 1"))
        .hasMessage("id must be 2, is 1, frame: 00 01 00 00");
  }

  @Test
  void aViewOfNothingIsEmpty() {
    assertThat(new AnswerFrame()).isEmpty();
    assertThat(new AnswerFrame()).hasToString("");
  }
}
