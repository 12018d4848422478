package no.hials.crosscom.protocol.value;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A KRL CHAR or CHAR array. A controller prints both in double quotes, so that {@code "A"} may be
 * either; a CHAR is the text of length one.
 *
 * @param text the characters between the quotes. It cannot hold a double quote: krl.md knows no way
 *     to write one inside a literal, and none is assumed here.
 */
public record KrlString(String text) implements KrlValue {

  /** Checks that the text has no double quote. */
  public KrlString {
    Objects.requireNonNull(text, "text");
    int quote = text.indexOf('"');
    if (quote >= 0) {
      throw new IllegalArgumentException(
          "a CHAR array cannot hold a double quote, found one at index " + quote + " of: " + text);
    }
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
