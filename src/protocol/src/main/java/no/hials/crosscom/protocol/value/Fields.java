package no.hials.crosscom.protocol.value;

/** Checks of the fields of positions. */
final class Fields {

  private Fields() {}

  static void finite(String field, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(field + " must be finite, is " + value);
    }
  }
}
