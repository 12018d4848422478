package no.hials.crosscom.protocol.value;

import org.jspecify.annotations.Nullable;

/**
 * A KRL INT.
 *
 * @param value the number, 32 bits with sign; {@code 'B..'} and {@code 'H..'} literals of 32 digits
 *     or 8 digits may set the sign bit
 */
public record KrlInt(int value) implements KrlValue {
  @Override
  public int asInt() {
    return value;
  }

  @Override
  public double asDouble() {
    return value;
  }

  @Override
  public <R extends @Nullable Object> R accept(KrlVisitor<R> visitor) {
    return visitor.visit(this);
  }

  @Override
  public String toString() {
    return print();
  }
}
