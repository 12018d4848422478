package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * Holds a variable of any type as a tree of values, to look at: an aggregate with nested
 * aggregates, texts or arrays, or a variable whose type the program does not know. It cannot be
 * written.
 */
public class KRLAny extends ScannedVariable {
  private @Nullable KrlValue value;

  /**
   * Makes a variable without a value.
   *
   * @param name the name on the controller
   */
  public KRLAny(String name) {
    super(name);
  }

  @Override
  boolean holdsText() {
    return true;
  }

  @Override
  public @Nullable KrlValue getValue() {
    return value;
  }

  /**
   * Gives the value that was read, in the form in which it would be written. Writing it is refused.
   *
   * @return the text
   * @throws UnsupportedOperationException always: a view is not for writing
   */
  @Override
  public String getStringValue() {
    throw new UnsupportedOperationException(
        getName() + " is a read-only view, write it through a typed variable");
  }

  @Override
  void read(KrlScanner scanner) {
    value = KrlValue.parse(scanner.text());
  }
}
