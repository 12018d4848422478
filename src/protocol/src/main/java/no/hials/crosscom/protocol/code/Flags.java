package no.hials.crosscom.protocol.code;

import java.util.Collection;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import java.util.StringJoiner;

/**
 * Flags on the wire, known or unknown.
 *
 * @param type the enum of the known flags; not on the wire
 * @param bits all bits; the message determines their length in bytes and their range
 * @param <E> the enum
 */
public record Flags<E extends Enum<E> & WireCode>(Class<E> type, int bits) {

  /**
   * Returns flags without any bit set.
   *
   * @param type the enum
   * @param <E> the enum
   * @return the flags
   */
  public static <E extends Enum<E> & WireCode> Flags<E> none(Class<E> type) {
    return new Flags<>(type, 0);
  }

  /**
   * Returns flags with all known flags set.
   *
   * @param type the enum
   * @param <E> the enum
   * @return the flags
   */
  public static <E extends Enum<E> & WireCode> Flags<E> all(Class<E> type) {
    return of(type, EnumSet.allOf(type));
  }

  /**
   * Returns flags with some flags set.
   *
   * @param type the enum
   * @param constants the flags to set
   * @param <E> the enum
   * @return the flags
   */
  public static <E extends Enum<E> & WireCode> Flags<E> of(Class<E> type, Collection<E> constants) {
    int bits = 0;
    for (E constant : constants) {
      bits |= constant.code();
    }
    return new Flags<>(type, bits);
  }

  /**
   * Returns flags with some flags set.
   *
   * @param first a flag to set
   * @param others more flags to set
   * @param <E> the enum
   * @return the flags
   */
  @SafeVarargs
  public static <E extends Enum<E> & WireCode> Flags<E> of(E first, E... others) {
    int bits = first.code();
    for (E other : others) {
      bits |= other.code();
    }
    return new Flags<>(first.getDeclaringClass(), bits);
  }

  /**
   * Returns whether all bits of a flag are set.
   *
   * @param flag the flag; a constant without bits is never set
   * @return true if so
   */
  public boolean has(E flag) {
    return flag.code() != 0 && (bits & flag.code()) == flag.code();
  }

  /**
   * Returns the known flags that are set. If one flag includes the bits of another, as 48 includes
   * 16, only the flag with more bits is returned.
   *
   * @return the constants, unmodifiable
   */
  public Set<E> known() {
    EnumSet<E> known = EnumSet.noneOf(type);
    for (E flag : type.getEnumConstants()) {
      if (has(flag)) {
        known.add(flag);
      }
    }
    EnumSet<E> parts = EnumSet.noneOf(type);
    for (E flag : known) {
      for (E other : known) {
        if (flag != other && (flag.code() & other.code()) == flag.code()) {
          parts.add(flag);
        }
      }
    }
    known.removeAll(parts);
    return Collections.unmodifiableSet(known);
  }

  /**
   * Returns the bits that belong to no known flag.
   *
   * @return the bits, 0 if there are none
   */
  public int unknown() {
    int rest = bits;
    for (E flag : known()) {
      rest &= ~flag.code();
    }
    return rest;
  }

  /** Returns the names of the known flags, and the unknown bits in hex. */
  @Override
  public String toString() {
    StringJoiner text = new StringJoiner(", ", "[", "]");
    known().forEach(flag -> text.add(flag.name()));
    if (unknown() != 0) {
      text.add("0x" + Integer.toHexString(unknown()));
    }
    return text.toString();
  }
}
