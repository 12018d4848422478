package no.hials.crosscom.protocol;

import java.nio.ByteBuffer;
import no.hials.crosscom.protocol.internal.FieldReader;
import no.hials.crosscom.protocol.internal.FieldWriter;
import no.hials.crosscom.protocol.internal.Layouts;
import no.hials.crosscom.protocol.internal.Ranges;
import org.jspecify.annotations.Nullable;

/**
 * Encodes messages as frames and decodes frames. A frame is {@code id u16, length u16, function u8,
 * fields}, and an answer ends with the three bytes of the {@link Tail}; all numbers are big-endian
 * (docs/reference/wire-format.md, docs/reference/c3-messages.md#framing).
 *
 * <p>Any bytes can be decoded: the result is a message or a {@link MalformedFrameException}.
 */
public final class Codec {
  /** The length of the header: the length field counts the bytes after it. */
  public static final int HEADER_LENGTH = 4;

  /** The length of the longest frame. */
  public static final int MAX_FRAME_LENGTH = HEADER_LENGTH + Ranges.MAX_U16;

  private Codec() {}

  /**
   * Encodes a request.
   *
   * @param request the message
   * @return the frame
   */
  public static byte[] encode(Request request) {
    return encode(request.id(), request.type(), request, null);
  }

  /**
   * Encodes an answer.
   *
   * @param response the message
   * @return the frame
   */
  public static byte[] encode(Response response) {
    if (response instanceof TypedResponse typed) {
      return encode(typed.id(), typed.type(), typed, typed.tail());
    }
    byte[] frame = new byte[HEADER_LENGTH];
    setId(frame, response.id());
    return frame;
  }

  private static byte[] encode(int id, MessageType type, Object message, @Nullable Tail tail) {
    FieldWriter out = new FieldWriter();
    begin(out, id, type);
    Layouts.write(message, out);
    if (tail != null) {
      out.u16(tail.code()).u8(tail.flag());
    }
    end(out);
    return out.toByteArray();
  }

  static void begin(FieldWriter out, int id, MessageType type) {
    // the length is known at the end
    out.u16(id).u16(0).u8(type.code());
  }

  static void end(FieldWriter out) {
    putU16(out.buffer(), 2, out.length() - HEADER_LENGTH);
  }

  /**
   * Replaces the id of an encoded message.
   *
   * @param frame a buffer that begins with the frame
   * @param id 0 to 65535
   */
  public static void setId(byte[] frame, int id) {
    Ranges.u16("id", id);
    putU16(frame, 0, id);
  }

  /**
   * Replaces the id of an encoded message.
   *
   * @param frame a buffer with the frame at index 0; its position does not matter
   * @param id 0 to 65535
   */
  public static void setId(ByteBuffer frame, int id) {
    Ranges.u16("id", id);
    frame.put(0, (byte) (id >> 8)).put(1, (byte) id);
  }

  /**
   * Returns the length of a frame from its header.
   *
   * @param header a buffer with at least {@link #HEADER_LENGTH} bytes of the frame
   * @param offset the index at which the frame begins
   * @return the length of the whole frame, with the header
   */
  public static int frameLength(byte[] header, int offset) {
    return HEADER_LENGTH + FieldReader.u16At(header, offset + 2);
  }

  /**
   * Decodes a request to KUKAVARPROXY.
   *
   * @param frame the bytes of one frame
   * @return the message
   * @throws MalformedRequestException if only the fields are malformed
   * @throws MalformedFrameException if the frame is malformed
   * @throws UnknownFunctionException if the server does not support the function
   */
  public static Request decodeRequest(byte[] frame) throws MalformedFrameException {
    return decodeRequest(frame, ServerType.KUKAVARPROXY, Strictness.STRICT);
  }

  /**
   * Decodes a request.
   *
   * @param frame the bytes of one frame
   * @param server the receiver of the request
   * @param strictness whether bytes that no client sends are accepted
   * @return the message
   * @throws MalformedRequestException if only the fields are malformed
   * @throws MalformedFrameException if the frame is malformed
   * @throws UnknownFunctionException if the server does not support the function
   */
  public static Request decodeRequest(byte[] frame, ServerType server, Strictness strictness)
      throws MalformedFrameException {
    checkLength(frame, frame.length);
    if (frame.length == HEADER_LENGTH) {
      throw new MalformedFrameException(
          "a request must have a function, has none", frame, frame.length);
    }
    int id = FieldReader.u16At(frame, 0);
    MessageType type = type(frame, server, id);
    FieldReader fields =
        new FieldReader(frame, frame.length, HEADER_LENGTH + 1, frame.length, strictness);
    try {
      Request request = Layouts.readRequest(type, id, fields);
      fields.expectEnd();
      return request;
    } catch (MalformedFrameException e) {
      throw new MalformedRequestException(id, type, frame, e);
    }
  }

  private static MessageType type(byte[] frame, ServerType server, int id)
      throws UnknownFunctionException {
    int function = frame[HEADER_LENGTH] & 0xFF;
    MessageType type = MessageType.find(function);
    if (type == null || !type.isKnownTo(server)) {
      throw new UnknownFunctionException(id, function, server, frame, frame.length);
    }
    return type;
  }

  /**
   * Decodes an answer of KUKAVARPROXY.
   *
   * @param frame the bytes of one frame
   * @return the message
   * @throws MalformedFrameException if the frame is malformed
   * @throws UnknownFunctionException if the server does not support the function
   */
  public static Response decodeResponse(byte[] frame) throws MalformedFrameException {
    return decodeResponse(frame, ServerType.KUKAVARPROXY);
  }

  /**
   * Decodes an answer, always strictly.
   *
   * @param frame the bytes of one frame
   * @param server the sender of the answer
   * @return the message
   * @throws MalformedFrameException if the frame is malformed
   * @throws UnknownFunctionException if the server does not support the function
   */
  public static Response decodeResponse(byte[] frame, ServerType server)
      throws MalformedFrameException {
    AnswerFrame answer = new AnswerFrame();
    answer.wrap(frame, frame.length);
    int id = answer.id();
    if (answer.functionUnknown()) {
      return new EmptyResponse(id);
    }
    MessageType type = type(frame, server, id);
    FieldReader fields = answer.fields();
    Tail tail = new Tail(answer.code(), frame[frame.length - 1] & 0xFF);
    Response response = Layouts.readAnswer(type, id, fields, tail);
    fields.expectEnd();
    return response;
  }

  static void checkLength(byte[] frame, int length) throws MalformedFrameException {
    if (length < HEADER_LENGTH) {
      throw new MalformedFrameException(
          "a frame has at least " + HEADER_LENGTH + " bytes, has " + length, frame, length);
    }
    if (frameLength(frame, 0) != length) {
      throw new MalformedFrameException(
          "the length field must be "
              + (length - HEADER_LENGTH)
              + ", is "
              + (frameLength(frame, 0) - HEADER_LENGTH),
          frame,
          length);
    }
  }

  private static void putU16(byte[] bytes, int offset, int value) {
    bytes[offset] = (byte) (value >> 8);
    bytes[offset + 1] = (byte) value;
  }
}
