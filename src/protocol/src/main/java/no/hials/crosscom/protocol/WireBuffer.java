package no.hials.crosscom.protocol;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The fields that messages are made of, in a part of a frame; numbers are big-endian. */
final class WireBuffer {
  private byte[] frame;
  private final int frameLength;
  private final int end;
  private int pos;

  /**
   * @param frame a buffer that begins with the whole frame
   * @param frameLength its length, for error messages
   * @param start where the fields begin
   * @param end where they end
   */
  WireBuffer(byte[] frame, int frameLength, int start, int end) {
    this.frame = frame;
    this.frameLength = frameLength;
    this.pos = start;
    this.end = end;
  }

  MalformedFrameException malformed(String what) {
    return new MalformedFrameException(what, frame, frameLength);
  }

  /** Makes a buffer to write to, which grows. */
  static WireBuffer forWriting() {
    return new WireBuffer(new byte[64], 0, 0, 0);
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

  /** A STRING: a byte count, then ISO 8859-1, which the message's constructor has checked. */
  void putString(String value) {
    int count = value.length();
    u16(count);
    if (frame.length - pos < count) {
      frame = Arrays.copyOf(frame, 2 * pos + count);
    }
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

  int u16(String field) throws MalformedFrameException {
    need(2, field);
    pos += 2;
    return Codec.u16(frame, pos - 2);
  }

  private void need(int count, String field) throws MalformedFrameException {
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
    if (pos != end) {
      throw malformed((end - pos) + " bytes are left after the last field");
    }
  }
}
