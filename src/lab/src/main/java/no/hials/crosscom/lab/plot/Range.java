package no.hials.crosscom.lab.plot;

/** An interval of numbers. */
record Range(double min, double max) {
  static final Range EMPTY = new Range(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);

  boolean isEmpty() {
    return min > max;
  }

  double span() {
    return max - min;
  }

  Range with(double value) {
    return new Range(Math.min(min, value), Math.max(max, value));
  }

  Range with(Range other) {
    return new Range(Math.min(min, other.min), Math.max(max, other.max));
  }

  /** Returns a range with the same centre. */
  Range ofSpan(double span) {
    double centre = min + span() / 2;
    return new Range(centre - span / 2, centre + span / 2);
  }

  /** Returns this range with a minimum of at least zero. */
  Range fromZero() {
    return min < 0 ? new Range(0, max) : this;
  }

  /**
   * Returns the range of an axis: this range with a margin at both ends, and never a single point.
   *
   * @param part the margin at each end, as a fraction of the span
   */
  Range padded(double part) {
    if (isEmpty()) {
      return new Range(0, 1);
    }
    // rounding errors of a constant must not fill the height
    double smallest = Math.max(Math.max(Math.abs(min), Math.abs(max)) * 1e-6, 1e-9);
    if (span() < smallest) {
      double largest = Math.max(Math.abs(min), Math.abs(max));
      double room = largest == 0 ? 1 : largest / 2;
      return new Range(min - room, max + room);
    }
    return ofSpan(span() * (1 + 2 * part));
  }
}
