package no.hials.crosscom.KRL;

import java.util.Arrays;
import no.hials.crosscom.protocol.value.KrlPrinter;
import no.hials.crosscom.protocol.value.KrlScanner;
import org.jspecify.annotations.Nullable;

/** Holds a whole array of BOOL. */
public class KRLBoolArray extends KRLArray {
  private boolean[] values = {};
  private boolean[] scratch = {};

  /**
   * Creates an array without elements.
   *
   * @param name the name on the controller, with or without {@code []} after it
   */
  public KRLBoolArray(String name) {
    this(name, 0);
  }

  /**
   * Creates an array without elements.
   *
   * @param name the name on the controller, with or without {@code []} after it
   * @param length the number of elements, for servers that cannot read a whole array; 0 if unknown
   */
  public KRLBoolArray(String name, int length) {
    super(name, length);
  }

  @Override
  String typeForPeople() {
    return "BOOL array";
  }

  @Override
  public boolean @Nullable [] getValue() {
    return length() == 0 ? null : Arrays.copyOf(values, length());
  }

  /**
   * Sets all elements.
   *
   * @param newValues at least one
   */
  public void setValue(boolean... newValues) {
    setLength(newValues.length);
    values = newValues.clone();
  }

  @Override
  void print(StringBuilder text, int index) {
    KrlPrinter.appendBool(text, values[index]);
  }

  @Override
  void read(KrlScanner scanner, int index) {
    if (index == scratch.length) {
      scratch = Arrays.copyOf(scratch, Math.max(16, 2 * index));
    }
    scratch[index] = scanner.readBool();
  }

  @Override
  void accept(int count) {
    boolean[] free = values;
    values = scratch;
    scratch = free;
  }

  @Override
  String valueForPeople() {
    return Arrays.toString(getValue());
  }
}
