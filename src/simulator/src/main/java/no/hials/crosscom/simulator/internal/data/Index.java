package no.hials.crosscom.simulator.internal.data;

import java.util.Arrays;

/**
 * The index after a name: no brackets, {@code []}, {@code [1]}, {@code [1,2]} or {@code [1,]}.
 * Immutable.
 */
public final class Index {
  /** No brackets. */
  public static final Index NONE = new Index(new int[0], false);

  /** {@code []}. */
  public static final Index WHOLE = new Index(new int[0], true);

  private final int[] numbers;
  private final boolean open;

  /**
   * Creates an index.
   *
   * @param numbers the indices, from 1
   * @param open whether the last dimension is open, as in {@code []} and {@code [1,]}
   */
  public Index(int[] numbers, boolean open) {
    this.numbers = numbers.clone();
    this.open = open;
  }

  /** Returns the number of indices. */
  public int count() {
    return numbers.length;
  }

  /** Returns an index, from 1, by its dimension, from 0. */
  public int number(int dimension) {
    return numbers[dimension];
  }

  /** Returns whether the name has no brackets. */
  public boolean isNone() {
    return numbers.length == 0 && !open;
  }

  /** Returns whether it is {@code []}. */
  public boolean isWhole() {
    return numbers.length == 0 && open;
  }

  /** Returns whether the last dimension is open: {@code []} or {@code [1,]}. */
  public boolean isOpen() {
    return open;
  }

  /**
   * Returns the index of a part of the part at this index: {@code [1,]} and {@code [2]} are {@code
   * [1,2]}.
   */
  public Index then(Index inner) {
    if (inner.isNone()) {
      return this;
    }
    int[] all = Arrays.copyOf(numbers, numbers.length + inner.numbers.length);
    System.arraycopy(inner.numbers, 0, all, numbers.length, inner.numbers.length);
    return new Index(all, inner.open);
  }

  /** Returns the rest of the index after its first dimensions. */
  Index after(int dimensions) {
    return new Index(Arrays.copyOfRange(numbers, dimensions, numbers.length), open);
  }

  @Override
  public String toString() {
    if (isNone()) {
      return "";
    }
    StringBuilder out = new StringBuilder("[");
    for (int i = 0; i < numbers.length; i++) {
      out.append(i > 0 ? "," : "").append(numbers[i]);
    }
    return out.append(open && numbers.length > 0 ? ",]" : "]").toString();
  }
}
