package no.hials.crosscom.simulator.internal.path;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;

/**
 * The relation of a curve's parameter to its length, both from 0 to 1: smooth, and exact at evenly
 * distributed parameters.
 */
public final class ArcLength {
  /** The number of intervals. Assumed. */
  public static final int INTERVALS = 32;

  private final double length;
  private final double[] parts = new double[INTERVALS + 1];

  /** The change of the parameter with the length, at the same points. */
  private final double[] slopes = new double[INTERVALS + 1];

  /**
   * Measures a curve.
   *
   * @param distance the distance of the points at {@code i / INTERVALS} and the next
   */
  public ArcLength(IntToDoubleFunction distance) {
    for (int i = 0; i < INTERVALS; i++) {
      parts[i + 1] = parts[i] + distance.applyAsDouble(i);
    }
    length = parts[INTERVALS];
    for (int i = 0; i <= INTERVALS; i++) {
      // without a length the parameter is the part
      parts[i] = length == 0 ? (double) i / INTERVALS : parts[i] / length;
    }
    for (int i = 0; i <= INTERVALS; i++) {
      slopes[i] = slope(i);
    }
  }

  private double slope(int i) {
    double rate;
    double least;
    if (i == 0) {
      rate = -3 * parts[0] + 4 * parts[1] - parts[2];
      least = parts[1] - parts[0];
    } else if (i == INTERVALS) {
      rate = 3 * parts[i] - 4 * parts[i - 1] + parts[i - 2];
      least = parts[i] - parts[i - 1];
    } else {
      rate = parts[i + 1] - parts[i - 1];
      least = Math.max(parts[i + 1] - parts[i], parts[i] - parts[i - 1]);
    }
    // less than 3 times the mean of an interval: so the parameter never goes back
    return 2.0 / INTERVALS / Math.max(rate, 2 * least / 3);
  }

  /** Returns the length of the curve. */
  public double length() {
    return length;
  }

  /** Returns the change of the parameter with the part of the length, at the start. */
  public double slopeAtStart() {
    return slopes[0];
  }

  /** Returns the change of the parameter with the part of the length, at the end. */
  public double slopeAtEnd() {
    return slopes[INTERVALS];
  }

  /**
   * Returns parts of the length that are close to each other where the curve bends: those of even
   * parameters.
   */
  public double[] evenParts() {
    return Arrays.copyOfRange(parts, 1, INTERVALS + 1);
  }

  /** Returns the parameter of a part of the length. */
  public double parameter(double part) {
    if (part <= 0) {
      return 0;
    }
    if (part >= 1) {
      return 1;
    }
    int found = Arrays.binarySearch(parts, part);
    int i = Math.min(INTERVALS - 1, found >= 0 ? found : -found - 2);
    double width = parts[i + 1] - parts[i];
    double t = (part - parts[i]) / width;
    double rest = 1 - t;
    double from = (double) i / INTERVALS;
    double to = (i + 1.0) / INTERVALS;
    return rest * rest * (1 + 2 * t) * from
        + t * t * (3 - 2 * t) * to
        + width * t * rest * (rest * slopes[i] - t * slopes[i + 1]);
  }
}
