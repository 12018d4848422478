package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlPrinter;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.RealStyle;
import org.jspecify.annotations.Nullable;

/**
 * Holds a REAL, which is a 32-bit float on the controller; an INT can be read and, with a whole
 * value, written too.
 */
public class KRLReal extends ScannedVariable {
  private double value;
  private boolean present;

  /**
   * Makes a variable without a value.
   *
   * @param name the name on the controller
   */
  public KRLReal(String name) {
    super(name);
  }

  @Override
  public @Nullable Double getValue() {
    return present ? value : null;
  }

  /**
   * Gives the local value, without making an object.
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
   * @param newValue the value; sent as the nearest 32-bit float, with the fewest digits that keep
   *     it
   * @throws IllegalArgumentException if no 32-bit float can hold it: NaN, infinite or too large
   */
  public void setValue(double newValue) {
    KrlReal.of(newValue); // refuses what no float holds
    value = newValue;
    present = true;
  }

  @Override
  public String getStringValue() {
    return new KrlReal((float) doubleValue()).printShort();
  }

  @Override
  protected boolean appendValue(StringBuilder text) {
    KrlPrinter.appendReal(text, (float) doubleValue(), RealStyle.SHORTEST);
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
