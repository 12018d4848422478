package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlValue;
import org.jspecify.annotations.Nullable;

/**
 * Holds a variable of any type as a read-only tree of values: an aggregate with nested aggregates,
 * texts or arrays, or a variable whose type the program does not know.
 */
public class KRLAny extends ScannedVariable {
  private @Nullable KrlValue value;

  /**
   * Creates a variable without a value.
   *
   * @param name the name on the controller
   */
  public KRLAny(String name) {
    super(name);
  }

  @Override
  public @Nullable KrlValue getValue() {
    return value;
  }

  /**
   * Throws, since the variable cannot be written.
   *
   * @return never
   * @throws UnsupportedOperationException always
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
