package no.hials.crosscom.protocol.value;

/** Checks of the fields of positions. */
final class Fields {

  private Fields() {}

  /** Returns the value, and 0 for -0 (docs/reference/krl-values.md#negative-zero). */
  static double finite(String field, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(field + " must be finite, is " + value);
    }
    return value + 0.0;
  }
}
