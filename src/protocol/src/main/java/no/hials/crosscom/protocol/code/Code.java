package no.hials.crosscom.protocol.code;

import java.util.Optional;

/**
 * A code on the wire, known or not.
 *
 * @param type the enum of the known ones; not on the wire
 * @param number the code; how many bytes it has and so its range are the message's
 * @param <E> the enum
 */
public record Code<E extends Enum<E> & WireCode>(Class<E> type, int number) {

  /**
   * Makes a known code.
   *
   * @param constant what it is to be
   * @param <E> the enum
   * @return the code
   */
  public static <E extends Enum<E> & WireCode> Code<E> of(E constant) {
    return new Code<>(constant.getDeclaringClass(), constant.code());
  }

  /**
   * Gives the constant that has this number.
   *
   * @return the constant, or nothing if the number is unknown
   */
  public Optional<E> known() {
    return WireCode.find(type, number);
  }

  /**
   * Compares with a constant.
   *
   * @param constant any
   * @return true if it has this number
   */
  public boolean is(E constant) {
    return constant.code() == number;
  }

  /** Names the constant, or gives the number of an unknown one. */
  @Override
  public String toString() {
    return known().map(E::name).orElseGet(() -> String.valueOf(number));
  }
}
