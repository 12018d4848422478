package no.hials.crosscom.protocol;

import java.util.List;

/** The checks of the messages' constructors. */
final class Ranges {
  static final int MAX_U16 = 0xFFFF;

  private Ranges() {}

  static void u8(String field, int value) {
    check(field, value, 0xFF);
  }

  static void u16(String field, int value) {
    check(field, value, MAX_U16);
  }

  private static void check(String field, int value, int max) {
    if (value < 0 || value > max) {
      throw new IllegalArgumentException(field + " must be 0 to " + max + ", is " + value);
    }
  }

  /** Checks that a text can be sent as a STRING at all. */
  static void latin1(String field, String value) {
    for (int i = 0; i < value.length(); i++) {
      if (value.charAt(i) > 0xFF) {
        throw new IllegalArgumentException(
            field
                + " must be ISO 8859-1, has U+"
                + String.format("%04X", (int) value.charAt(i))
                + " at index "
                + i
                + ": "
                + value);
      }
    }
  }

  static void words(String field, List<Integer> values) {
    for (int value : values) {
      u16(field, value);
    }
  }

  /** Checks that the bytes behind the length field can be counted by it. */
  static void frame(String field, int length) {
    if (length > MAX_U16) {
      throw new IllegalArgumentException(
          field + " makes a frame of " + length + " bytes, a frame has " + MAX_U16 + " at most");
    }
  }
}
