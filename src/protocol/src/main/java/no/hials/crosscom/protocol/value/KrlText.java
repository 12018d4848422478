package no.hials.crosscom.protocol.value;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * A text of ASCII characters that is printed as bytes and reused, so that printing numbers creates
 * no objects. Not thread-safe.
 */
public final class KrlText implements CharSequence {
  private byte[] bytes = new byte[32];
  private int length;

  /** Creates an empty text. */
  public KrlText() {}

  /**
   * Removes all characters, and keeps the memory.
   *
   * @return this
   */
  public KrlText clear() {
    length = 0;
    return this;
  }

  /** Opens an aggregate without a type name, as in a data list. */
  public void openStruct() {
    append('{');
  }

  /**
   * Appends the name of the next field of an aggregate; the caller appends the value.
   *
   * @param name the field's name
   */
  public void nextField(String name) {
    if (bytes[length - 1] != '{') {
      append(',');
    }
    append(name);
    append(' ');
  }

  /** Closes an aggregate. */
  public void closeStruct() {
    append('}');
  }

  /**
   * Appends a REAL with the fewest digits that identify it.
   *
   * @param value the number; finite
   */
  public void append(float value) {
    RealText.append(this, value, RealStyle.SHORTEST);
  }

  /**
   * Appends an INT.
   *
   * @param value the number
   */
  public void append(int value) {
    if (value < 0) {
      append('-');
    }
    appendDigits(Math.abs((long) value), 1);
  }

  /**
   * Appends a text.
   *
   * @param text only ASCII
   */
  @SuppressWarnings("deprecation") // copies the lower bytes, which is ASCII
  public void append(String text) {
    int count = text.length();
    reserve(count);
    text.getBytes(0, count, bytes, length);
    length += count;
  }

  void append(char c) {
    reserve(1);
    bytes[length++] = (byte) c;
  }

  /** Appends a number that is not negative, with zeros before it up to a number of digits. */
  void appendDigits(long number, int least) {
    int count = least;
    while (number >= RealText.POWERS[count]) {
      count++;
    }
    reserve(count);
    int at = length + count;
    long rest = number;
    do {
      bytes[--at] = (byte) ('0' + rest % 10);
      rest /= 10;
    } while (rest != 0);
    while (at > length) {
      bytes[--at] = '0';
    }
    length += count;
  }

  private void reserve(int count) {
    if (bytes.length - length < count) {
      bytes = Arrays.copyOf(bytes, 2 * bytes.length + count);
    }
  }

  /**
   * Copies all characters.
   *
   * @param target the destination
   * @param offset the index of the first byte
   */
  public void copyTo(byte[] target, int offset) {
    System.arraycopy(bytes, 0, target, offset, length);
  }

  @Override
  public int length() {
    return length;
  }

  @Override
  public char charAt(int index) {
    return (char) bytes[index];
  }

  @Override
  public CharSequence subSequence(int start, int end) {
    return toString().substring(start, end);
  }

  @Override
  public String toString() {
    return new String(bytes, 0, length, StandardCharsets.US_ASCII);
  }
}
