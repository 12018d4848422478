package no.hials.crosscom.protocol.file;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.Objects;

/** Bytes that do not change: a part of a file. */
public final class Bytes {
  /** How many bytes {@link #toString} shows. */
  private static final int SHOWN = 16;

  private final byte[] bytes;

  private Bytes(byte[] bytes) {
    this.bytes = bytes;
  }

  /**
   * Copies bytes.
   *
   * @param bytes any
   * @return the copy
   */
  public static Bytes of(byte[] bytes) {
    return new Bytes(bytes.clone());
  }

  /**
   * Copies some of the bytes of an array.
   *
   * @param bytes any
   * @param offset where they begin
   * @param count how many they are
   * @return the copy
   * @throws IndexOutOfBoundsException if the array has not as many
   */
  public static Bytes of(byte[] bytes, int offset, int count) {
    Objects.checkFromIndexSize(offset, count, bytes.length);
    return new Bytes(Arrays.copyOfRange(bytes, offset, offset + count));
  }

  /**
   * Counts the bytes.
   *
   * @return 0 or more
   */
  public int size() {
    return bytes.length;
  }

  /**
   * Copies the bytes into an array.
   *
   * @param target where to
   * @param offset where in it they begin
   * @throws IndexOutOfBoundsException if there is not enough room
   */
  public void copyTo(byte[] target, int offset) {
    System.arraycopy(bytes, 0, target, offset, bytes.length);
  }

  /**
   * Gives the bytes.
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

  /** Prints how many bytes there are, and the first of them in hex. */
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
