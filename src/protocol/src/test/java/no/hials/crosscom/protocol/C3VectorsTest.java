package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import no.hials.crosscom.protocol.internal.FieldReader;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Takes every row of the measured requests and answers, {@code c3-vectors.tsv}, both ways. */
final class C3VectorsTest {

  /** The rows whose request is malformed, and the rule that it breaks. */
  private static final Map<String, String> MALFORMED =
      Map.ofEntries(
          Map.entry("0 name length field longer than the message", "name needs 20 bytes, 7 are"),
          Map.entry("0 no payload at all (length 1)", "name length needs 2 bytes, 0 are"),
          Map.entry("1 write without value field", "value length needs 2 bytes, 0 are"),
          Map.entry("4 name length field longer than the message", "name needs 40 bytes, 14 are"),
          Map.entry("6 count larger than fields", "name length needs 2 bytes, 0 are"),
          Map.entry("6 no payload (length 1)", "count needs 1 bytes, 0 are"),
          Map.entry("7 count larger than fields", "name length needs 2 bytes, 0 are"),
          Map.entry("10 select without strings", "name length needs 2 bytes, 0 are"),
          Map.entry("10 command only", "interpreter needs 2 bytes, 0 are"),
          Map.entry("11 no position", "position length needs 2 bytes, 0 are"),
          Map.entry("12 payload one byte short", "released needs 1 bytes, 0 are"),
          Map.entry("17 benchmark, missing names", "name length needs 2 bytes, 0 are"),
          Map.entry("21 payload too short", "flags needs 4 bytes, 0 are"),
          Map.entry("23 name missing", "name length needs 2 bytes, 0 are"),
          Map.entry(
              "24 copy, destination field missing", "destination length needs 2 bytes, 0 are"),
          Map.entry("29 data without fields", "offset needs 4 bytes, 0 are"),
          Map.entry("29 begin without total", "size needs 4 bytes, 0 are"));

  private enum Kind {
    /** A request that is a message. */
    MESSAGE,
    /** A request whose fields are malformed. */
    MALFORMED,
    /** A request of a type that C3 Bridge has not. */
    UNKNOWN,
    /** Bytes of a connection, which may be several frames and a part of one. */
    STREAM,
    /** A datagram, which is not a frame. */
    DATAGRAM
  }

  /**
   * A row of the file.
   *
   * @param type the message type, {@code raw} or the UDP port
   * @param meaning what it shows
   * @param request hex
   * @param answer hex, empty for none
   */
  record Row(String type, String meaning, String request, String answer) {

    String name() {
      return type + " " + meaning;
    }

    Kind kind() {
      if (type.startsWith("udp")) {
        return Kind.DATAGRAM;
      }
      if (type.equals("raw")) {
        return Kind.STREAM;
      }
      boolean known =
          MessageType.from(Integer.parseInt(type))
              .filter(ServerType.C3_BRIDGE.types()::contains)
              .isPresent();
      if (!known) {
        return Kind.UNKNOWN;
      }
      return MALFORMED.containsKey(name()) ? Kind.MALFORMED : Kind.MESSAGE;
    }

    @Override
    public String toString() {
      return name();
    }
  }

  static List<Row> rows() {
    try (InputStream in = C3VectorsTest.class.getResourceAsStream("c3-vectors.tsv")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> !line.startsWith("#"))
          .map(line -> line.split("\t", -1))
          .map(c -> new Row(c[0], c[1], c[2].replace("|", ""), c[3].equals("-") ? "" : c[3]))
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Stream<Row> rows(Kind kind) {
    return rows().stream().filter(row -> row.kind() == kind);
  }

  static Stream<Row> messages() {
    return rows(Kind.MESSAGE);
  }

  static Stream<Row> malformed() {
    return rows(Kind.MALFORMED);
  }

  static Stream<Row> unknown() {
    return rows(Kind.UNKNOWN);
  }

  static Stream<Row> streams() {
    return rows(Kind.STREAM);
  }

  static Stream<Row> answered() {
    return rows().stream()
        .filter(row -> row.kind() != Kind.DATAGRAM)
        .filter(row -> !row.answer().isEmpty());
  }

  @Test
  void everyRowIsTakenByOneOfTheTestsBelow() {
    assertThat(rows().stream().collect(Collectors.groupingBy(Row::kind, Collectors.counting())))
        .containsExactlyInAnyOrderEntriesOf(
            Map.of(
                Kind.MESSAGE, 105L,
                Kind.MALFORMED, 17L,
                Kind.UNKNOWN, 10L,
                Kind.STREAM, 12L,
                Kind.DATAGRAM, 12L));
    assertThat(malformed().map(Row::name)).containsExactlyInAnyOrderElementsOf(MALFORMED.keySet());
    assertThat(answered()).hasSize(129);
  }

  @ParameterizedTest
  @MethodSource("messages")
  void aMeasuredRequestIsAMessageOfTheseBytes(Row row) throws Exception {
    byte[] frame = Hex.bytes(row.request());

    Request request = strict(frame);

    assertThat(request.type().code()).hasToString(row.type());
    assertThat(Codec.encode(request)).isEqualTo(frame);
    assertThat(Codec.decodeRequest(frame, ServerType.C3_BRIDGE, Strictness.LENIENT))
        .isEqualTo(request);
  }

  @ParameterizedTest
  @MethodSource("malformed")
  void aMeasuredRequestThatIsMalformedIsRefusedWithIdTypeAndFields(Row row) {
    byte[] frame = Hex.bytes(row.request());

    assertThatExceptionOfType(MalformedRequestException.class)
        .isThrownBy(() -> strict(frame))
        .withMessageStartingWith(MALFORMED.get(row.name()) + " left, frame: ")
        .satisfies(
            e -> {
              assertThat(e.id()).isEqualTo(FieldReader.u16At(frame, 0));
              assertThat(e.type().code()).hasToString(row.type());
              assertThat(e.fields()).isEqualTo(Arrays.copyOfRange(frame, 5, frame.length));
            });
  }

  @ParameterizedTest
  @MethodSource("unknown")
  void aMeasuredRequestOfAnUnknownTypeIsRefusedAsSuchAndHasNoAnswer(Row row) {
    assertThatExceptionOfType(UnknownFunctionException.class)
        .isThrownBy(() -> strict(Hex.bytes(row.request())))
        .satisfies(e -> assertThat(e.function()).hasToString(row.type()));
    assertThat(row.answer()).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("messages")
  void whatOnlyC3BridgeKnowsIsAnUnknownFunctionOfKukavarproxy(Row row) throws Exception {
    byte[] frame = Hex.bytes(row.request());

    if (Integer.parseInt(row.type()) <= 1) {
      assertThat(Codec.decodeRequest(frame)).isEqualTo(strict(frame));
    } else {
      assertThatExceptionOfType(UnknownFunctionException.class)
          .isThrownBy(() -> Codec.decodeRequest(frame));
    }
  }

  @ParameterizedTest
  @MethodSource("streams")
  void aMeasuredStreamIsMadeOfMessagesOfTheseBytes(Row row) throws Exception {
    byte[] bytes = Hex.bytes(row.request());
    List<byte[]> frames = frames(bytes);
    ByteArrayOutputStream encoded = new ByteArrayOutputStream();
    if (row.meaning().startsWith("length 0")) {
      assertThatExceptionOfType(MalformedFrameException.class)
          .isThrownBy(() -> strict(frames.get(0)))
          .withMessage("a request must have a function, has none, frame: 00 01 00 00");
      encoded.write(frames.get(0));
    } else {
      for (byte[] frame : frames) {
        encoded.write(Codec.encode(strict(frame)));
      }
    }

    assertThat(Arrays.copyOf(bytes, encoded.size())).isEqualTo(encoded.toByteArray());
    assertThat(row.meaning() + ": " + (bytes.length - encoded.size()) + " bytes left")
        .isIn(
            row.meaning() + ": 0 bytes left",
            "length 0 plus type byte 00: 1 bytes left",
            "incomplete request, nothing more sent: 13 bytes left");
  }

  @ParameterizedTest
  @MethodSource("answered")
  void aMeasuredAnswerIsAMessageOfTheseBytesWithIdAndTypeOfItsRequest(Row row) throws Exception {
    List<byte[]> requests = frames(Hex.bytes(row.request()));
    List<byte[]> answers = frames(Hex.bytes(row.answer()));

    assertThat(answers).hasSameSizeAs(requests);
    for (int i = 0; i < answers.size(); i++) {
      Response response = Codec.decodeResponse(answers.get(i), ServerType.C3_BRIDGE);
      assertThat(Codec.encode(response)).isEqualTo(answers.get(i));
      assertThat(response.id()).isEqualTo(FieldReader.u16At(requests.get(i), 0));
      assertThat(response)
          .isInstanceOfSatisfying(
              TypedResponse.class,
              typed -> assertThat(typed.type().code()).isEqualTo(requests.get(0)[4]));
    }
  }

  static Stream<Row> answeredWithText() {
    return answered().filter(row -> row.type().matches("[01]"));
  }

  @ParameterizedTest
  @MethodSource("answeredWithText")
  void aMeasuredAnswerWithTextShowsItInPlaceToo(Row row) throws Exception {
    byte[] frame = Hex.bytes(row.answer());
    AnswerFrame answer = new AnswerFrame();
    answer.wrap(frame, frame.length);
    answer.openValue();

    Response response = Codec.decodeResponse(frame);

    assertThat(answer).hasToString(((ValueResponse) response).value());
  }

  private static Request strict(byte[] frame) throws MalformedFrameException {
    return Codec.decodeRequest(frame, ServerType.C3_BRIDGE, Strictness.STRICT);
  }

  /** Returns the whole frames of a stream. */
  private static List<byte[]> frames(byte[] stream) throws IOException {
    FrameReader reader = new FrameReader(new ByteArrayInputStream(stream));
    List<byte[]> frames = new ArrayList<>();
    int left = stream.length;
    while (left >= Codec.HEADER_LENGTH && left >= Codec.frameLength(stream, stream.length - left)) {
      int length = reader.next();
      frames.add(Arrays.copyOf(reader.buffer(), length));
      left -= length;
    }
    return frames;
  }
}
