package no.hials.crosscom.protocol;

import java.util.Collection;
import java.util.List;

/** The checks of the messages' constructors. */
final class Ranges {
  static final int MAX_U16 = 0xFFFF;

  private static final long MAX_U32 = 0xFFFF_FFFFL;

  private Ranges() {}

  static void u8(String field, int value) {
    check(field, value, 0, 0xFF);
  }

  static void u16(String field, int value) {
    check(field, value, 0, MAX_U16);
  }

  static void i16(String field, int value) {
    check(field, value, Short.MIN_VALUE, Short.MAX_VALUE);
  }

  static void u32(String field, long value) {
    check(field, value, 0, MAX_U32);
  }

  private static void check(String field, long value, long min, long max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(
          field + " must be " + min + " to " + max + ", is " + value);
    }
  }

  /** Checks that a text can be sent as a STRING at all. */
  static void latin1(String field, CharSequence value) {
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

  /** Checks how many items there are. */
  static void count(String field, Collection<?> items, int max) {
    if (items.size() > max) {
      throw new IllegalArgumentException(
          field + " must be " + max + " at most, are " + items.size());
    }
  }

  /** Checks the type of a message that several types have in common. */
  static void type(MessageType type, MessageType... allowed) {
    List<MessageType> types = List.of(allowed);
    if (!types.contains(type)) {
      throw new IllegalArgumentException("type must be one of " + types + ", is " + type);
    }
  }

  /** Gives the bytes of a WSTRING. */
  static long wide(String value) {
    return 2 + 2L * value.length();
  }

  /** Gives the bytes of several WSTRINGs. */
  static long wide(Collection<String> values) {
    return values.stream().mapToLong(Ranges::wide).sum();
  }

  /** Checks that the bytes behind the length field can be counted by it. */
  static void frame(String field, long length) {
    if (length > MAX_U16) {
      throw new IllegalArgumentException(
          field + " makes a frame of " + length + " bytes, a frame has " + MAX_U16 + " at most");
    }
  }
}
