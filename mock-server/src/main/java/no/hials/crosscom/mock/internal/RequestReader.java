package no.hials.crosscom.mock.internal;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.function.IntConsumer;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.FrameReader;
import org.jspecify.annotations.Nullable;

/** Reads the requests of a connection. Not thread-safe. */
interface RequestReader {

  /** Waits for the next request. Returns null if the client has closed the connection. */
  byte @Nullable [] next() throws IOException;

  /** Returns whether bytes of the next request have been read. */
  boolean holdsBytes();

  /** Joins the pieces of a request. */
  static RequestReader joined(InputStream in) {
    return joined(in, false);
  }

  /**
   * Joins the pieces of a request as C3 Bridge does: the first byte after a message of length 0
   * closes the connection (docs/reference/c3-messages.md#framing).
   */
  static RequestReader joinedUntilEmpty(InputStream in) {
    return joined(in, true);
  }

  private static RequestReader joined(InputStream in, boolean untilEmpty) {
    FrameReader reader = new FrameReader(in);
    return new RequestReader() {
      @Override
      public byte @Nullable [] next() throws IOException {
        int length = reader.next();
        if (untilEmpty && length == Codec.HEADER_LENGTH) {
          if (reader.surplus() == 0) {
            reader.poll();
          }
          return null;
        }
        return length < 0 ? null : Arrays.copyOf(reader.buffer(), length);
      }

      @Override
      public boolean holdsBytes() {
        return reader.surplus() > 0;
      }
    };
  }

  /**
   * Takes whole requests from each read and drops the rest, as KUKAVARPROXY does.
   *
   * @param dropped called with the number of bytes that are dropped
   */
  static RequestReader ofSingleReads(InputStream in, IntConsumer dropped) {
    return new SingleReads(in, dropped);
  }

  /** See {@link #ofSingleReads}. */
  final class SingleReads implements RequestReader {
    /**
     * The bytes that KUKAVARPROXY reads at a time
     * (docs/reference/kukavarproxy.md#pieces-of-requests).
     */
    private static final int READ = 2048;

    private final InputStream in;
    private final IntConsumer dropped;
    private final byte[] buffer = new byte[READ];
    private int start;
    private int end;

    private SingleReads(InputStream in, IntConsumer dropped) {
      this.in = in;
      this.dropped = dropped;
    }

    @Override
    public byte @Nullable [] next() throws IOException {
      while (true) {
        int left = end - start;
        int length = left < Codec.HEADER_LENGTH ? READ + 1 : Codec.frameLength(buffer, start);
        if (length <= left) {
          byte[] frame = Arrays.copyOfRange(buffer, start, start + length);
          start += length;
          return frame;
        }
        if (left > 0) {
          dropped.accept(left);
        }
        start = 0;
        // also before the end of the stream
        end = 0;
        int count = in.read(buffer);
        if (count < 0) {
          return null;
        }
        end = count;
      }
    }

    @Override
    public boolean holdsBytes() {
      return end > start;
    }
  }
}
