package no.hials.crosscom.mock.internal;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.function.IntConsumer;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.FrameReader;
import org.jspecify.annotations.Nullable;

/** Where the requests of a connection come from. For one thread. */
interface RequestReader {

  /** Waits for the next request. Gives null if the client has closed the connection. */
  byte @Nullable [] next() throws IOException;

  /** Says whether bytes are kept for the next request. */
  boolean holdsBytes();

  /** Puts together what arrives in pieces. */
  static RequestReader joined(InputStream in) {
    return joined(in, false);
  }

  /**
   * Puts together what arrives in pieces, as C3 Bridge does: it closes the connection on the byte
   * that follows a message of length 0 (docs/reference/c3-messages.md#framing).
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
   * Takes whole requests out of each read, as KUKAVARPROXY does.
   *
   * @param dropped is told how many bytes a read had that were no whole request
   */
  static RequestReader ofSingleReads(InputStream in, IntConsumer dropped) {
    return new SingleReads(in, dropped);
  }

  /** Takes whole requests out of each read; the rest of a read is dropped. */
  final class SingleReads implements RequestReader {
    /** What KUKAVARPROXY reads at a time (docs/reference/kukavarproxy.md#pieces-of-requests). */
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
        // the end of the stream must leave nothing behind, too
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
