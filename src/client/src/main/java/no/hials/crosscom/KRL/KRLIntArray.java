package no.hials.crosscom.KRL;

import java.util.Arrays;
import no.hials.crosscom.protocol.value.KrlScanner;
import org.jspecify.annotations.Nullable;

/** Holds a whole array of INT. */
public class KRLIntArray extends KRLArray {
  private int[] values = {};
  private int[] scratch = {};

  /**
   * Creates an array without elements.
   *
   * @param name the name on the controller, with or without {@code []} after it
   */
  public KRLIntArray(String name) {
    this(name, 0);
  }

  /**
   * Creates an array without elements.
   *
   * @param name the name on the controller, with or without {@code []} after it
   * @param length the number of elements, for servers that cannot read a whole array; 0 if unknown
   */
  public KRLIntArray(String name, int length) {
    super(name, length);
  }

  @Override
  String typeForPeople() {
    return "INT array";
  }

  @Override
  public int @Nullable [] getValue() {
    return length() == 0 ? null : Arrays.copyOf(values, length());
  }

  /**
   * Sets all elements.
   *
   * @param newValues at least one
   */
  public void setValue(int... newValues) {
    setLength(newValues.length);
    values = newValues.clone();
  }

  @Override
  void print(StringBuilder text, int index) {
    text.append(values[index]);
  }

  @Override
  void read(KrlScanner scanner, int index) {
    if (index == scratch.length) {
      scratch = Arrays.copyOf(scratch, Math.max(16, 2 * index));
    }
    scratch[index] = scanner.readInt();
  }

  @Override
  void accept(int count) {
    int[] free = values;
    values = scratch;
    scratch = free;
  }

  @Override
  String valueForPeople() {
    return Arrays.toString(getValue());
  }
}
