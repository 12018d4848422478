package no.hials.crosscom.mock.internal;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.FrameReader;
import org.jspecify.annotations.Nullable;

/** Reads the requests of a connection. Not thread-safe. */
interface RequestReader {

  /** Waits for the next request. Returns null if the client has closed the connection. */
  byte @Nullable [] next() throws IOException;

  /** Returns whether bytes of the next request have been read. */
  boolean holdsBytes();

  /**
   * Joins the pieces of a request as C3 Bridge does: the first byte after a message of length 0
   * closes the connection (docs/reference/c3-messages.md#framing).
   */
  static RequestReader joined(InputStream in) {
    FrameReader reader = new FrameReader(in);
    return new RequestReader() {
      @Override
      public byte @Nullable [] next() throws IOException {
        int length = reader.next();
        if (length == Codec.HEADER_LENGTH) {
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
}
