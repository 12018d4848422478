package no.hials.crosscom.protocol.internal;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.Strictness;
import no.hials.crosscom.protocol.file.Bytes;

/** Reads the fields of a message from a part of a frame; numbers are big-endian. */
public final class FieldReader {
  private final byte[] frame;
  private final int frameLength;
  private final int end;
  private final boolean lenient;
  private int pos;

  /**
   * Creates a reader.
   *
   * @param frame a buffer that begins with the whole frame
   * @param frameLength the length of the frame, for error messages
   * @param start the index of the first field
   * @param end the index after the last field
   * @param strictness which deviations are accepted
   */
  public FieldReader(byte[] frame, int frameLength, int start, int end, Strictness strictness) {
    this.frame = frame;
    this.frameLength = frameLength;
    this.pos = start;
    this.end = end;
    this.lenient = strictness == Strictness.LENIENT;
  }

  /** Returns the number of 16 bits at an index. */
  public static int u16At(byte[] bytes, int index) {
    return (bytes[index] & 0xFF) << 8 | (bytes[index + 1] & 0xFF);
  }

  /** Returns the ISO 8859-1 text that begins at an index. */
  public static String latin1At(byte[] bytes, int index, int count) {
    return new String(bytes, index, count, StandardCharsets.ISO_8859_1);
  }

  boolean isLenient() {
    return lenient;
  }

  boolean isEmpty() {
    return pos == end;
  }

  MalformedFrameException malformed(String what) {
    return new MalformedFrameException(what, frame, frameLength);
  }

  int u8(String field) throws MalformedFrameException {
    need(1, field);
    return frame[pos++] & 0xFF;
  }

  int i16(String field) throws MalformedFrameException {
    return (short) u16(field);
  }

  int i32(String field) throws MalformedFrameException {
    need(4, field);
    return u16(field) << 16 | u16(field);
  }

  long u32(String field) throws MalformedFrameException {
    return Integer.toUnsignedLong(i32(field));
  }

  long lowHigh(String field) throws MalformedFrameException {
    need(8, field);
    return u32(field) | (long) i32(field) << 32;
  }

  boolean bool(String field) throws MalformedFrameException {
    int value = u8(field);
    if (value > 1 && !lenient) {
      throw malformed(field + " must be 0 or 1, is " + value);
    }
    return value != 0;
  }

  String wide(String field) throws MalformedFrameException {
    int count = u16(field + " length");
    need(2L * count, field);
    char[] text = new char[count];
    for (int i = 0; i < count; i++, pos += 2) {
      text[i] = (char) ((frame[pos] & 0xFF) | frame[pos + 1] << 8);
    }
    return new String(text);
  }

  List<String> wides(int count, String field) throws MalformedFrameException {
    List<String> values = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      values.add(wide(field));
    }
    return values;
  }

  Bytes bytes(long count, String field) throws MalformedFrameException {
    need(count, field);
    pos += (int) count;
    return Bytes.of(frame, pos - (int) count, (int) count);
  }

  int u16(String field) throws MalformedFrameException {
    need(2, field);
    pos += 2;
    return u16At(frame, pos - 2);
  }

  private void need(long count, String field) throws MalformedFrameException {
    if (end - pos < count) {
      throw malformed(field + " needs " + count + " bytes, " + (end - pos) + " are left");
    }
  }

  String string(String field) throws MalformedFrameException {
    int count = u16(field + " length");
    need(count, field);
    pos += count;
    return latin1At(frame, pos - count, count);
  }

  List<Integer> words(String field) throws MalformedFrameException {
    int count = u16(field + " length");
    need(count, field);
    if (count % 2 != 0) {
      throw malformed(field + " length must be even, is " + count);
    }
    List<Integer> values = new ArrayList<>(count / 2);
    for (int i = 0; i < count; i += 2) {
      values.add(u16(field));
    }
    return values;
  }

  /** Checks that no byte is left. */
  public void expectEnd() throws MalformedFrameException {
    if (pos != end && !lenient) {
      throw malformed((end - pos) + " bytes are left after the last field");
    }
  }
}
