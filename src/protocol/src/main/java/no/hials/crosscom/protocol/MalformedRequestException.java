package no.hials.crosscom.protocol;

import java.util.Arrays;

/**
 * Says that a frame is a request of a known type whose fields are malformed, which C3 Bridge
 * answers with {@link ErrorCode#PROTOCOL} (c3-bridge.md, "codes").
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
   * Gives the frame's id, by which a server answers it.
   *
   * @return 0 to 65535
   */
  public int id() {
    return id;
  }

  /**
   * Gives the frame's type.
   *
   * @return the type of the request that it is not
   */
  public MessageType type() {
    return type;
  }

  /**
   * Gives what follows the function byte, of which C3 Bridge repeats the beginning in answers of
   * some types (c3-vectors.tsv).
   *
   * @return the bytes, a copy
   */
  public byte[] fields() {
    return fields.clone();
  }
}
