package no.hials.crosscom.protocol.value;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A value of a KRL ENUM, such as {@code #T1}.
 *
 * @param name the constant's name without the {@code #}: letters, digits, {@code _} and {@code $},
 *     not beginning with a digit
 */
public record KrlEnum(String name) implements KrlValue {

  /** Checks the name. */
  public KrlEnum {
    Objects.requireNonNull(name, "name");
    if (!KrlScanner.isName(name)) {
      throw new IllegalArgumentException(
          "an ENUM constant is a name of letters, digits, _ and $, is \"" + name + "\"");
    }
  }

  @Override
  public String asEnum() {
    return name;
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
