package no.hials.crosscom.mock.internal;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.function.IntConsumer;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.MessageType;
import org.jspecify.annotations.Nullable;

/**
 * Reads requests as KUKAVARPROXY does (docs/reference/kukavarproxy.md#pieces-of-requests): it takes
 * one request from what it has received, by the lengths of name and value, and drops the bytes
 * after it.
 */
final class ReceivedRequests implements RequestReader {
  /** The bytes that KUKAVARPROXY reads at a time. */
  private static final int READ = 2048;

  /** The end of the length of the name, which follows the function. */
  private static final int NAME = Codec.HEADER_LENGTH + 1 + 2;

  /** More than any frame, if the bytes do not show where it ends. */
  private static final int UNKNOWN = Integer.MAX_VALUE;

  private final InputStream in;
  private final boolean joins;
  private final IntConsumer dropped;
  private byte[] buffer = new byte[READ];
  private int end;

  /**
   * Creates a reader.
   *
   * @param joins whether the pieces of a request are joined; KUKAVARPROXY drops them
   * @param dropped called with the number of bytes that are dropped
   */
  ReceivedRequests(InputStream in, boolean joins, IntConsumer dropped) {
    this.in = in;
    this.joins = joins;
    this.dropped = dropped;
  }

  @Override
  public byte @Nullable [] next() throws IOException {
    while (true) {
      if (buffer.length - end < READ) {
        buffer = Arrays.copyOf(buffer, 2 * buffer.length);
      }
      int count = in.read(buffer, end, READ);
      if (count < 0) {
        return null;
      }
      end += count;
      byte[] frame = frame();
      if (frame != null || !joins) {
        drop(end - (frame == null ? 0 : frame.length));
        end = 0;
      }
      if (frame != null) {
        return frame;
      }
    }
  }

  private void drop(int bytes) {
    if (bytes > 0) {
      dropped.accept(bytes);
    }
  }

  /** Returns the request at the start of the buffer; null if it is not whole. */
  private byte @Nullable [] frame() {
    if (end < Codec.HEADER_LENGTH) {
      return null;
    }
    int length = ownLength();
    if (length <= Math.min(end, Codec.MAX_FRAME_LENGTH)) {
      byte[] frame = Arrays.copyOf(buffer, length);
      // a wrong length field does not matter
      int rest = length - Codec.HEADER_LENGTH;
      frame[2] = (byte) (rest >> 8);
      frame[3] = (byte) rest;
      return frame;
    }
    int announced = Codec.frameLength(buffer, 0);
    return announced <= end ? Arrays.copyOf(buffer, announced) : null;
  }

  /** Returns the length of the request by the lengths of its name and value. */
  private int ownLength() {
    if (end < NAME) {
      return UNKNOWN;
    }
    int function = buffer[Codec.HEADER_LENGTH] & 0xFF;
    int name = NAME + u16(NAME - 2);
    if (function == MessageType.READ.code() || function == MessageType.READ_ARRAY.code()) {
      return name;
    }
    boolean writes =
        function == MessageType.WRITE.code() || function == MessageType.WRITE_ARRAY.code();
    return writes && name + 2 <= end ? name + 2 + u16(name) : UNKNOWN;
  }

  private int u16(int index) {
    return (buffer[index] & 0xFF) << 8 | (buffer[index + 1] & 0xFF);
  }

  /** Always false: bytes after a request are dropped. */
  @Override
  public boolean holdsBytes() {
    return false;
  }
}
