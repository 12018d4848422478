package no.hials.crosscom.mock.internal;

import java.time.Duration;

/** Checks arguments of constructors. */
public final class Checks {
  private static final Duration HOUR = Duration.ofHours(1);

  private Checks() {}

  /** Checks that a number is not negative. */
  public static void notNegative(String field, int value) {
    if (value < 0) {
      throw new IllegalArgumentException(field + " must not be negative, is " + value);
    }
  }

  /** Checks that a time is not negative. */
  public static void notNegative(String field, Duration value) {
    if (value.isNegative()) {
      throw new IllegalArgumentException(field + " must not be negative, is " + value);
    }
  }

  /** Checks that a time is zero to an hour. */
  public static void upToAnHour(String field, Duration value) {
    if (value.isNegative() || value.compareTo(HOUR) > 0) {
      throw new IllegalArgumentException(field + " must be zero to an hour, is " + value);
    }
  }
}
