package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;
import org.jspecify.annotations.Nullable;

/** Holds a BOOL. */
public class KRLBool extends ScannedVariable {
  private boolean value;
  private boolean present;

  /**
   * Creates a variable without a value.
   *
   * @param name the name on the controller
   */
  public KRLBool(String name) {
    super(name);
  }

  @Override
  String typeForPeople() {
    return "BOOL";
  }

  @Override
  public @Nullable Boolean getValue() {
    return present ? value : null;
  }

  /**
   * Returns the local value, without creating an object.
   *
   * @return the value
   * @throws IllegalStateException if it was neither set nor read
   */
  public boolean booleanValue() {
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
  public void setValue(boolean newValue) {
    value = newValue;
    present = true;
  }

  @Override
  public String getStringValue() {
    return booleanValue() ? "TRUE" : "FALSE";
  }

  @Override
  protected boolean holdsText() {
    return false;
  }

  @Override
  void read(KrlScanner scanner) {
    boolean read = scanner.readBool();
    scanner.expectEnd();
    value = read;
    present = true;
  }
}
