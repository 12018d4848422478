package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;

/**
 * Decodes what Jazzer makes of the frames in {@code CodecFuzzTestInputs}. {@code mvn test} tries
 * those frames only; this looks for more, until it finds something or is stopped:
 *
 * <pre>JAZZER_FUZZ=1 mvn -pl src/protocol test -Dtest=CodecFuzzTest -Dtests.jvm=</pre>
 */
final class CodecFuzzTest {

  @FuzzTest(maxDuration = "0s")
  void anyBytesAreAMessageOfExactlyTheseBytesOrMalformed(byte[] bytes) {
    for (ServerType server : ServerType.values()) {
      try {
        assertThat(Codec.encode(Codec.decodeRequest(bytes, server, Strictness.STRICT)))
            .isEqualTo(bytes);
      } catch (MalformedFrameException e) {
        assertThat(e).hasMessageContaining(", frame: ");
      }
      try {
        assertThat(Codec.decodeRequest(bytes, server, Strictness.LENIENT)).isNotNull();
      } catch (MalformedFrameException e) {
        assertThat(e).hasMessageContaining(", frame: ");
      }
      try {
        Response response = Codec.decodeResponse(bytes, server);
        assertThat(Codec.encode(response)).isEqualTo(bytes);
        expectTheSameInPlace(bytes, response);
      } catch (MalformedFrameException e) {
        assertThat(e).hasMessageContaining(", frame: ");
      }
    }
  }

  private static void expectTheSameInPlace(byte[] bytes, Response response)
      throws MalformedFrameException {
    AnswerFrame answer = new AnswerFrame();
    answer.wrap(bytes, bytes.length);
    assertThat(answer.id()).isEqualTo(response.id());
    assertThat(answer.functionUnknown()).isEqualTo(response instanceof EmptyResponse);
    if (response instanceof TypedResponse typed) {
      assertThat(answer.function()).isEqualTo(typed.type().code());
      assertThat(answer.success()).isEqualTo(typed.tail().success());
      assertThat(answer.code()).isEqualTo(typed.tail().code());
    }
    if (response instanceof ValueResponse read) {
      answer.openValue();
      assertThat(answer).hasToString(read.value());
    }
  }
}
