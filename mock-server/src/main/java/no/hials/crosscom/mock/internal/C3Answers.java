package no.hials.crosscom.mock.internal;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.code.BuildType;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.FileResponse.ContentResponse;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ListDirectoryResponse;
import no.hials.crosscom.protocol.file.FileResponse.ReadDataResponse;
import no.hials.crosscom.protocol.file.FileResponse.WriteDataResponse;
import no.hials.crosscom.protocol.program.ProgramResponse;
import no.hials.crosscom.protocol.server.Features;
import no.hials.crosscom.protocol.server.ServerInformation;
import no.hials.crosscom.protocol.server.ServerResponse.FeaturesResponse;
import no.hials.crosscom.protocol.server.ServerResponse.InformationResponse;
import no.hials.crosscom.protocol.server.SystemTime;
import no.hials.crosscom.protocol.variable.AccessResult;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteMultipleRequest;
import no.hials.crosscom.protocol.variable.VariableResponse.BenchmarkResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.MultipleResponse;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;

/**
 * Creates answers that only repeat fields of the request: C3 Bridge's answers to malformed requests
 * (docs/reference/c3-messages.md#error-codes), and scripted answers.
 */
final class C3Answers {
  /** The maximum number of bytes of an answer between function and tail. */
  static final int FIELDS = Codec.MAX_FRAME_LENGTH - Codec.HEADER_LENGTH - 1 - 3;

  private static final int OFFSET_FIELD = 1;

  /** The bytes before the text in an answer of type 13, which has the least room for it. */
  private static final int INFORMATION = 3 + 8 * 2;

  private C3Answers() {}

  /** Returns the tail with an error code. */
  static Tail tail(ErrorCode code) {
    return new Tail(code.code(), code == ErrorCode.SUCCESS ? 1 : 0);
  }

  /** Answers a request with malformed fields, or with results that do not fit. */
  static Response empty(int id, MessageType type, byte[] fields, Tail tail) {
    return answer(id, type, fields, List.of(), "", tail);
  }

  /** Creates an answer with a given value and tail. */
  static Response scripted(Request request, String value, Tail tail) {
    byte[] frame = Codec.encode(request);
    byte[] fields = Arrays.copyOfRange(frame, Codec.HEADER_LENGTH + 1, frame.length);
    int count = 0;
    if (request instanceof ReadMultipleRequest read) {
      count = read.names().size();
    } else if (request instanceof WriteMultipleRequest write) {
      count = write.assignments().size();
    }
    Code<ErrorCode> code = new Code<>(ErrorCode.class, tail.code() & 0xFF);
    String item = count == 0 ? "" : cut(value, (FIELDS - 1) / count - 1);
    List<AccessResult> results = Collections.nCopies(count, new AccessResult(code, item));
    boolean latin1 = request.type().isKnownTo(ServerType.KUKAVARPROXY);
    String text = latin1 ? value : cut(value, FIELDS - INFORMATION);
    return answer(request.id(), request.type(), fields, results, text, tail);
  }

  /** Cuts a text to the longest one that fits into these bytes as a WSTRING. */
  private static String cut(String value, int bytes) {
    return value.substring(0, Math.max(0, Math.min(value.length(), (bytes - 2) / 2)));
  }

  private static Response answer(
      int id,
      MessageType type,
      byte[] fields,
      List<AccessResult> results,
      String value,
      Tail tail) {
    int first = fields.length == 0 ? 0 : fields[0] & 0xFF;
    return switch (type) {
      case READ, WRITE -> new ValueResponse(id, type, value, tail);
      case READ_UTF16, WRITE_UTF16, FULL_NAME, KRC_NAME -> new TextResponse(id, type, value, tail);
      case READ_MULTIPLE, WRITE_MULTIPLE -> new MultipleResponse(id, type, results, tail);
      case PROGRAM_CONTROL, MOTION, PENDANT_KEY -> new ProgramResponse(id, type, first, tail);
      case INFORMATION -> new InformationResponse(id, information(value), tail);
      case FEATURES -> new FeaturesResponse(id, features(value), tail);
      case BENCHMARK -> benchmark(id, fields, tail);
      case LIST_DIRECTORY -> new ListDirectoryResponse(id, lines(value), List.of(), tail);
      case FILE_PROPERTIES -> new FilePropertiesResponse(id, FileProperties.NONE, tail);
      case WRITE_CONTENT, READ_CONTENT -> content(id, type, fields, tail);
      case READ_ARRAY,
          WRITE_ARRAY,
          SET_ATTRIBUTES,
          CREATE_FILE,
          DELETE_FILE,
          COPY_FILE,
          MOVE_FILE,
          CONFIRM_ALL ->
          new PlainResponse(id, type, tail);
    };
  }

  /** Returns the items of a directory, one in each line, as many as fit. */
  private static List<String> lines(String value) {
    List<String> lines = new ArrayList<>();
    int left = FIELDS - 2 - 2;
    for (String line : value.lines().toList()) {
      left -= 2 + 2 * line.length();
      if (left >= 0) {
        lines.add(line);
      }
    }
    return lines;
  }

  private static ServerInformation information(String computerName) {
    return new ServerInformation(
        0, 0, Code.of(BuildType.OPEN_SOURCE), SystemTime.of(Instant.EPOCH), computerName);
  }

  /** Parses the digits of {@code @PROXY_FEATURES}: the last one stands for message 0. */
  private static Features features(String digits) {
    Set<Integer> types = new TreeSet<>();
    for (int type = 0; type < Math.min(digits.length(), 256); type++) {
      if (digits.charAt(digits.length() - 1 - type) == '1') {
        types.add(type);
      }
    }
    return new Features(types);
  }

  /** Repeats as many of the fields {@code write, count, iterations} as the request has. */
  private static Response benchmark(int id, byte[] fields, Tail tail) {
    ByteBuffer in = ByteBuffer.wrap(Arrays.copyOf(fields, 1 + 1 + 4));
    boolean write = in.get() != 0;
    int count = Byte.toUnsignedInt(in.get());
    return new BenchmarkResponse(
        id, write, count, Integer.toUnsignedLong(in.getInt()), 0, 0, 0, tail);
  }

  private static Response content(int id, MessageType type, byte[] fields, Tail tail) {
    Code<ContentOperation> operation = new Code<>(ContentOperation.class, fields[0] & 0xFF);
    if (operation.is(ContentOperation.BEGIN) || operation.is(ContentOperation.SIZE)) {
      return new ContentSizeResponse(id, type, operation.known().orElseThrow(), 0, tail);
    }
    if (!operation.is(ContentOperation.DATA)) {
      return new ContentResponse(id, type, operation, tail);
    }
    long offset = Integer.toUnsignedLong(ByteBuffer.wrap(fields).getInt(OFFSET_FIELD));
    return type == MessageType.WRITE_CONTENT
        ? new WriteDataResponse(id, offset, 0, tail)
        : new ReadDataResponse(id, offset, Bytes.of(new byte[0]), tail);
  }
}
