package no.hials.crosscom.protocol.internal;

import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.value.KrlText;

/** Writes the fields of a message, one after the other; numbers are big-endian. */
public final class FieldWriter {
  private byte[] buffer = new byte[64];
  private int length;

  /** Creates a writer without bytes. */
  public FieldWriter() {}

  /** Removes all bytes, and keeps the memory. */
  public void clear() {
    length = 0;
  }

  /** Returns the buffer whose first {@link #length} bytes were written, not a copy. */
  public byte[] buffer() {
    return buffer;
  }

  /** Returns the number of bytes written. */
  public int length() {
    return length;
  }

  /** Returns the bytes written, as a copy. */
  public byte[] toByteArray() {
    return Arrays.copyOf(buffer, length);
  }

  /** Writes a number of 8 bits. */
  public FieldWriter u8(int value) {
    if (length == buffer.length) {
      buffer = Arrays.copyOf(buffer, 2 * length);
    }
    buffer[length++] = (byte) value;
    return this;
  }

  /** Writes a number of 16 bits. */
  public FieldWriter u16(int value) {
    return u8(value >> 8).u8(value);
  }

  /** Writes a number of 32 bits, signed or not. */
  FieldWriter i32(int value) {
    return u16(value >> 16).u16(value);
  }

  FieldWriter u32(long value) {
    return i32((int) value);
  }

  FieldWriter bool(boolean value) {
    return u8(value ? 1 : 0);
  }

  /** Writes 64 bits as C3 Bridge does: two numbers of 32, the lower half first. */
  FieldWriter lowHigh(long value) {
    return i32((int) value).i32((int) (value >> 32));
  }

  /**
   * Writes a WSTRING: a count of characters, then UTF-16, little-endian
   * (docs/reference/c3-messages.md#strings).
   */
  FieldWriter wide(String value) {
    int count = value.length();
    u16(count);
    reserve(2 * count);
    for (int i = 0; i < count; i++) {
      char c = value.charAt(i);
      u8(c).u8(c >> 8);
    }
    return this;
  }

  FieldWriter bytes(Bytes value) {
    reserve(value.size());
    value.copyTo(buffer, length);
    length += value.size();
    return this;
  }

  private void reserve(int count) {
    if (buffer.length - length < count) {
      buffer = Arrays.copyOf(buffer, 2 * length + count);
    }
  }

  /**
   * Writes a STRING: a byte count, then ISO 8859-1, which the message's constructor has checked.
   */
  FieldWriter string(CharSequence value) {
    int count = value.length();
    u16(count);
    reserve(count);
    if (value instanceof KrlText text) {
      text.copyTo(buffer, length);
    } else {
      copy(value.toString(), buffer, length);
    }
    length += count;
    return this;
  }

  @SuppressWarnings("deprecation") // copies the lower bytes, which is ISO 8859-1
  private static void copy(String text, byte[] target, int offset) {
    text.getBytes(0, text.length(), target, offset);
  }

  /** Writes 16-bit numbers: a byte count, then the numbers. */
  FieldWriter words(List<Integer> values) {
    u16(values.size() * 2);
    for (int value : values) {
      u16(value);
    }
    return this;
  }
}
