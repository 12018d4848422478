package no.hials.crosscom.protocol.code;

import java.util.Optional;

/**
 * A code on the wire, known or unknown.
 *
 * @param type the enum of the known codes; not on the wire
 * @param number the code; the message determines its length in bytes and its range
 * @param <E> the enum
 */
public record Code<E extends Enum<E> & WireCode>(Class<E> type, int number) {

  /**
   * Returns the code of a constant.
   *
   * @param constant the constant
   * @param <E> the enum
   * @return the code
   */
  public static <E extends Enum<E> & WireCode> Code<E> of(E constant) {
    return new Code<>(constant.getDeclaringClass(), constant.code());
  }

  /**
   * Returns the constant with this number.
   *
   * @return the constant, or empty if the number is unknown
   */
  public Optional<E> known() {
    return WireCode.find(type, number);
  }

  /**
   * Returns whether this is the code of a constant.
   *
   * @param constant the constant
   * @return true if the constant has this number
   */
  public boolean is(E constant) {
    return constant.code() == number;
  }

  /** Returns the name of the constant, or the number of an unknown code. */
  @Override
  public String toString() {
    return known().map(E::name).orElseGet(() -> String.valueOf(number));
  }
}
