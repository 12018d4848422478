package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlText;
import org.jspecify.annotations.Nullable;

/**
 * Holds a REAL, which is a 32-bit float on the controller. It can also read an INT and, if its
 * value is whole, write one.
 */
public class KRLReal extends ScannedVariable {
  private double value;
  private boolean present;

  /**
   * Creates a variable without a value.
   *
   * @param name the name on the controller
   */
  public KRLReal(String name) {
    super(name);
  }

  @Override
  String typeForPeople() {
    return "REAL";
  }

  @Override
  public @Nullable Double getValue() {
    return present ? value : null;
  }

  /**
   * Returns the local value, without creating an object.
   *
   * @return the value
   * @throws IllegalStateException if it was neither set nor read
   */
  public double doubleValue() {
    if (!present) {
      throw noValue();
    }
    return value;
  }

  /**
   * Sets the local value.
   *
   * @param newValue the value; sent as the nearest 32-bit float, with the fewest digits that
   *     identify it
   * @throws IllegalArgumentException if it is NaN, infinite or too large for a 32-bit float
   */
  public void setValue(double newValue) {
    KrlReal.toFloat(newValue); // checks the range of a float
    value = newValue;
    present = true;
  }

  @Override
  public String getStringValue() {
    return new KrlReal((float) doubleValue()).printShort();
  }

  @Override
  protected boolean holdsText() {
    return false;
  }

  @Override
  protected boolean appendValue(KrlText text) {
    text.append((float) doubleValue());
    return true;
  }

  @Override
  void read(KrlScanner scanner) {
    double read = scanner.readReal();
    scanner.expectEnd();
    value = read;
    present = true;
  }
}
