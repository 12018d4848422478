package no.hials.crosscom.protocol.code;

import java.util.Optional;

/** A constant that is a number on the wire. */
public interface WireCode {

  /**
   * Gives the number on the wire.
   *
   * @return the code, or the bits of a flag
   */
  int code();

  /**
   * Finds a constant by its number.
   *
   * @param type the enum
   * @param code any number
   * @param <E> the enum
   * @return the constant, or nothing if the number is unknown
   */
  static <E extends Enum<E> & WireCode> Optional<E> find(Class<E> type, int code) {
    for (E constant : type.getEnumConstants()) {
      if (constant.code() == code) {
        return Optional.of(constant);
      }
    }
    return Optional.empty();
  }
}
