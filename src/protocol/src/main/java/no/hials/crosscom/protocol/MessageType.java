package no.hials.crosscom.protocol;

import java.util.Optional;

/** The types of message, by the function byte of a frame (kukavarproxy.md, "Frames"). */
public enum MessageType {
  /** Reads a variable as text. */
  READ(0, ReadRequest.LAYOUT, ReadResponse.LAYOUT),
  /** Writes a variable as text. */
  WRITE(1, WriteRequest.LAYOUT, WriteResponse.LAYOUT),
  /** Reads an array of 16-bit numbers. */
  READ_ARRAY(2, ReadArrayRequest.LAYOUT, ReadArrayResponse.LAYOUT),
  /** Writes an array of 16-bit numbers. */
  WRITE_ARRAY(3, WriteArrayRequest.LAYOUT, WriteArrayResponse.LAYOUT);

  private final int code;

  @SuppressWarnings("ImmutableEnumChecker") // a record of two lambdas that hold nothing
  private final Layout<? extends Request> request;

  @SuppressWarnings("ImmutableEnumChecker") // likewise
  private final Layout<? extends TypedResponse> response;

  MessageType(
      int code, Layout<? extends Request> request, Layout<? extends TypedResponse> response) {
    this.code = code;
    this.request = request;
    this.response = response;
  }

  /**
   * Gives the function byte.
   *
   * @return 0 to 255
   */
  public int code() {
    return code;
  }

  /**
   * Finds a type by its function byte.
   *
   * @param code any number
   * @return the type, or nothing if this codec has none of that number
   */
  public static Optional<MessageType> from(int code) {
    for (MessageType type : values()) {
      if (type.code == code) {
        return Optional.of(type);
      }
    }
    return Optional.empty();
  }

  Layout<? extends Request> request() {
    return request;
  }

  Layout<? extends TypedResponse> response() {
    return response;
  }
}
