package no.hials.crosscom.protocol.value;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A KRL CHAR or CHAR array. A controller prints both in double quotes, so {@code "A"} may be
 * either; a CHAR is a text of length one.
 *
 * @param text the characters between the quotes. Assumed to hold no double quote, since no way to
 *     write one in a literal is known.
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
  public String asString() {
    return text.equals(" ") ? "" : text;
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
