package no.hials.crosscom.control;

import java.time.Duration;

/** Checks of constructor arguments. */
final class Checks {
  private Checks() {}

  static void finite(String field, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(field + " must be finite, is " + value);
    }
  }

  static void positive(String field, double value) {
    if (!(value > 0 && Double.isFinite(value))) {
      throw new IllegalArgumentException(field + " must be more than 0, is " + value);
    }
  }

  static double notNegative(String field, double value) {
    if (!(value >= 0 && Double.isFinite(value))) {
      throw new IllegalArgumentException(field + " must be 0 or more, is " + value);
    }
    return value;
  }

  static Duration between(String field, Duration value, Duration minimum, Duration maximum) {
    if (value.compareTo(minimum) < 0 || value.compareTo(maximum) > 0) {
      throw new IllegalArgumentException(
          field + " must be " + minimum + " to " + maximum + ", is " + value);
    }
    return value;
  }

  static void holds(boolean rule, String message) {
    if (!rule) {
      throw new IllegalArgumentException(message);
    }
  }
}
