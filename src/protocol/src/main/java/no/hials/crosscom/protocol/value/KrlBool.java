package no.hials.crosscom.protocol.value;

import org.jspecify.annotations.Nullable;

/**
 * A KRL BOOL.
 *
 * @param value {@code TRUE} or {@code FALSE}
 */
public record KrlBool(boolean value) implements KrlValue {
  @Override
  public boolean asBool() {
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
