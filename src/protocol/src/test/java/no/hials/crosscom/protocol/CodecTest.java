package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteArrayRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.ReadArrayResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

final class CodecTest {
  private static final List<Tail> TAILS =
      List.of(
          Tail.SUCCESS,
          Tail.FAILURE,
          Tail.FAILURE_ZERO,
          new Tail(0, 1),
          new Tail(2, 0),
          new Tail(0x1234, 0x80),
          new Tail(65535, 255));

  /** Requests and their bytes. */
  static Stream<Arguments> goldenRequests() {
    return Stream.of(
        arguments(
            new ReadRequest(0, "$OV_PRO"),
            // read $OV_PRO, id 0 (docs/reference/wire-format.md#examples)
            """
            00 00                             # id 0
            00 0A                             # 10 bytes follow
            00                                # read
            00 07  24 4F 56 5F 50 52 4F       # $OV_PRO
            """),
        arguments(
            new WriteRequest(1, "$OV_PRO", "50"),
            // write $OV_PRO = 50, id 1 (docs/reference/wire-format.md#examples)
            """
            00 01                             # id 1
            00 0E                             # 14 bytes follow
            01                                # write
            00 07  24 4F 56 5F 50 52 4F       # $OV_PRO
            00 02  35 30                      # 50
            """),
        arguments(
            new ReadRequest(256, "$ACCU_STATE"),
            // read $ACCU_STATE, id 256 (docs/reference/wire-format.md#examples)
            """
            01 00                             # id 256
            00 0E                             # 14 bytes follow
            00                                # read
            00 0B  24 41 43 43 55 5F 53 54 41 54 45   # $ACCU_STATE
            """),
        arguments(
            new WriteRequest(256, "$OV_PRO", "35"),
            // write $OV_PRO = 35, id 256 (docs/reference/wire-format.md#examples)
            """
            01 00                             # id 256
            00 0E                             # 14 bytes follow
            01                                # write
            00 07  24 4F 56 5F 50 52 4F       # $OV_PRO
            00 02  33 35                      # 35
            """),
        arguments(
            new ReadRequest(0, "$POS_ACT.x"),
            // docs/reference/wire-format.md#examples
            """
            00 00                             # id 0
            00 0D                             # 13 bytes follow
            00                                # read
            00 0A  24 50 4F 53 5F 41 43 54 2E 78   # $POS_ACT.x
            """),
        arguments(
            new ReadArrayRequest(0x0203, "A[]"),
            // laid out by hand from docs/reference/wire-format.md#integer-arrays; no capture is
            // known
            """
            02 03                             # id 515
            00 06                             # 6 bytes follow
            02                                # read array
            00 03  41 5B 5D                   # A[]
            """),
        arguments(
            new WriteArrayRequest(65535, "A", List.of(1, 256, 65535)),
            // laid out by hand from docs/reference/wire-format.md#integer-arrays; no capture is
            // known
            """
            FF FF                             # id 65535
            00 0C                             # 12 bytes follow
            03                                # write array
            00 01  41                         # A
            00 06  00 01  01 00  FF FF        # 6 bytes: 1, 256, 65535
            """));
  }

  /** Answers and their bytes. */
  static Stream<Arguments> goldenResponses() {
    return Stream.of(
        arguments(
            new ValueResponse(0, MessageType.READ, "100", Tail.SUCCESS),
            // answer 100 (docs/reference/wire-format.md#examples)
            """
            00 00                             # id 0
            00 09                             # 9 bytes follow
            00                                # read
            00 03  31 30 30                   # 100
            00 01  01                         # done
            """),
        arguments(
            new ValueResponse(1, MessageType.WRITE, "50", Tail.SUCCESS),
            // answer 50 (docs/reference/wire-format.md#examples)
            """
            00 01                             # id 1
            00 08                             # 8 bytes follow
            01                                # write
            00 02  35 30                      # 50
            00 01  01                         # done
            """),
        arguments(
            new ValueResponse(256, MessageType.READ, "#CHARGE_OK", Tail.SUCCESS),
            // answer #CHARGE_OK (docs/reference/wire-format.md#examples)
            """
            01 00                             # id 256
            00 10                             # 16 bytes follow
            00                                # read
            00 0A  23 43 48 41 52 47 45 5F 4F 4B   # #CHARGE_OK
            00 01  01                         # done
            """),
        arguments(
            new ValueResponse(256, MessageType.WRITE, "35", Tail.SUCCESS),
            // the last answer (docs/reference/wire-format.md#examples)
            """
            01 00                             # id 256
            00 08                             # 8 bytes follow
            01                                # write
            00 02  33 35                      # 35
            00 01  01                         # done
            """),
        arguments(
            new ValueResponse(0, MessageType.READ, "284.994965", Tail.SUCCESS),
            // docs/reference/wire-format.md#examples
            """
            00 00                             # id 0
            00 10                             # 16 bytes follow
            00                                # read
            00 0A  32 38 34 2E 39 39 34 39 36 35   # 284.994965
            00 01  01                         # done
            """),
        arguments(
            new ValueResponse(7, MessageType.READ, "", Tail.SUCCESS),
            // docs/reference/kukavarproxy.md#refused-accesses: an unknown variable, as KUKAVARPROXY
            // of 2019 and later has it
            """
            00 07                             # id 7
            00 06                             # 6 bytes follow
            00                                # read
            00 00                             # nothing
            00 01  01                         # done, it says
            """),
        arguments(
            new ValueResponse(7, MessageType.READ, "", Tail.FAILURE_ZERO),
            // the same of C3 Bridge (docs/reference/c3-messages.md#error-codes)
            """
            00 07                             # id 7
            00 06                             # 6 bytes follow
            00                                # read
            00 00                             # nothing
            00 00  00                         # refused
            """),
        arguments(
            new ValueResponse(8, MessageType.WRITE, "1", Tail.FAILURE),
            // docs/reference/kukavarproxy.md#refused-accesses
            """
            00 08                             # id 8
            00 07                             # 7 bytes follow
            01                                # write
            00 01  31                         # 1
            00 01  00                         # refused
            """),
        arguments(
            new ReadArrayResponse(0x0203, List.of(0, 513, 65535), Tail.SUCCESS),
            // laid out by hand from docs/reference/wire-format.md#integer-arrays; no capture is
            // known
            """
            02 03                             # id 515
            00 0C                             # 12 bytes follow
            02                                # read array
            00 06  00 00  02 01  FF FF        # 6 bytes: 0, 513, 65535
            00 01  01                         # done
            """),
        arguments(
            new ValueResponse(65535, MessageType.WRITE_ARRAY, "", Tail.FAILURE),
            // laid out by hand from docs/reference/wire-format.md#integer-arrays; no capture is
            // known
            """
            FF FF                             # id 65535
            00 06                             # 6 bytes follow
            03                                # write array
            00 00                             # nothing
            00 01  00                         # refused
            """),
        arguments(
            new EmptyResponse(258),
            // docs/reference/kukavarproxy.md#unknown-functions
            """
            01 02                             # id 258
            00 00                             # 0 bytes follow
            """));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenRequests")
  void aRequestHasTheBytesOfTheReference(Request request, String golden) {
    assertThat(Codec.encode(request)).isEqualTo(Hex.bytes(golden));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenRequests")
  void theBytesOfTheReferenceAreTheRequest(Request request, String golden) throws Exception {
    assertThat(Codec.decodeRequest(Hex.bytes(golden))).isEqualTo(request);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void anAnswerHasTheBytesOfTheReference(Response response, String golden) {
    assertThat(Codec.encode(response)).isEqualTo(Hex.bytes(golden));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void theBytesOfTheReferenceAreTheAnswer(Response response, String golden) throws Exception {
    assertThat(Codec.decodeResponse(Hex.bytes(golden))).isEqualTo(response);
  }

  @Test
  void aTailIsCodeThenFlag() {
    byte[] frame = Codec.encode(new ValueResponse(0, MessageType.READ, "", new Tail(0x1234, 0x80)));

    assertThat(Arrays.copyOfRange(frame, frame.length - 3, frame.length))
        .isEqualTo(Hex.bytes("12 34  80"));
  }

  static Stream<Tail> tails() {
    return TAILS.stream();
  }

  @ParameterizedTest
  @MethodSource("tails")
  void everyAnswerKeepsItsTail(Tail tail) throws Exception {
    for (Response response :
        List.of(
            new ValueResponse(1, MessageType.READ, "x", tail),
            new ValueResponse(1, MessageType.WRITE, "x", tail),
            new ReadArrayResponse(1, List.of(5), tail),
            new ValueResponse(1, MessageType.WRITE_ARRAY, "", tail))) {
      assertThat(Codec.decodeResponse(Codec.encode(response))).isEqualTo(response);
    }
  }

  @Test
  void onlyTheFlagOfATailSaysSuccess() {
    assertThat(TAILS.stream().filter(Tail::success))
        .containsExactly(
            Tail.SUCCESS, new Tail(0, 1), new Tail(0x1234, 0x80), new Tail(65535, 255));
  }

  /** Every byte that a STRING can hold. */
  private static String allOfLatin1() {
    StringBuilder all = new StringBuilder();
    for (char c = 0; c <= 0xFF; c++) {
      all.append(c);
    }
    return all.toString();
  }

  static Stream<Request> requestsAtTheLimits() {
    return Stream.of(
        new ReadRequest(0, ""),
        new ReadRequest(65535, allOfLatin1()),
        new ReadRequest(32768, "n".repeat(65532)),
        new WriteRequest(0, "", ""),
        new WriteRequest(65535, allOfLatin1(), allOfLatin1()),
        new WriteRequest(1, "", "v".repeat(65530)),
        new WriteRequest(1, "n".repeat(65530), ""),
        new WriteRequest(1, "n".repeat(32765), "v".repeat(32765)),
        new ReadArrayRequest(65535, "n".repeat(65532)),
        new WriteArrayRequest(0, "", List.of()),
        new WriteArrayRequest(65535, "n".repeat(65530), List.of()),
        new WriteArrayRequest(1, "", Collections.nCopies(32765, 65535)),
        new WriteArrayRequest(1, allOfLatin1(), List.of(0, 255, 256, 32767, 32768, 65535)));
  }

  @ParameterizedTest
  @MethodSource("requestsAtTheLimits")
  void aRequestAtTheLimitsComesBackAsItWas(Request request) throws Exception {
    byte[] frame = Codec.encode(request);

    assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
    assertThat(Codec.decodeRequest(frame)).isEqualTo(request);
  }

  static Stream<Response> responsesAtTheLimits() {
    return Stream.of(
        new ValueResponse(0, MessageType.READ, "", Tail.SUCCESS),
        new ValueResponse(65535, MessageType.READ, allOfLatin1(), Tail.SUCCESS),
        new ValueResponse(65535, MessageType.READ, "v".repeat(65529), Tail.SUCCESS),
        new ValueResponse(65535, MessageType.WRITE, "v".repeat(65529), Tail.FAILURE),
        new ValueResponse(65535, MessageType.WRITE_ARRAY, "v".repeat(65529), Tail.FAILURE),
        new ReadArrayResponse(0, List.of(), Tail.FAILURE_ZERO),
        new ReadArrayResponse(1, List.of(0, 255, 256, 32767, 32768, 65535), Tail.SUCCESS),
        new ReadArrayResponse(65535, Collections.nCopies(32764, 65535), Tail.SUCCESS),
        new EmptyResponse(0),
        new EmptyResponse(65535));
  }

  @ParameterizedTest
  @MethodSource("responsesAtTheLimits")
  void anAnswerAtTheLimitsComesBackAsItWas(Response response) throws Exception {
    byte[] frame = Codec.encode(response);

    assertThat(Codec.frameLength(frame, 0)).isEqualTo(frame.length);
    assertThat(Codec.decodeResponse(frame)).isEqualTo(response);
  }

  @Test
  void theLongestFrameCountsAllItsBytes() {
    byte[] frame =
        Codec.encode(new ValueResponse(0, MessageType.READ, "v".repeat(65529), Tail.SUCCESS));

    assertThat(frame).hasSize(65539).hasSize(Codec.MAX_FRAME_LENGTH);
    assertThat(Arrays.copyOf(frame, 8)).isEqualTo(Hex.bytes("00 00  FF FF  00  FF F9  76"));
  }

  /** Rewrites the length field, so that only the inside of the frame is wrong. */
  private static byte[] withLength(byte[] frame, int length) {
    byte[] changed = frame.clone();
    changed[2] = (byte) (length >> 8);
    changed[3] = (byte) length;
    return changed;
  }

  private static byte[] resized(byte[] frame, int length) {
    return withLength(Arrays.copyOf(frame, length), length - Codec.HEADER_LENGTH);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenRequests")
  void aRequestCutAnywhereIsMalformed(Request request, String golden) {
    byte[] frame = Hex.bytes(golden);
    for (int length = 0; length < frame.length; length++) {
      byte[] cut = Arrays.copyOf(frame, length);
      assertThatExceptionOfType(MalformedFrameException.class)
          .as("%s cut to %s", request, length)
          .isThrownBy(() -> Codec.decodeRequest(cut));
      if (length >= Codec.HEADER_LENGTH) {
        byte[] cutAndCounted = resized(frame, length);
        assertThatExceptionOfType(MalformedFrameException.class)
            .as("%s cut to %s, the length field too", request, length)
            .isThrownBy(() -> Codec.decodeRequest(cutAndCounted));
      }
    }
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void anAnswerCutAnywhereIsMalformed(Response response, String golden) throws Exception {
    byte[] frame = Hex.bytes(golden);
    for (int length = 0; length < frame.length; length++) {
      byte[] cut = Arrays.copyOf(frame, length);
      assertThatExceptionOfType(MalformedFrameException.class)
          .as("%s cut to %s", response, length)
          .isThrownBy(() -> Codec.decodeResponse(cut));
      if (length > Codec.HEADER_LENGTH) {
        byte[] cutAndCounted = resized(frame, length);
        assertThatExceptionOfType(MalformedFrameException.class)
            .as("%s cut to %s, the length field too", response, length)
            .isThrownBy(() -> Codec.decodeResponse(cutAndCounted));
      }
    }
    assertThat(Codec.decodeResponse(resized(frame, Codec.HEADER_LENGTH)))
        .isEqualTo(new EmptyResponse(response.id()));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenRequests")
  void bytesAfterTheLastFieldOfARequestAreMalformed(Request request, String golden) {
    byte[] frame = Hex.bytes(golden);

    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> Codec.decodeRequest(resized(frame, frame.length + 1)))
        .withMessageStartingWith("1 bytes are left after the last field, frame: ");
    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> Codec.decodeRequest(resized(frame, frame.length + 300)))
        .withMessageStartingWith("300 bytes are left after the last field, frame: ");
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("goldenResponses")
  void bytesBetweenLastFieldAndTailAreMalformed(Response response, String golden) {
    byte[] frame = Hex.bytes(golden);
    if (response instanceof EmptyResponse) {
      // one to three bytes after the header are less than function and tail
      for (int more = 1; more <= 3; more++) {
        byte[] longer = resized(frame, frame.length + more);
        assertThatExceptionOfType(MalformedFrameException.class)
            .isThrownBy(() -> Codec.decodeResponse(longer))
            .withMessageStartingWith(
                "an answer has 0 or at least 4 bytes after its length, has " + more + ", ");
      }
    } else {
      assertThatExceptionOfType(MalformedFrameException.class)
          .isThrownBy(() -> Codec.decodeResponse(resized(frame, frame.length + 1)))
          .withMessageStartingWith("1 bytes are left after the last field, frame: ");
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 9, 11, 0x0A00, 65535})
  void aLengthFieldThatMiscountsIsMalformed(int length) {
    byte[] request = withLength(Codec.encode(new ReadRequest(0, "$OV_PRO")), length);
    byte[] response =
        withLength(
            Codec.encode(new ValueResponse(0, MessageType.READ, "1000", Tail.SUCCESS)), length);

    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> Codec.decodeRequest(request))
        .withMessageStartingWith("the length field must be 10, is " + length + ", frame: ");
    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> Codec.decodeResponse(response))
        .withMessageStartingWith("the length field must be 10, is " + length + ", frame: ");
  }

  static Stream<Arguments> brokenRequests() {
    return Stream.of(
        arguments("", "a frame has at least 4 bytes, has 0"),
        arguments("00 00 00", "a frame has at least 4 bytes, has 3"),
        arguments("00 00  00 00", "a request must have a function, has none"),
        arguments("00 00  00 01  00", "name length needs 2 bytes, 0 are left"),
        arguments("00 00  00 02  00  00", "name length needs 2 bytes, 1 are left"),
        arguments("00 00  00 04  00  00 02 41", "name needs 2 bytes, 1 are left"),
        arguments("00 00  00 03  00  FF FF", "name needs 65535 bytes, 0 are left"),
        arguments("00 00  00 03  01  00 00", "value length needs 2 bytes, 0 are left"),
        arguments("00 00  00 06  01  00 00  00 02 31", "value needs 2 bytes, 1 are left"),
        arguments("00 00  00 05  01  00 00  FF FF", "value needs 65535 bytes, 0 are left"),
        arguments("00 00  00 04  02  00 00  41", "1 bytes are left after the last field"),
        arguments("00 00  00 03  03  00 00", "elements length needs 2 bytes, 0 are left"),
        arguments("00 00  00 07  03  00 00  00 04 00 01", "elements needs 4 bytes, 2 are left"),
        arguments("00 00  00 06  03  00 00  00 01 41", "elements length must be even, is 1"),
        arguments("00 00  00 08  03  00 00  00 03 00 01 00", "elements length must be even, is 3"));
  }

  @ParameterizedTest(name = "{0}: {1}")
  @MethodSource("brokenRequests")
  void aBrokenRequestIsRefusedWithTheRuleItBreaks(String hex, String rule) {
    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> Codec.decodeRequest(Hex.bytes(hex)))
        .withMessage(rule + ", frame: " + hex.replaceAll(" +", " "));
  }

  static Stream<Arguments> brokenResponses() {
    return Stream.of(
        arguments("", "a frame has at least 4 bytes, has 0"),
        arguments("00 00 00", "a frame has at least 4 bytes, has 3"),
        arguments(
            "00 00  00 01  00", "an answer has 0 or at least 4 bytes after its length, has 1"),
        arguments(
            "00 00  00 03  00 01 01",
            "an answer has 0 or at least 4 bytes after its length, has 3"),
        arguments("00 00  00 04  00  00 01 01", "value length needs 2 bytes, 0 are left"),
        arguments("00 00  00 05  01  00  00 01 01", "value length needs 2 bytes, 1 are left"),
        arguments("00 00  00 06  00  00 01  00 01 01", "value needs 1 bytes, 0 are left"),
        arguments("00 00  00 06  03  FF FF  00 01 01", "value needs 65535 bytes, 0 are left"),
        arguments("00 00  00 07  00  00 00  41  00 01 01", "1 bytes are left after the last field"),
        arguments("00 00  00 04  02  00 01 01", "elements length needs 2 bytes, 0 are left"),
        arguments("00 00  00 07  02  00 01  41  00 01 01", "elements length must be even, is 1"),
        arguments(
            "00 00  00 08  02  00 04  00 01  00 01 01", "elements needs 4 bytes, 2 are left"));
  }

  @ParameterizedTest(name = "{0}: {1}")
  @MethodSource("brokenResponses")
  void aBrokenAnswerIsRefusedWithTheRuleItBreaks(String hex, String rule) {
    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> Codec.decodeResponse(Hex.bytes(hex)))
        .withMessage(rule + ", frame: " + hex.replaceAll(" +", " "));
  }

  @ParameterizedTest
  @ValueSource(ints = {4, 127, 128, 255})
  void aFunctionNobodyKnowsIsSaidWithItsIdAndNumber(int function) {
    byte[] request = Hex.bytes("AB CD  00 01  00");
    request[4] = (byte) function;
    byte[] response = Hex.bytes("AB CD  00 04  00  00 01 01");
    response[4] = (byte) function;

    assertThatExceptionOfType(UnknownFunctionException.class)
        .isThrownBy(() -> Codec.decodeRequest(request))
        .withMessageStartingWith("function must be 0 to 3, is " + function + ", frame: AB CD 00 ")
        .satisfies(e -> assertThat(e.id()).isEqualTo(0xABCD))
        .satisfies(e -> assertThat(e.function()).isEqualTo(function));
    assertThatExceptionOfType(UnknownFunctionException.class)
        .isThrownBy(() -> Codec.decodeResponse(response))
        .withMessageStartingWith("function must be 0 to 3, is " + function + ", frame: AB CD 00 ")
        .satisfies(e -> assertThat(e.id()).isEqualTo(0xABCD))
        .satisfies(e -> assertThat(e.function()).isEqualTo(function));
  }

  @Test
  void aFunctionNobodyKnowsInAFrameThatMiscountsIsOnlyMalformed() {
    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> Codec.decodeRequest(Hex.bytes("00 00  00 02  09")))
        .isNotInstanceOf(UnknownFunctionException.class);
  }

  @Test
  void aLongFrameIsShownByItsFirst32Bytes() {
    byte[] zeros = new byte[300];

    assertThatExceptionOfType(MalformedFrameException.class)
        .isThrownBy(() -> Codec.decodeRequest(zeros))
        .withMessage(
            "the length field must be 296, is 0, frame: "
                + "00 ".repeat(31)
                + "00 ... (300 bytes)");
    assertThat(MalformedFrameException.hex(zeros, 32)).isEqualTo("00 ".repeat(31) + "00");
  }

  static Stream<Arguments> outOfRange() {
    List<Arguments> rows = new ArrayList<>();
    for (int id : new int[] {-1, 65536, Integer.MIN_VALUE, Integer.MAX_VALUE}) {
      String message = "id must be 0 to 65535, is " + id;
      rows.add(refused(() -> new ReadRequest(id, "A"), message));
      rows.add(refused(() -> new WriteRequest(id, "A", "1"), message));
      rows.add(refused(() -> new ReadArrayRequest(id, "A"), message));
      rows.add(refused(() -> new WriteArrayRequest(id, "A", List.of()), message));
      rows.add(refused(() -> new ValueResponse(id, MessageType.READ, "1", Tail.SUCCESS), message));
      rows.add(refused(() -> new ValueResponse(id, MessageType.WRITE, "1", Tail.SUCCESS), message));
      rows.add(refused(() -> new ReadArrayResponse(id, List.of(), Tail.SUCCESS), message));
      rows.add(
          refused(() -> new ValueResponse(id, MessageType.WRITE_ARRAY, "", Tail.SUCCESS), message));
      rows.add(refused(() -> new EmptyResponse(id), message));
    }
    rows.add(refused(() -> new Tail(-1, 0), "tail code must be 0 to 65535, is -1"));
    rows.add(refused(() -> new Tail(65536, 0), "tail code must be 0 to 65535, is 65536"));
    rows.add(refused(() -> new Tail(0, -1), "tail flag must be 0 to 255, is -1"));
    rows.add(refused(() -> new Tail(0, 256), "tail flag must be 0 to 255, is 256"));
    for (int element : new int[] {-1, 65536}) {
      String message = "element must be 0 to 65535, is " + element;
      List<Integer> elements = List.of(1, element);
      rows.add(refused(() -> new WriteArrayRequest(0, "A", elements), message));
      rows.add(refused(() -> new ReadArrayResponse(0, elements, Tail.SUCCESS), message));
    }
    return rows.stream();
  }

  static Stream<Arguments> tooLong() {
    String name = "n".repeat(65533);
    String value = "v".repeat(65530);
    return Stream.of(
        refused(
            () -> new ReadRequest(0, name),
            "name needs a frame of 65536 bytes, a frame has 65535 at most"),
        refused(
            () -> new ReadArrayRequest(0, name),
            "name needs a frame of 65536 bytes, a frame has 65535 at most"),
        refused(
            () -> new WriteRequest(0, "n", value),
            "name and value needs a frame of 65536 bytes, a frame has 65535 at most"),
        refused(
            () -> new WriteArrayRequest(0, "n", Collections.nCopies(32765, 1)),
            "name and elements needs a frame of 65536 bytes, a frame has 65535 at most"),
        refused(
            () -> new ValueResponse(0, MessageType.READ, value, Tail.SUCCESS),
            "value needs a frame of 65536 bytes, a frame has 65535 at most"),
        refused(
            () -> new ValueResponse(0, MessageType.WRITE, value, Tail.SUCCESS),
            "value needs a frame of 65536 bytes, a frame has 65535 at most"),
        refused(
            () -> new ValueResponse(0, MessageType.WRITE_ARRAY, value, Tail.SUCCESS),
            "value needs a frame of 65536 bytes, a frame has 65535 at most"),
        refused(
            () -> new ReadArrayResponse(0, Collections.nCopies(32765, 1), Tail.SUCCESS),
            "elements needs a frame of 65536 bytes, a frame has 65535 at most"));
  }

  static Stream<Arguments> notLatin1() {
    return Stream.of(
        refused(() -> new ReadRequest(0, "\u20AC"), notLatin1("name", "U+20AC", 0, "\u20AC")),
        refused(
            () -> new WriteRequest(0, "a\u0100", ""), notLatin1("name", "U+0100", 1, "a\u0100")),
        refused(
            () -> new WriteRequest(0, "A", "\u20AC"), notLatin1("value", "U+20AC", 0, "\u20AC")),
        refused(() -> new ReadArrayRequest(0, "\u20AC"), notLatin1("name", "U+20AC", 0, "\u20AC")),
        refused(
            () -> new WriteArrayRequest(0, "\u20AC", List.of()),
            notLatin1("name", "U+20AC", 0, "\u20AC")),
        refused(
            () -> new ValueResponse(0, MessageType.READ, "ab\uFFFF", Tail.SUCCESS),
            notLatin1("value", "U+FFFF", 2, "ab\uFFFF")),
        refused(
            () -> new ValueResponse(0, MessageType.WRITE, "\u20AC", Tail.SUCCESS),
            notLatin1("value", "U+20AC", 0, "\u20AC")),
        refused(
            () -> new ValueResponse(0, MessageType.WRITE_ARRAY, "\u20AC", Tail.SUCCESS),
            notLatin1("value", "U+20AC", 0, "\u20AC")));
  }

  private static String notLatin1(String field, String code, int index, String text) {
    return field + " must be ISO 8859-1, has " + code + " at index " + index + ": " + text;
  }

  private static Arguments refused(Supplier<Object> constructor, String message) {
    return arguments(constructor, message);
  }

  @ParameterizedTest(name = "{1}")
  @MethodSource({"outOfRange", "tooLong", "notLatin1"})
  void aMessageThatNoFrameCanHoldIsRefusedWithFieldValueAndLimit(
      Supplier<Object> constructor, String message) {
    assertThatIllegalArgumentException().isThrownBy(constructor::get).withMessage(message);
  }

  @Test
  void aMessageKeepsTheElementsItWasMadeWith() {
    List<Integer> elements = new ArrayList<>(List.of(1, 2));
    WriteArrayRequest request = new WriteArrayRequest(0, "A", elements);
    ReadArrayResponse response = new ReadArrayResponse(0, elements, Tail.SUCCESS);

    elements.set(0, 99);

    assertThat(request.elements()).containsExactly(1, 2);
    assertThat(response.elements()).containsExactly(1, 2);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 255, 256, 65535})
  void anEncodedRequestCanBeGivenAnotherId(int id) {
    byte[] frame = Codec.encode(new WriteRequest(0x1234, "A", "1"));

    Codec.setId(frame, id);

    assertThat(frame).isEqualTo(Codec.encode(new WriteRequest(id, "A", "1")));
  }

  @Test
  void anIdOfMoreThan16BitsIsNotPutIntoAFrame() {
    byte[] frame = Codec.encode(new ReadRequest(1, "A"));

    assertThatIllegalArgumentException()
        .isThrownBy(() -> Codec.setId(frame, 65536))
        .withMessage("id must be 0 to 65535, is 65536");
    assertThat(frame).isEqualTo(Codec.encode(new ReadRequest(1, "A")));
  }

  @Test
  void theLengthOfAFrameIsReadWhereItBegins() {
    byte[] stream = Hex.bytes("EE EE EE  00 01  81 02");

    assertThat(Codec.frameLength(stream, 3)).isEqualTo(4 + 0x8102);
  }
}
