package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.internal.FieldWriter;
import no.hials.crosscom.protocol.internal.Ranges;
import no.hials.crosscom.protocol.internal.VariableLayouts;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;

/**
 * A buffer for write requests that is reused, so that encoding creates no objects. Not thread-safe.
 */
public final class FrameWriter {
  private final FieldWriter out = new FieldWriter();

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
    Ranges.assignment(name, value);
    out.clear();
    Codec.begin(out, 0, MessageType.WRITE);
    VariableLayouts.write(name, value, out);
    Codec.end(out);
  }

  /**
   * Returns the buffer whose first {@link #length} bytes are the frame.
   *
   * @return the buffer, not a copy; the next frame may be in another buffer
   */
  public byte[] buffer() {
    return out.buffer();
  }

  /**
   * Returns the length of the frame.
   *
   * @return in bytes
   */
  public int length() {
    return out.length();
  }
}
