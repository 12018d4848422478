package no.hials.crosscom.protocol.code;

import java.util.Optional;

/** A constant with a number on the wire. */
public interface WireCode {

  /**
   * Returns the number on the wire.
   *
   * @return the code, or the bits of a flag
   */
  int code();

  /**
   * Returns the constant with a number.
   *
   * @param type the enum
   * @param code any number
   * @param <E> the enum
   * @return the constant, or empty if the number is unknown
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
