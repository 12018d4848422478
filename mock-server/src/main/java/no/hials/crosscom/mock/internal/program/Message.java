package no.hials.crosscom.mock.internal.program;

import no.hials.crosscom.lang.Position;

/**
 * A message for the operator.
 *
 * @param kind its kind
 * @param number its number
 * @param text its text
 * @param position where the program stands
 */
public record Message(Kind kind, int number, String text, Position position) {

  /** The kinds of messages. */
  public enum Kind {
    /** Says something and asks for nothing. */
    NOTIFICATION,
    /** Tells a state for as long as it lasts. */
    STATUS,
    /** Has stopped the program, and wants to be acknowledged. */
    ACKNOWLEDGEMENT
  }
}
