package no.hials.crosscom.protocol;

import static no.hials.crosscom.protocol.Samples.between;
import static no.hials.crosscom.protocol.Samples.forAll;
import static no.hials.crosscom.protocol.Samples.oneOf;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import java.util.function.Function;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import org.junit.jupiter.api.Test;

final class CodecPropertyTest {
  private static final int TRIES = 500;

  @Test
  void aDecodedRequestIsTheOneThatWasEncoded() {
    forAll(
        TRIES,
        Messages::request,
        request -> {
          byte[] frame = Codec.encode(request);

          assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
          assertThat(Codec.decodeRequest(frame)).isEqualTo(request);
        });
  }

  @Test
  void aDecodedAnswerIsTheOneThatWasEncoded() {
    forAll(
        TRIES,
        Messages::response,
        response -> {
          byte[] frame = Codec.encode(response);

          assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
          assertThat(Codec.decodeResponse(frame)).isEqualTo(response);
        });
  }

  @Test
  void anyBytesAreARequestOfExactlyTheseBytesOrMalformed() {
    expectTheSameBytesOrMalformed(
        CodecPropertyTest::bytes, bytes -> Codec.encode(Codec.decodeRequest(bytes)));
  }

  @Test
  void anyBytesAreAnAnswerOfExactlyTheseBytesOrMalformed() {
    expectTheSameBytesOrMalformed(
        CodecPropertyTest::bytes, bytes -> Codec.encode(Codec.decodeResponse(bytes)));
  }

  @Test
  void aDecodedRequestToC3BridgeIsTheOneThatWasEncoded() {
    forAll(
        TRIES,
        Messages::c3Request,
        request -> {
          byte[] frame = Codec.encode(request);

          assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
          assertThat(Codec.decodeRequest(frame, ServerType.C3_BRIDGE, Strictness.STRICT))
              .isEqualTo(request);
          byte[] longer = count(Arrays.copyOf(frame, frame.length + 1));
          assertThat(Codec.decodeRequest(longer, ServerType.C3_BRIDGE, Strictness.LENIENT))
              .isEqualTo(request);
        });
  }

  @Test
  void aDecodedAnswerOfC3BridgeIsTheOneThatWasEncoded() {
    forAll(
        TRIES,
        Messages::c3Response,
        response -> {
          byte[] frame = Codec.encode(response);

          assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
          assertThat(Codec.decodeResponse(frame, ServerType.C3_BRIDGE)).isEqualTo(response);
        });
  }

  @Test
  void anyBytesAreARequestToC3BridgeOfExactlyTheseBytesOrMalformed() {
    expectTheSameBytesOrMalformed(
        CodecPropertyTest::c3Bytes,
        bytes -> Codec.encode(Codec.decodeRequest(bytes, ServerType.C3_BRIDGE, Strictness.STRICT)));
  }

  @Test
  void anyBytesAreAnAnswerOfC3BridgeOfExactlyTheseBytesOrMalformed() {
    expectTheSameBytesOrMalformed(
        CodecPropertyTest::c3Bytes,
        bytes -> Codec.encode(Codec.decodeResponse(bytes, ServerType.C3_BRIDGE)));
  }

  @Test
  void anyBytesAreMalformedToALenientServerOrARequestThatAStrictOneTakes() {
    Outcomes outcomes = new Outcomes();
    forAll(
        TRIES,
        CodecPropertyTest::c3Bytes,
        bytes -> {
          Request request;
          try {
            request = Codec.decodeRequest(bytes, ServerType.C3_BRIDGE, Strictness.LENIENT);
          } catch (MalformedFrameException e) {
            outcomes.malformed++;
            return;
          }
          outcomes.decoded++;
          if (request instanceof WriteMultipleRequest batch) {
            request = new WriteMultipleRequest(batch.id(), batch.assignments());
          }
          byte[] frame = Codec.encode(request);
          assertThat(Codec.decodeRequest(frame, ServerType.C3_BRIDGE, Strictness.STRICT))
              .isEqualTo(request);
        });
    outcomes.expectBoth();
  }

  /** Decodes a frame and encodes the message. */
  private interface Recoder {
    byte[] recode(byte[] frame) throws MalformedFrameException;
  }

  private static void expectTheSameBytesOrMalformed(
      Function<Random, byte[]> samples, Recoder recoder) {
    Outcomes outcomes = new Outcomes();
    forAll(
        TRIES,
        samples,
        bytes -> {
          byte[] encoded;
          try {
            encoded = recoder.recode(bytes);
          } catch (MalformedFrameException e) {
            outcomes.malformed++;
            return;
          }
          outcomes.decoded++;
          assertThat(encoded).isEqualTo(bytes);
        });
    outcomes.expectBoth();
  }

  /** Fails a run that tried nearly nothing but messages, or nearly nothing but noise. */
  private static final class Outcomes {
    private int decoded;
    private int malformed;

    void expectBoth() {
      assertThat(decoded).isGreaterThan(TRIES / 20);
      assertThat(malformed).isGreaterThan(TRIES / 20);
    }
  }

  /**
   * Noise alone hardly ever has the right length field, so most of these are frames: of noise that
   * is counted right, or messages with a few bytes changed, cut, or added.
   */
  private static byte[] bytes(Random r) {
    return bytes(r, 5, Messages::request, Messages::response);
  }

  private static byte[] c3Bytes(Random r) {
    return bytes(r, 64, Messages::c3Request, Messages::c3Response);
  }

  private static byte[] bytes(
      Random r,
      int lastFunction,
      Function<Random, Request> requests,
      Function<Random, Response> responses) {
    return switch (r.nextInt(4)) {
      case 0 -> Samples.bytes(r, 40);
      case 1 -> frame(between(r, 0, lastFunction), smallBytes(r));
      case 2 -> message(r, requests, responses);
      default ->
          change(
              message(r, requests, responses),
              between(r, 0, 20),
              (byte) r.nextInt(256),
              between(r, -2, 2),
              r.nextBoolean());
    };
  }

  private static byte[] message(
      Random r, Function<Random, Request> requests, Function<Random, Response> responses) {
    return oneOf(r, () -> Codec.encode(requests.apply(r)), () -> Codec.encode(responses.apply(r)));
  }

  /** Returns small bytes, which are likely lengths. */
  private static byte[] smallBytes(Random r) {
    byte[] bytes = new byte[between(r, 0, 16)];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) between(r, 0, 6);
    }
    return bytes;
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
