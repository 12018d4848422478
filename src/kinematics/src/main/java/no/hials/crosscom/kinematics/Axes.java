package no.hials.crosscom.kinematics;

import java.util.Objects;

/**
 * Says how far the six axes of a robot are turned, as KRL's type AXIS, or by how much they turn.
 *
 * @param a1 axis 1, degrees
 * @param a2 axis 2, degrees
 * @param a3 axis 3, degrees
 * @param a4 axis 4, degrees
 * @param a5 axis 5, degrees
 * @param a6 axis 6, degrees
 */
public record Axes(double a1, double a2, double a3, double a4, double a5, double a6) {
  /** Has all the axes at 0. */
  public static final Axes ZERO = new Axes(0, 0, 0, 0, 0, 0);

  /** The number of axes. */
  static final int COUNT = 6;

  /** Refuses a number that is not finite. */
  public Axes {
    Numbers.finite("A1", a1);
    Numbers.finite("A2", a2);
    Numbers.finite("A3", a3);
    Numbers.finite("A4", a4);
    Numbers.finite("A5", a5);
    Numbers.finite("A6", a6);
  }

  /**
   * Makes a value of six numbers.
   *
   * @param six A1 to A6, degrees
   * @return the value
   */
  public static Axes of(double... six) {
    if (six.length != COUNT) {
      throw new IllegalArgumentException("a robot has six axes, found " + six.length);
    }
    return new Axes(six[0], six[1], six[2], six[3], six[4], six[5]);
  }

  /**
   * Returns one axis.
   *
   * @param index 0 for A1 to 5 for A6
   * @return its angle, degrees
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
   * Returns the axes as an array of their own.
   *
   * @return A1 to A6, degrees
   */
  public double[] toArray() {
    return new double[] {a1, a2, a3, a4, a5, a6};
  }

  /**
   * Adds axis by axis.
   *
   * @param other what is added, degrees
   * @return the sum
   */
  public Axes plus(Axes other) {
    return new Axes(
        a1 + other.a1, a2 + other.a2, a3 + other.a3, a4 + other.a4, a5 + other.a5, a6 + other.a6);
  }

  /**
   * Subtracts axis by axis.
   *
   * @param other what is subtracted, degrees
   * @return the difference
   */
  public Axes minus(Axes other) {
    return new Axes(
        a1 - other.a1, a2 - other.a2, a3 - other.a3, a4 - other.a4, a5 - other.a5, a6 - other.a6);
  }

  /**
   * Sets one axis and keeps the others.
   *
   * @param index 0 for A1 to 5 for A6
   * @param value the angle of this axis, degrees
   * @return the changed value
   */
  public Axes with(int index, double value) {
    double[] six = toArray();
    six[Objects.checkIndex(index, COUNT)] = value;
    return of(six);
  }

  /**
   * Measures how far apart two values are where they differ most.
   *
   * @param other the other value
   * @return the largest difference of one axis, 0 or more, degrees
   */
  public double largestDifference(Axes other) {
    double largest = 0;
    for (double difference : minus(other).toArray()) {
      largest = Math.max(largest, Math.abs(difference));
    }
    return largest;
  }
}
