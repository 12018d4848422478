package no.hials.crosscom.protocol;

import java.util.Arrays;

/**
 * Thrown when a frame is a request of a known type with malformed fields. C3 Bridge answers with
 * {@link ErrorCode#PROTOCOL}.
 */
public final class MalformedRequestException extends MalformedFrameException {
  private static final long serialVersionUID = 1L;

  private final int id;
  private final MessageType type;
  private final byte[] fields;

  MalformedRequestException(int id, MessageType type, byte[] frame, MalformedFrameException cause) {
    super(cause);
    this.id = id;
    this.type = type;
    this.fields = Arrays.copyOfRange(frame, Codec.HEADER_LENGTH + 1, frame.length);
  }

  /**
   * Returns the frame's id, which the answer repeats.
   *
   * @return 0 to 65535
   */
  public int id() {
    return id;
  }

  /**
   * Returns the frame's type.
   *
   * @return the type
   */
  public MessageType type() {
    return type;
  }

  /**
   * Returns the bytes after the function byte. C3 Bridge repeats the first of them in answers of
   * some types (docs/reference/c3-messages.md#error-codes).
   *
   * @return the bytes, a copy
   */
  public byte[] fields() {
    return fields.clone();
  }
}
