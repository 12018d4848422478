package no.hials.crosscom.KRL;

import java.util.Arrays;
import no.hials.crosscom.protocol.value.KrlPrinter;
import no.hials.crosscom.protocol.value.KrlReal;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.RealStyle;
import org.jspecify.annotations.Nullable;

/** Holds a whole array of REAL. */
public class KRLRealArray extends KRLArray {
  private double[] values = {};
  private double[] scratch = {};

  /**
   * Creates an array without elements.
   *
   * @param name the name on the controller, with or without {@code []} after it
   */
  public KRLRealArray(String name) {
    this(name, 0);
  }

  /**
   * Creates an array without elements.
   *
   * @param name the name on the controller, with or without {@code []} after it
   * @param length the number of elements, for servers that cannot read a whole array; 0 if unknown
   */
  public KRLRealArray(String name, int length) {
    super(name, length);
  }

  @Override
  String typeForPeople() {
    return "REAL array";
  }

  @Override
  public double @Nullable [] getValue() {
    return length() == 0 ? null : Arrays.copyOf(values, length());
  }

  /**
   * Sets all elements.
   *
   * @param newValues at least one, each in the range of a 32-bit float
   * @throws IllegalArgumentException if an element is NaN, infinite or too large
   */
  public void setValue(double... newValues) {
    for (double value : newValues) {
      KrlReal.toFloat(value); // checks the range of a float
    }
    setLength(newValues.length);
    values = newValues.clone();
  }

  @Override
  void print(StringBuilder text, int index) {
    KrlPrinter.appendReal(text, (float) values[index], RealStyle.SHORTEST);
  }

  @Override
  void read(KrlScanner scanner, int index) {
    if (index == scratch.length) {
      scratch = Arrays.copyOf(scratch, Math.max(16, 2 * index));
    }
    scratch[index] = scanner.readReal();
  }

  @Override
  void accept(int count) {
    double[] free = values;
    values = scratch;
    scratch = free;
  }

  @Override
  String valueForPeople() {
    return Arrays.toString(getValue());
  }
}
