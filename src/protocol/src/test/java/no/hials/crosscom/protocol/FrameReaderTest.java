package no.hials.crosscom.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import no.hials.crosscom.protocol.variable.VariableResponse.ValueResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

final class FrameReaderTest {
  // the answers 100 and 50 (docs/reference/wire-format.md#examples)
  private static final byte[] ANSWER_100 = Hex.bytes("00 00 00 09 00 00 03 31 30 30 00 01 01");
  private static final byte[] ANSWER_50 = Hex.bytes("00 01 00 08 01 00 02 35 30 00 01 01");
  // the answer to an unknown function (docs/reference/kukavarproxy.md#unknown-functions)
  private static final byte[] EMPTY = Hex.bytes("00 02 00 00");
  private static final byte[] LONGEST_FRAME =
      Codec.encode(
          new ValueResponse(
              3, MessageType.READ, "0123456789abc".repeat(5037) + "!".repeat(48), Tail.SUCCESS));

  /**
   * A stream and a channel that give their bytes in pieces, as TCP may, and count how often they
   * are asked. An empty piece stands for a time in which nothing comes.
   */
  private static final class Pieces extends InputStream implements ReadableByteChannel {
    private final List<byte[]> pieces;
    private int piece;
    private int offset;
    private int reads;

    Pieces(List<byte[]> pieces) {
      this.pieces = pieces;
    }

    static Pieces of(byte[]... pieces) {
      return new Pieces(List.of(pieces));
    }

    /** Cuts bytes to a size; the last piece may be shorter. */
    static Pieces cut(byte[] bytes, int size) {
      int count = (bytes.length + size - 1) / size;
      byte[][] pieces = new byte[count][];
      for (int i = 0; i < count; i++) {
        pieces[i] = Arrays.copyOfRange(bytes, i * size, Math.min(bytes.length, (i + 1) * size));
      }
      return of(pieces);
    }

    @Override
    public int read() {
      throw new AssertionError("single bytes are not to be read");
    }

    @Override
    public int read(byte[] into, int start, int length) throws IOException {
      return read(ByteBuffer.wrap(into, start, length));
    }

    @Override
    public int read(ByteBuffer into) throws IOException {
      assertThat(into.remaining()).as("room of a read").isPositive();
      reads++;
      if (piece == pieces.size()) {
        return -1;
      }
      byte[] current = pieces.get(piece);
      if (current.length == 0) {
        piece++;
        throw new SocketTimeoutException("nothing came in time");
      }
      int count = Math.min(into.remaining(), current.length - offset);
      into.put(current, offset, count);
      offset += count;
      if (offset == current.length) {
        piece++;
        offset = 0;
      }
      return count;
    }

    @Override
    public boolean isOpen() {
      return true;
    }
  }

  private static byte[] join(byte[]... parts) {
    int length = 0;
    for (byte[] part : parts) {
      length += part.length;
    }
    byte[] joined = new byte[length];
    int at = 0;
    for (byte[] part : parts) {
      System.arraycopy(part, 0, joined, at, part.length);
      at += part.length;
    }
    return joined;
  }

  private static void expectNext(FrameReader reader, byte[] frame) throws IOException {
    int length = reader.next();

    assertThat(length).as("length").isEqualTo(frame.length);
    assertThat(Arrays.mismatch(reader.buffer(), 0, length, frame, 0, frame.length))
        .as("first byte that differs")
        .isEqualTo(-1);
  }

  @Test
  void aFrameThatArrivesWholeCostsOneRead() throws Exception {
    Pieces in = Pieces.of(ANSWER_100, ANSWER_50);
    FrameReader reader = new FrameReader((InputStream) in);

    expectNext(reader, ANSWER_100);
    assertThat(in.reads).isEqualTo(1);
    expectNext(reader, ANSWER_50);
    assertThat(in.reads).isEqualTo(2);
    assertThat(reader.next()).isEqualTo(-1);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 7, 12, 13, 14})
  void framesInSegmentsOfAnySizeAreReadOneByOne(int size) throws Exception {
    Pieces in = Pieces.cut(join(ANSWER_100, ANSWER_50, EMPTY, ANSWER_50), size);
    FrameReader reader = new FrameReader((InputStream) in);

    expectNext(reader, ANSWER_100);
    expectNext(reader, ANSWER_50);
    expectNext(reader, EMPTY);
    expectNext(reader, ANSWER_50);
    assertThat(reader.next()).isEqualTo(-1);
  }

  @Test
  void twoFramesInOneSegmentCostOneReadTogether() throws Exception {
    Pieces in = Pieces.of(join(ANSWER_100, ANSWER_50));
    FrameReader reader = new FrameReader((InputStream) in);

    expectNext(reader, ANSWER_100);
    expectNext(reader, ANSWER_50);
    assertThat(in.reads).isEqualTo(1);
  }

  @Test
  void whatCameBehindAFrameIsSurplusUntilTheNextIsRead() throws Exception {
    FrameReader reader =
        new FrameReader(
            (InputStream) Pieces.of(join(ANSWER_100, Hex.bytes("00 01 00"), new byte[0])));

    assertThat(reader.surplus()).isZero();
    assertThat(reader.printSurplus()).isEqualTo("\"\"");
    expectNext(reader, ANSWER_100);
    assertThat(reader.surplus()).isEqualTo(3);
    assertThat(reader.printSurplus()).isEqualTo("00 01 00");
  }

  @Test
  void aFrameAloneLeavesNoSurplus() throws Exception {
    FrameReader reader = new FrameReader((InputStream) Pieces.of(ANSWER_100));

    expectNext(reader, ANSWER_100);
    assertThat(reader.surplus()).isZero();
    assertThat(reader.printSurplus()).isEqualTo("\"\"");
  }

  @Test
  void theLongestFrameIsReadFromOneSegment() throws Exception {
    assertThat(LONGEST_FRAME).hasSize(65539);
    FrameReader reader = new FrameReader((InputStream) Pieces.of(join(LONGEST_FRAME, ANSWER_50)));

    expectNext(reader, LONGEST_FRAME);
    expectNext(reader, ANSWER_50);
    assertThat(reader.next()).isEqualTo(-1);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 1460, 2047, 2048, 2049, 65538, 65539})
  void theLongestFrameIsReadFromManySegments(int size) throws Exception {
    FrameReader reader =
        new FrameReader((InputStream) Pieces.cut(join(ANSWER_100, LONGEST_FRAME, ANSWER_50), size));

    expectNext(reader, ANSWER_100);
    expectNext(reader, LONGEST_FRAME);
    expectNext(reader, ANSWER_50);
    assertThat(reader.next()).isEqualTo(-1);
  }

  @ParameterizedTest
  @ValueSource(ints = {2047, 2048, 2049, 4096})
  void framesAroundTheFirstBuffersSizeAreRead(int length) throws Exception {
    byte[] frame =
        Codec.encode(new ValueResponse(1, MessageType.READ, "v".repeat(length - 10), Tail.SUCCESS));
    assertThat(frame).hasSize(length);
    FrameReader reader = new FrameReader((InputStream) Pieces.of(frame, frame, ANSWER_50));

    expectNext(reader, frame);
    expectNext(reader, frame);
    expectNext(reader, ANSWER_50);
  }

  @Test
  void aStreamThatEndsBetweenFramesIsAtItsEnd() throws Exception {
    FrameReader reader = new FrameReader((InputStream) Pieces.of(ANSWER_100));
    expectNext(reader, ANSWER_100);

    assertThat(reader.next()).isEqualTo(-1);
    assertThat(reader.next()).isEqualTo(-1);
    assertThat(new FrameReader((InputStream) Pieces.of()).next()).isEqualTo(-1);
  }

  @Test
  void aStreamThatEndsAnywhereWithinAFrameIsAnError() throws Exception {
    for (int length = 1; length < ANSWER_100.length; length++) {
      byte[] cut = Arrays.copyOf(ANSWER_100, length);
      FrameReader reader = new FrameReader((InputStream) Pieces.of(ANSWER_50, cut));
      expectNext(reader, ANSWER_50);

      assertThatExceptionOfType(EOFException.class)
          .isThrownBy(reader::next)
          .withMessage(
              "the stream ended within a frame, after: "
                  + MalformedFrameException.hex(cut, cut.length));
    }
  }

  @Test
  void aTimeOutWithinAFrameLosesNoByte() throws Exception {
    byte[] nothing = new byte[0];
    FrameReader reader =
        new FrameReader(
            (InputStream)
                Pieces.of(
                    Arrays.copyOf(ANSWER_100, 3),
                    nothing,
                    Arrays.copyOfRange(ANSWER_100, 3, 9),
                    nothing,
                    join(Arrays.copyOfRange(ANSWER_100, 9, 13), ANSWER_50)));

    assertThatExceptionOfType(SocketTimeoutException.class).isThrownBy(reader::next);
    assertThat(reader.printSurplus()).isEqualTo("00 00 00");
    assertThatExceptionOfType(SocketTimeoutException.class).isThrownBy(reader::next);
    assertThat(reader.printSurplus()).isEqualTo("00 00 00 09 00 00 03 31 30");
    expectNext(reader, ANSWER_100);
    expectNext(reader, ANSWER_50);
  }

  @Test
  void moreThanAThousandFramesInOneSegmentAreReadOneByOne() throws Exception {
    byte[] all = join(Collections.nCopies(1001, ANSWER_100).toArray(byte[][]::new));
    FrameReader reader = new FrameReader((InputStream) Pieces.of(all));

    for (int i = 0; i < 1001; i++) {
      expectNext(reader, ANSWER_100);
    }
    assertThat(reader.next()).isEqualTo(-1);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3, 4, 5, 13, 2048, 70_000})
  void aChannelIsCutIntoFramesAsAStreamIs(int size) throws Exception {
    byte[] all = join(ANSWER_100, EMPTY, LONGEST_FRAME, ANSWER_50);
    FrameReader reader = new FrameReader((ReadableByteChannel) Pieces.cut(all, size));

    expectNext(reader, ANSWER_100);
    expectNext(reader, EMPTY);
    expectNext(reader, LONGEST_FRAME);
    expectNext(reader, ANSWER_50);
    assertThat(reader.next()).isEqualTo(-1);
  }

  @Test
  void aFrameThatArrivesWholeCostsOneReadOfAChannel() throws Exception {
    Pieces in = Pieces.of(ANSWER_100, ANSWER_50);
    FrameReader reader = new FrameReader((ReadableByteChannel) in);

    expectNext(reader, ANSWER_100);
    expectNext(reader, ANSWER_50);
    assertThat(in.reads).isEqualTo(2);
  }

  @Test
  void aChannelThatEndsWithinAFrameIsAnError() throws Exception {
    FrameReader reader =
        new FrameReader((ReadableByteChannel) Pieces.of(ANSWER_100, Hex.bytes("00 01 00 08 01")));
    expectNext(reader, ANSWER_100);

    assertThatExceptionOfType(EOFException.class)
        .isThrownBy(reader::next)
        .withMessage("the stream ended within a frame, after: 00 01 00 08 01");
  }

  @Test
  void whatIsPolledIsSurplusAndThenPartOfTheNextFrame() throws Exception {
    Pieces in =
        Pieces.of(ANSWER_100, Hex.bytes("00 01 00"), Hex.bytes("08 01 00 02 35 30 00 01 01"));
    FrameReader reader = new FrameReader((InputStream) in);
    expectNext(reader, ANSWER_100);

    assertThat(reader.poll()).isEqualTo(3);

    assertThat(in.reads).isEqualTo(2);
    assertThat(reader.surplus()).isEqualTo(3);
    assertThat(reader.printSurplus()).isEqualTo("00 01 00");
    assertThat(Arrays.copyOf(reader.buffer(), ANSWER_100.length))
        .as("the last frame stays")
        .isEqualTo(ANSWER_100);
    expectNext(reader, ANSWER_50);
    assertThat(reader.poll()).isEqualTo(-1);
    assertThat(reader.surplus()).isZero();
  }
}
