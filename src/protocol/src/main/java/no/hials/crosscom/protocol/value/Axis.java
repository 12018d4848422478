package no.hials.crosscom.protocol.value;

import java.util.Objects;

/**
 * The positions of six robot axes, like KRL's type AXIS, or the differences of two positions.
 *
 * @param a1 axis 1, degrees
 * @param a2 axis 2, degrees
 * @param a3 axis 3, degrees
 * @param a4 axis 4, degrees
 * @param a5 axis 5, degrees
 * @param a6 axis 6, degrees
 */
public record Axis(double a1, double a2, double a3, double a4, double a5, double a6) {
  /** All axes at 0. */
  public static final Axis ZERO = new Axis(0, 0, 0, 0, 0, 0);

  /** The number of axes. */
  public static final int COUNT = 6;

  /** Checks that the numbers are finite; -0 becomes 0. */
  public Axis {
    a1 = Fields.finite("A1", a1);
    a2 = Fields.finite("A2", a2);
    a3 = Fields.finite("A3", a3);
    a4 = Fields.finite("A4", a4);
    a5 = Fields.finite("A5", a5);
    a6 = Fields.finite("A6", a6);
  }

  /**
   * Creates the positions from an array.
   *
   * @param six A1 to A6, degrees
   */
  public static Axis of(double... six) {
    if (six.length != COUNT) {
      throw new IllegalArgumentException("a robot has six axes, found " + six.length);
    }
    return new Axis(six[0], six[1], six[2], six[3], six[4], six[5]);
  }

  /**
   * Returns the position of an axis.
   *
   * @param index 0 for A1 to 5 for A6
   * @return the angle, degrees
   */
  public double get(int index) {
    return switch (Objects.checkIndex(index, COUNT)) {
      case 0 -> a1;
      case 1 -> a2;
      case 2 -> a3;
      case 3 -> a4;
      case 4 -> a5;
      default -> a6;
    };
  }

  /**
   * Returns the positions as a new array.
   *
   * @return A1 to A6, degrees
   */
  public double[] toArray() {
    return new double[] {a1, a2, a3, a4, a5, a6};
  }

  /** Returns the sum, axis by axis. */
  public Axis plus(Axis other) {
    return new Axis(
        a1 + other.a1, a2 + other.a2, a3 + other.a3, a4 + other.a4, a5 + other.a5, a6 + other.a6);
  }

  /** Returns the difference, axis by axis. */
  public Axis minus(Axis other) {
    return new Axis(
        a1 - other.a1, a2 - other.a2, a3 - other.a3, a4 - other.a4, a5 - other.a5, a6 - other.a6);
  }

  /**
   * Returns a copy with another position of an axis.
   *
   * @param index 0 for A1 to 5 for A6
   * @param value the angle of this axis, degrees
   */
  public Axis with(int index, double value) {
    double[] six = toArray();
    six[Objects.checkIndex(index, COUNT)] = value;
    return of(six);
  }

  /**
   * Returns the largest difference of an axis.
   *
   * @param other the other positions
   * @return the absolute difference, degrees
   */
  public double largestDifference(Axis other) {
    double largest = 0;
    for (double difference : minus(other).toArray()) {
      largest = Math.max(largest, Math.abs(difference));
    }
    return largest;
  }
}
