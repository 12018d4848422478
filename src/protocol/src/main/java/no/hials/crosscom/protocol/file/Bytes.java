package no.hials.crosscom.protocol.file;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.Objects;

/** An immutable sequence of bytes, such as a part of a file. */
public final class Bytes {
  /** The number of bytes that {@link #toString} shows. */
  private static final int SHOWN = 16;

  private final byte[] bytes;

  private Bytes(byte[] bytes) {
    this.bytes = bytes;
  }

  /**
   * Returns a copy of an array.
   *
   * @param bytes the array
   * @return the copy
   */
  public static Bytes of(byte[] bytes) {
    return new Bytes(bytes.clone());
  }

  /**
   * Returns a copy of a part of an array.
   *
   * @param bytes the array
   * @param offset the index of the first byte
   * @param count the number of bytes
   * @return the copy
   * @throws IndexOutOfBoundsException if the array has fewer bytes
   */
  public static Bytes of(byte[] bytes, int offset, int count) {
    Objects.checkFromIndexSize(offset, count, bytes.length);
    return new Bytes(Arrays.copyOfRange(bytes, offset, offset + count));
  }

  /**
   * Returns the number of bytes.
   *
   * @return 0 or more
   */
  public int size() {
    return bytes.length;
  }

  /**
   * Copies the bytes into an array.
   *
   * @param target the array
   * @param offset the index of the first byte in it
   * @throws IndexOutOfBoundsException if the array is too short
   */
  public void copyTo(byte[] target, int offset) {
    System.arraycopy(bytes, 0, target, offset, bytes.length);
  }

  /**
   * Returns the bytes.
   *
   * @return a copy
   */
  public byte[] toByteArray() {
    return bytes.clone();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Bytes that && Arrays.equals(bytes, that.bytes);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(bytes);
  }

  /** Returns the number of bytes, and the first of them in hex. */
  @Override
  public String toString() {
    int shown = Math.min(SHOWN, bytes.length);
    return bytes.length
        + " bytes ["
        + HexFormat.of().formatHex(bytes, 0, shown)
        + (shown < bytes.length ? "..." : "")
        + "]";
  }
}
