package no.hials.crosscom.protocol.internal;

import java.util.Collection;
import java.util.List;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.value.KrlText;

/** The checks of the messages' constructors. */
public final class Ranges {
  /** The largest number of 16 bits. */
  public static final int MAX_U16 = 0xFFFF;

  private static final long MAX_U32 = 0xFFFF_FFFFL;

  private Ranges() {}

  /** Checks a number of 8 bits. */
  public static void u8(String field, int value) {
    check(field, value, 0, 0xFF);
  }

  /** Checks a number of 16 bits. */
  public static void u16(String field, int value) {
    check(field, value, 0, MAX_U16);
  }

  /** Checks a signed number of 16 bits. */
  public static void i16(String field, int value) {
    check(field, value, Short.MIN_VALUE, Short.MAX_VALUE);
  }

  /** Checks a number of 32 bits. */
  public static void u32(String field, long value) {
    check(field, value, 0, MAX_U32);
  }

  private static void check(String field, long value, long min, long max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(
          field + " must be " + min + " to " + max + ", is " + value);
    }
  }

  /** Checks that a text can be sent as a STRING. */
  public static void latin1(String field, CharSequence value) {
    if (value instanceof KrlText) {
      return; // always ASCII
    }
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

  /** Checks the name and the value of a write request. */
  public static void assignment(CharSequence name, CharSequence value) {
    latin1("name", name);
    latin1("value", value);
    frame("name and value", 1 + 2 + name.length() + 2 + value.length());
  }

  /** Checks numbers of 16 bits. */
  public static void words(String field, List<Integer> values) {
    for (int value : values) {
      u16(field, value);
    }
  }

  /** Checks the number of items. */
  public static void count(String field, Collection<?> items, int max) {
    if (items.size() > max) {
      throw new IllegalArgumentException(
          field + " must be " + max + " at most, are " + items.size());
    }
  }

  /** Checks the type of a message that serves several types. */
  public static void type(MessageType type, MessageType... allowed) {
    List<MessageType> types = List.of(allowed);
    if (!types.contains(type)) {
      throw new IllegalArgumentException("type must be one of " + types + ", is " + type);
    }
  }

  /** Returns the length of a WSTRING in bytes. */
  public static long wide(String value) {
    return 2 + 2L * value.length();
  }

  /** Returns the length of several WSTRINGs in bytes. */
  public static long wide(Collection<String> values) {
    return values.stream().mapToLong(Ranges::wide).sum();
  }

  /** Checks that the length field of a frame can count the bytes after it. */
  public static void frame(String field, long length) {
    if (length > MAX_U16) {
      throw new IllegalArgumentException(
          field + " needs a frame of " + length + " bytes, a frame has " + MAX_U16 + " at most");
    }
  }
}
