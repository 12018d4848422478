package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.statistics.Statistics;
import net.jqwik.api.statistics.StatisticsReport;
import net.jqwik.api.statistics.StatisticsReport.StatisticsReportMode;

final class CodecPropertyTest {

  @Property
  void aDecodedRequestIsTheOneThatWasEncoded(@ForAll("requests") Request request) throws Exception {
    byte[] frame = Codec.encode(request);

    assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
    assertThat(Codec.decodeRequest(frame)).isEqualTo(request);
  }

  @Property
  void aDecodedAnswerIsTheOneThatWasEncoded(@ForAll("responses") Response response)
      throws Exception {
    byte[] frame = Codec.encode(response);

    assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
    assertThat(Codec.decodeResponse(frame)).isEqualTo(response);
  }

  @Property
  @StatisticsReport(StatisticsReportMode.OFF)
  void anyBytesAreARequestOfExactlyTheseBytesOrMalformed(@ForAll("bytes") byte[] bytes) {
    byte[] encoded;
    try {
      encoded = Codec.encode(Codec.decodeRequest(bytes));
    } catch (MalformedFrameException e) {
      expectBothOutcomes(false);
      return;
    }
    expectBothOutcomes(true);
    assertThat(encoded).isEqualTo(bytes);
  }

  @Property
  @StatisticsReport(StatisticsReportMode.OFF)
  void anyBytesAreAnAnswerOfExactlyTheseBytesOrMalformed(@ForAll("bytes") byte[] bytes) {
    byte[] encoded;
    try {
      encoded = Codec.encode(Codec.decodeResponse(bytes));
    } catch (MalformedFrameException e) {
      expectBothOutcomes(false);
      return;
    }
    expectBothOutcomes(true);
    assertThat(encoded).isEqualTo(bytes);
  }

  /** Fails a run that tried nearly nothing but messages, or nearly nothing but noise. */
  private static void expectBothOutcomes(boolean decoded) {
    Statistics.collect(decoded);
    Statistics.coverage(
        coverage -> {
          coverage.check(true).percentage(p -> p > 5);
          coverage.check(false).percentage(p -> p > 5);
        });
  }

  @Provide
  Arbitrary<Request> requests() {
    return Messages.requests().withoutEdgeCases();
  }

  @Provide
  Arbitrary<Response> responses() {
    return Messages.responses().withoutEdgeCases();
  }

  /**
   * Noise alone hardly ever has the right length field, so most of these are frames: of noise that
   * is counted right, or messages with a few bytes changed, cut, or added.
   */
  @Provide
  Arbitrary<byte[]> bytes() {
    Arbitrary<byte[]> noise = Arbitraries.bytes().array(byte[].class).ofMaxSize(40);
    Arbitrary<byte[]> counted =
        Combinators.combine(
                Arbitraries.integers().between(0, 5),
                // small bytes, which are likely lengths
                Arbitraries.bytes().between((byte) 0, (byte) 6).array(byte[].class).ofMaxSize(16))
            .as(CodecPropertyTest::frame);
    Arbitrary<byte[]> messages =
        Arbitraries.oneOf(
            Messages.requests().map(Codec::encode), Messages.responses().map(Codec::encode));
    Arbitrary<byte[]> changed =
        Combinators.combine(
                messages,
                Arbitraries.integers().between(0, 20),
                Arbitraries.bytes(),
                Arbitraries.integers().between(-2, 2),
                Arbitraries.of(true, false))
            .as(CodecPropertyTest::change);
    // without edge cases, which are thousands when combined; CodecTest has them
    return Arbitraries.oneOf(noise, counted, messages, changed).withoutEdgeCases();
  }

  private static byte[] frame(int function, byte[] rest) {
    byte[] frame = new byte[5 + rest.length];
    frame[4] = (byte) function;
    System.arraycopy(rest, 0, frame, 5, rest.length);
    return count(frame);
  }

  private static byte[] change(byte[] frame, int at, byte to, int longer, boolean recount) {
    byte[] changed = Arrays.copyOf(frame, Math.max(4, frame.length + longer));
    if (at < changed.length) {
      changed[at] = to;
    }
    return recount ? count(changed) : changed;
  }

  private static byte[] count(byte[] frame) {
    int length = frame.length - Codec.HEADER_LENGTH;
    frame[2] = (byte) (length >> 8);
    frame[3] = (byte) length;
    return frame;
  }
}
