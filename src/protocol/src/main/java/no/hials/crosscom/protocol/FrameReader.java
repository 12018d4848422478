package no.hials.crosscom.protocol;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import no.hials.crosscom.protocol.value.PrintableText;

/**
 * Splits a stream into frames, whether TCP delivers single bytes, pieces, or several frames at
 * once. A frame that arrives whole costs one read of the stream.
 *
 * <p>Not thread-safe. No byte is lost: bytes after a frame are kept for the next one.
 */
public final class FrameReader {
  /** Enough for most answers; the buffer grows if a frame needs more. */
  private static final int START_CAPACITY = 2048;

  /** The number of characters that are not an answer in a message. */
  private static final int SHOWN = 60;

  private final Source source;
  private byte[] buffer = new byte[START_CAPACITY];
  private int end;
  private int length;

  /** The source of the bytes. */
  @FunctionalInterface
  private interface Source {
    int read(byte[] into, int offset, int count) throws IOException;
  }

  private FrameReader(Source source) {
    this.source = source;
  }

  /**
   * Creates a reader of a stream.
   *
   * @param in the stream; nothing else should read it from now on
   */
  public FrameReader(InputStream in) {
    this((Source) in::read);
  }

  /**
   * Creates a reader of a channel.
   *
   * @param in the channel; nothing else should read it from now on
   */
  public FrameReader(ReadableByteChannel in) {
    this(new ChannelSource(in));
  }

  /** Reads into memory outside the heap, so that the channel need not allocate it at each read. */
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
   * Blocks until the next frame is at the beginning of {@link #buffer()}.
   *
   * @return the frame's length, or -1 if the stream ended between two frames
   * @throws EOFException if the stream ended within a frame
   * @throws IOException if reading failed; bytes read so far are kept
   */
  public int next() throws IOException {
    int next = begin();
    while (next == 0) {
      next = fill() ? complete() : -1;
    }
    return next;
  }

  /**
   * Reads once, for a source that does not block.
   *
   * @return the length of the next frame, which is at the beginning of {@link #buffer()}; 0 if it
   *     is not complete yet; -1 if the stream ended between two frames
   * @throws EOFException if the stream ended within a frame
   * @throws IOException if reading failed; bytes read so far are kept
   */
  public int advance() throws IOException {
    int next = begin();
    if (next == 0) {
      next = fill() ? complete() : -1;
    }
    return next;
  }

  /** Drops the last frame, if any. */
  private int begin() {
    if (surplus() > 0) {
      System.arraycopy(buffer, length, buffer, 0, surplus());
    }
    end -= length;
    length = 0;
    return complete();
  }

  /** Returns the length of the frame at the beginning of the buffer, or 0 if it is incomplete. */
  private int complete() {
    if (end < Codec.HEADER_LENGTH) {
      return 0;
    }
    int needed = Codec.frameLength(buffer, 0);
    if (needed > buffer.length) {
      buffer = Arrays.copyOf(buffer, needed);
    }
    if (end < needed) {
      return 0;
    }
    length = needed;
    return needed;
  }

  /** Reads once; returns false if the stream ended between two frames. */
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
      buffer = Arrays.copyOf(buffer, end + START_CAPACITY); // full of one frame
    }
    int count = source.read(buffer, end, buffer.length - end);
    end += Math.max(0, count);
    return count;
  }

  /**
   * Reads bytes that arrived although no frame is expected. The source must not block.
   *
   * @return the number of bytes, which are part of {@link #surplus}; -1 if the stream has ended
   * @throws IOException if reading failed
   */
  public int poll() throws IOException {
    return read();
  }

  /**
   * Returns the buffer, which begins with the last frame until {@link #next()} is called.
   *
   * @return the buffer, not a copy
   */
  public byte[] buffer() {
    return buffer;
  }

  /**
   * Returns the number of bytes after the last frame.
   *
   * @return 0 or more
   */
  public int surplus() {
    return end - length;
  }

  /**
   * Returns the number of bytes in {@link #buffer()}: the last frame and the bytes after it.
   *
   * @return 0 or more
   */
  public int received() {
    return end;
  }

  /**
   * Returns the bytes after the last frame for a message, such as a frame that is not complete yet.
   *
   * @return the first 60 characters in quotes if all bytes are ASCII text, otherwise hex
   */
  public String printSurplus() {
    byte[] rest = Arrays.copyOfRange(buffer, length, end);
    for (byte each : rest) {
      if (each < ' ' && each != '\r' && each != '\n' && each != '\t') {
        return MalformedFrameException.hex(rest, rest.length);
      }
    }
    String text = new String(rest, 0, Math.min(rest.length, SHOWN), StandardCharsets.US_ASCII);
    return '"' + PrintableText.of(text) + (rest.length > SHOWN ? "...\"" : "\"");
  }
}
