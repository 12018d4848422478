package no.hials.crosscom.cell.feed;

/**
 * The numbers from a lowest to a highest one.
 *
 * @param low the lowest, less than {@code high}
 * @param high the highest
 */
public record Range(double low, double high) {
  /** Checks the order. */
  public Range {
    if (!(low < high) || Double.isInfinite(low) || Double.isInfinite(high)) {
      throw new IllegalArgumentException(
          "must be two numbers, the lower one first, is [" + low + ", " + high + "]");
    }
  }

  /** Returns whether a number is in the range; false for NaN. */
  public boolean contains(double number) {
    return number >= low && number <= high;
  }

  @Override
  public String toString() {
    return low + " to " + high;
  }
}
