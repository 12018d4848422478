package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.CharBuffer;
import java.util.Arrays;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.junit.jupiter.api.Test;

class FrameWriterTest {
  private final FrameWriter writer = new FrameWriter();

  private byte[] frame() {
    return Arrays.copyOf(writer.buffer(), writer.length());
  }

  @Test
  void aFrameIsThatOfTheRequestWithId0() {
    writer.write("$OV_PRO", "50");

    assertThat(frame()).isEqualTo(Codec.encode(new WriteRequest(0, "$OV_PRO", "50")));
  }

  @Test
  void aFrameTakesThePlaceOfALongerOne() {
    writer.write("A", "x".repeat(200));
    writer.write("B", CharBuffer.wrap("1"));

    assertThat(frame()).isEqualTo(Codec.encode(new WriteRequest(0, "B", "1")));
  }

  @Test
  void theRulesOfTheRequestHold() {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> writer.write("A", "x".repeat(65_530)))
        .withMessageContaining("a frame has 65535 at most");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> writer.write("A", "\u20AC"))
        .withMessageContaining("value must be ISO 8859-1");
  }
}
