package no.hials.crosscom.simulator.internal.data;

import java.util.Arrays;

/**
 * What stands behind a name: nothing, {@code []}, {@code [1]}, {@code [1,2]} or {@code [1,]}.
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
   * Makes an index.
   *
   * @param numbers the indices, from 1
   * @param open whether the last dimension is left open, as in {@code []} and {@code [1,]}
   */
  public Index(int[] numbers, boolean open) {
    this.numbers = numbers.clone();
    this.open = open;
  }

  /**
   * Counts the indices.
   *
   * @return how many there are
   */
  public int count() {
    return numbers.length;
  }

  /**
   * Gives one index.
   *
   * @param dimension which, from 0
   * @return the index, from 1
   */
  public int number(int dimension) {
    return numbers[dimension];
  }

  /**
   * Says whether there are no brackets.
   *
   * @return whether the name stands alone
   */
  public boolean isNone() {
    return numbers.length == 0 && !open;
  }

  /**
   * Says whether the brackets are empty.
   *
   * @return whether it is {@code []}
   */
  public boolean isWhole() {
    return numbers.length == 0 && open;
  }

  /**
   * Says whether the last dimension is left open.
   *
   * @return whether it is {@code []} or {@code [1,]}
   */
  public boolean isOpen() {
    return open;
  }

  /**
   * Gives the index that stands for a part of what this one stands for: {@code [1,]} and then
   * {@code [2]} is {@code [1,2]}.
   *
   * @param inner the index within that part
   * @return both together
   */
  public Index then(Index inner) {
    if (inner.isNone()) {
      return this;
    }
    int[] all = Arrays.copyOf(numbers, numbers.length + inner.numbers.length);
    System.arraycopy(inner.numbers, 0, all, numbers.length, inner.numbers.length);
    return new Index(all, inner.open);
  }

  /** Gives what is left of the index when the first dimensions are dealt with. */
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
