package no.hials.crosscom.protocol;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The fields that messages are made of, in a part of a frame; numbers are big-endian. */
final class WireBuffer {
  private byte[] frame;
  private final int frameLength;
  private final int end;
  private final boolean lenient;
  private int pos;

  /**
   * @param frame a buffer that begins with the whole frame
   * @param frameLength its length, for error messages
   * @param start where the fields begin
   * @param end where they end
   */
  WireBuffer(byte[] frame, int frameLength, int start, int end) {
    this(frame, frameLength, start, end, Strictness.STRICT);
  }

  WireBuffer(byte[] frame, int frameLength, int start, int end, Strictness strictness) {
    this.frame = frame;
    this.frameLength = frameLength;
    this.pos = start;
    this.end = end;
    this.lenient = strictness == Strictness.LENIENT;
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

  /** Makes a buffer to write to, which grows. */
  static WireBuffer forWriting() {
    return new WireBuffer(new byte[64], 0, 0, 0);
  }

  /** Starts again at the beginning, in the same memory. */
  void clear() {
    pos = 0;
  }

  /** Returns the bytes, of which the first {@link #size} were written. */
  byte[] array() {
    return frame;
  }

  int size() {
    return pos;
  }

  byte[] toByteArray() {
    return Arrays.copyOf(frame, pos);
  }

  void u8(int value) {
    if (pos == frame.length) {
      frame = Arrays.copyOf(frame, 2 * pos);
    }
    frame[pos++] = (byte) value;
  }

  void u16(int value) {
    u8(value >> 8);
    u8(value);
  }

  /** A number of 32 bits, signed or not. */
  void i32(int value) {
    u16(value >> 16);
    u16(value);
  }

  void u32(long value) {
    i32((int) value);
  }

  void bool(boolean value) {
    u8(value ? 1 : 0);
  }

  /** 64 bits as C3 Bridge has them: two numbers of 32, the lower first (c3-bridge.md, type 26). */
  void lowHigh(long value) {
    i32((int) value);
    i32((int) (value >> 32));
  }

  /** A WSTRING: a count of characters, then UTF-16, little-endian (c3-bridge.md). */
  void putWide(String value) {
    int count = value.length();
    u16(count);
    reserve(2 * count);
    for (int i = 0; i < count; i++) {
      char c = value.charAt(i);
      u8(c);
      u8(c >> 8);
    }
  }

  void putBytes(Bytes value) {
    reserve(value.size());
    value.copyTo(frame, pos);
    pos += value.size();
  }

  private void reserve(int count) {
    if (frame.length - pos < count) {
      frame = Arrays.copyOf(frame, 2 * pos + count);
    }
  }

  /** A STRING: a byte count, then ISO 8859-1, which the message's constructor has checked. */
  void putString(CharSequence value) {
    int count = value.length();
    u16(count);
    reserve(count);
    byte[] target = frame;
    int offset = pos;
    for (int i = 0; i < count; i++) {
      target[offset + i] = (byte) value.charAt(i);
    }
    pos += count;
  }

  /** A block of 16-bit numbers: a byte count, then the numbers. */
  void putWords(List<Integer> values) {
    u16(values.size() * 2);
    for (int value : values) {
      u16(value);
    }
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
    return Codec.u16(frame, pos - 2);
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
    return Codec.latin1(frame, pos - count, count);
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

  void expectEnd() throws MalformedFrameException {
    if (pos != end && !lenient) {
      throw malformed((end - pos) + " bytes are left after the last field");
    }
  }
}
