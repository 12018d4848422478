package no.hials.crosscom.protocol;

/**
 * A buffer for write requests that is used again and again, so that encoding one creates no
 * objects. For one thread.
 */
public final class FrameWriter {
  private final WireBuffer out = WireBuffer.forWriting();

  /** Creates an empty buffer. */
  public FrameWriter() {}

  /**
   * Encodes a {@link WriteRequest} with id 0 in place of the last frame.
   *
   * @param name the variable's name
   * @param value the value as KRL text
   * @throws IllegalArgumentException if {@link WriteRequest} does not accept them
   */
  public void write(CharSequence name, CharSequence value) {
    WriteRequest.check(name, value);
    out.clear();
    Codec.begin(out, 0, MessageType.WRITE);
    WriteRequest.put(out, name, value);
    Codec.end(out);
  }

  /**
   * Returns the buffer whose first {@link #length} bytes are the frame.
   *
   * @return the buffer, not a copy; another one may replace it at the next frame
   */
  public byte[] buffer() {
    return out.array();
  }

  /**
   * Returns the length of the frame.
   *
   * @return in bytes
   */
  public int length() {
    return out.size();
  }
}
