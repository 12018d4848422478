package no.hials.crosscom.mock;

import java.util.Arrays;

/**
 * What stands behind a name: nothing, {@code []}, {@code [1]}, {@code [1,2]} or {@code [1,]}.
 * Immutable.
 */
final class Index {
  /** No brackets. */
  static final Index NONE = new Index(new int[0], false);

  /** {@code []}. */
  static final Index WHOLE = new Index(new int[0], true);

  private final int[] numbers;
  private final boolean open;

  /**
   * @param numbers the indices, from 1
   * @param open whether the last dimension is left open, as in {@code []} and {@code [1,]}
   */
  Index(int[] numbers, boolean open) {
    this.numbers = numbers;
    this.open = open;
  }

  int count() {
    return numbers.length;
  }

  int number(int dimension) {
    return numbers[dimension];
  }

  boolean isNone() {
    return numbers.length == 0 && !open;
  }

  boolean isWhole() {
    return numbers.length == 0 && open;
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
