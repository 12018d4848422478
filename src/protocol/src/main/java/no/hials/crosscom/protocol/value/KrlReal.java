package no.hials.crosscom.protocol.value;

import org.jspecify.annotations.Nullable;

/**
 * A KRL REAL, which is an IEEE 754 32-bit float on the controller.
 *
 * @param value the number; finite; -0 becomes 0, so that equal numbers are equal objects
 *     (docs/reference/krl-values.md#negative-zero)
 */
public record KrlReal(float value) implements KrlValue {

  /** Checks that the number is finite. */
  public KrlReal {
    if (!Float.isFinite(value)) {
      throw new IllegalArgumentException("a REAL must be finite, is " + value);
    }
    if (value == 0) {
      value = 0.0f;
    }
  }

  /**
   * Rounds a double to the nearest REAL.
   *
   * @param value a number that a 32-bit float can hold
   * @return the REAL
   * @throws IllegalArgumentException if the number is NaN, infinite or beyond ±3.4028235E38
   */
  public static KrlReal of(double value) {
    return new KrlReal(toFloat(value));
  }

  /**
   * Rounds a double to the nearest 32-bit float, without creating an object.
   *
   * @param value a number that a 32-bit float can hold
   * @return the float
   * @throws IllegalArgumentException if the number is NaN, infinite or beyond ±3.4028235E38
   */
  public static float toFloat(double value) {
    float f = (float) value;
    if (!Float.isFinite(f)) {
      throw new IllegalArgumentException(
          "a REAL is a 32-bit float, within ±3.4028235E38 and not NaN, is " + value);
    }
    return f;
  }

  @Override
  public double asDouble() {
    return Double.parseDouble(print());
  }

  @Override
  public <R extends @Nullable Object> R accept(KrlVisitor<R> visitor) {
    return visitor.visit(this);
  }

  @Override
  public String toString() {
    return print();
  }
}
