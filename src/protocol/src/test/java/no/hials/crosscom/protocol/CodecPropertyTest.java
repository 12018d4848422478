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

  @Property
  void aDecodedRequestToC3BridgeIsTheOneThatWasEncoded(@ForAll("c3Requests") Request request)
      throws Exception {
    byte[] frame = Codec.encode(request);

    assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
    assertThat(Codec.decodeRequest(frame, ServerType.C3_BRIDGE, Strictness.STRICT))
        .isEqualTo(request);
    byte[] longer = count(Arrays.copyOf(frame, frame.length + 1));
    assertThat(Codec.decodeRequest(longer, ServerType.C3_BRIDGE, Strictness.LENIENT))
        .isEqualTo(request);
  }

  @Property
  void aDecodedAnswerOfC3BridgeIsTheOneThatWasEncoded(@ForAll("c3Responses") Response response)
      throws Exception {
    byte[] frame = Codec.encode(response);

    assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
    assertThat(Codec.decodeResponse(frame, ServerType.C3_BRIDGE)).isEqualTo(response);
  }

  @Property
  @StatisticsReport(StatisticsReportMode.OFF)
  void anyBytesAreARequestToC3BridgeOfExactlyTheseBytesOrMalformed(
      @ForAll("c3Bytes") byte[] bytes) {
    byte[] encoded;
    try {
      encoded = Codec.encode(Codec.decodeRequest(bytes, ServerType.C3_BRIDGE, Strictness.STRICT));
    } catch (MalformedFrameException e) {
      expectBothOutcomes(false);
      return;
    }
    expectBothOutcomes(true);
    assertThat(encoded).isEqualTo(bytes);
  }

  @Property
  @StatisticsReport(StatisticsReportMode.OFF)
  void anyBytesAreAnAnswerOfC3BridgeOfExactlyTheseBytesOrMalformed(
      @ForAll("c3Bytes") byte[] bytes) {
    byte[] encoded;
    try {
      encoded = Codec.encode(Codec.decodeResponse(bytes, ServerType.C3_BRIDGE));
    } catch (MalformedFrameException e) {
      expectBothOutcomes(false);
      return;
    }
    expectBothOutcomes(true);
    assertThat(encoded).isEqualTo(bytes);
  }

  @Property
  @StatisticsReport(StatisticsReportMode.OFF)
  void anyBytesAreMalformedToALenientServerOrARequestThatAStrictOneTakes(
      @ForAll("c3Bytes") byte[] bytes) throws Exception {
    Request request;
    try {
      request = Codec.decodeRequest(bytes, ServerType.C3_BRIDGE, Strictness.LENIENT);
    } catch (MalformedFrameException e) {
      expectBothOutcomes(false);
      return;
    }
    expectBothOutcomes(true);
    if (request instanceof WriteMultipleRequest batch) {
      request = new WriteMultipleRequest(batch.id(), batch.assignments());
    }
    assertThat(Codec.decodeRequest(Codec.encode(request), ServerType.C3_BRIDGE, Strictness.STRICT))
        .isEqualTo(request);
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

  @Provide
  Arbitrary<Request> c3Requests() {
    return Messages.c3Requests().withoutEdgeCases();
  }

  @Provide
  Arbitrary<Response> c3Responses() {
    return Messages.c3Responses().withoutEdgeCases();
  }

  /**
   * Noise alone hardly ever has the right length field, so most of these are frames: of noise that
   * is counted right, or messages with a few bytes changed, cut, or added.
   */
  @Provide
  Arbitrary<byte[]> bytes() {
    return bytes(Arbitraries.integers().between(0, 5), Messages.requests(), Messages.responses());
  }

  @Provide
  Arbitrary<byte[]> c3Bytes() {
    return bytes(
        Arbitraries.integers().between(0, 64), Messages.c3Requests(), Messages.c3Responses());
  }

  private static Arbitrary<byte[]> bytes(
      Arbitrary<Integer> functions, Arbitrary<Request> requests, Arbitrary<Response> responses) {
    Arbitrary<byte[]> noise = Arbitraries.bytes().array(byte[].class).ofMaxSize(40);
    Arbitrary<byte[]> counted =
        Combinators.combine(
                functions,
                // small bytes, which are likely lengths
                Arbitraries.bytes().between((byte) 0, (byte) 6).array(byte[].class).ofMaxSize(16))
            .as(CodecPropertyTest::frame);
    Arbitrary<byte[]> messages =
        Arbitraries.oneOf(requests.map(Codec::encode), responses.map(Codec::encode));
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
