package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlText;
import org.jspecify.annotations.Nullable;

/** Holds an INT: 32 bits, signed. */
public class KRLInt extends ScannedVariable {
  private int value;
  private boolean present;

  /**
   * Creates a variable without a value.
   *
   * @param name the name on the controller
   */
  public KRLInt(String name) {
    super(name);
  }

  @Override
  String typeForPeople() {
    return "INT";
  }

  @Override
  public @Nullable Integer getValue() {
    return present ? value : null;
  }

  /**
   * Returns the local value, without creating an object.
   *
   * @return the value
   * @throws IllegalStateException if it was neither set nor read
   */
  public int intValue() {
    if (!present) {
      throw noValue();
    }
    return value;
  }

  /**
   * Sets the local value.
   *
   * @param newValue the value
   */
  public void setValue(int newValue) {
    value = newValue;
    present = true;
  }

  @Override
  public String getStringValue() {
    return Integer.toString(intValue());
  }

  @Override
  protected boolean holdsText() {
    return false;
  }

  @Override
  protected boolean appendValue(KrlText text) {
    text.append(intValue());
    return true;
  }

  @Override
  void read(KrlScanner scanner) {
    int read = scanner.readInt();
    scanner.expectEnd();
    value = read;
    present = true;
  }
}
