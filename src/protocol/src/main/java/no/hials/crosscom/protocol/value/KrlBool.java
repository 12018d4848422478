package no.hials.crosscom.protocol.value;

/**
 * A KRL BOOL.
 *
 * @param value {@code TRUE} or {@code FALSE}
 */
public record KrlBool(boolean value) implements KrlValue {
  @Override
  public String toString() {
    return print();
  }
}
