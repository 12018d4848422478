package no.hials.crosscom.protocol;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.util.Arrays;

/**
 * Cuts a stream into frames, however TCP has cut it: in single bytes, in pieces, or several frames
 * in one piece. A frame that arrives whole costs one read of the stream.
 *
 * <p>For one thread. No byte is lost: what follows a frame is kept for the next.
 */
public final class FrameReader {
  /** Takes most answers; grows to what a frame needs. */
  private static final int START_CAPACITY = 2048;

  private final Source source;
  private byte[] buffer = new byte[START_CAPACITY];
  private int end;
  private int length;

  /** Where the bytes come from. */
  @FunctionalInterface
  private interface Source {
    int read(byte[] into, int offset, int count) throws IOException;
  }

  private FrameReader(Source source) {
    this.source = source;
  }

  /**
   * Makes a reader of a stream.
   *
   * @param in the stream; should not be read by others from now on
   */
  public FrameReader(InputStream in) {
    this((Source) in::read);
  }

  /**
   * Makes a reader of a channel.
   *
   * @param in the channel; should not be read by others from now on
   */
  public FrameReader(ReadableByteChannel in) {
    this(new ChannelSource(in));
  }

  /** Reads by way of memory outside the heap, so that the channel need not find some each time. */
  private static final class ChannelSource implements Source {
    private final ReadableByteChannel in;
    private final ByteBuffer direct = ByteBuffer.allocateDirect(START_CAPACITY);

    ChannelSource(ReadableByteChannel in) {
      this.in = in;
    }

    @Override
    public int read(byte[] into, int offset, int count) throws IOException {
      direct.clear().limit(Math.min(count, START_CAPACITY));
      int got = in.read(direct);
      if (got > 0) {
        direct.get(0, into, offset, got);
      }
      return got;
    }
  }

  /**
   * Waits for the next frame. It is then at the beginning of {@link #buffer()}.
   *
   * @return the frame's length, or -1 if the stream ended between two frames
   * @throws EOFException if the stream ended within a frame
   * @throws IOException if reading failed; bytes read so far are kept
   */
  public int next() throws IOException {
    System.arraycopy(buffer, length, buffer, 0, end - length);
    end -= length;
    length = 0;
    while (end < Codec.HEADER_LENGTH) {
      if (!fill()) {
        return -1;
      }
    }
    int needed = Codec.frameLength(buffer, 0);
    if (needed > buffer.length) {
      buffer = Arrays.copyOf(buffer, needed);
    }
    while (end < needed) {
      fill();
    }
    length = needed;
    return needed;
  }

  /** Gives false if the stream ended cleanly. */
  private boolean fill() throws IOException {
    int count = read();
    if (count < 0) {
      if (end == 0) {
        return false;
      }
      throw new EOFException(
          "the stream ended within a frame, after: " + MalformedFrameException.hex(buffer, end));
    }
    return true;
  }

  private int read() throws IOException {
    if (end == buffer.length) {
      buffer = Arrays.copyOf(buffer, end + START_CAPACITY); // full of one frame: make room for more
    }
    int count = source.read(buffer, end, buffer.length - end);
    end += Math.max(0, count);
    return count;
  }

  /**
   * Reads once what has come although no frame was waited for. The source should not block.
   *
   * @return how many bytes came; they are {@link #surplus}. -1 if the stream has ended
   * @throws IOException if reading failed
   */
  public int poll() throws IOException {
    return read();
  }

  /**
   * Gives the buffer whose first bytes are the last frame. It is valid until {@link #next()}.
   *
   * @return the buffer, not a copy
   */
  public byte[] buffer() {
    return buffer;
  }

  /**
   * Says how many bytes came that are not part of the last frame.
   *
   * @return 0 or more
   */
  public int surplus() {
    return end - length;
  }

  /**
   * Prints what came of a frame that is not whole yet, or behind the last one, in hex.
   *
   * @return the bytes
   */
  public String surplusHex() {
    byte[] rest = new byte[surplus()];
    System.arraycopy(buffer, length, rest, 0, rest.length);
    return MalformedFrameException.hex(rest, rest.length);
  }
}
