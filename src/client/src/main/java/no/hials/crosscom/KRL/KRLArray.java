package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;

/**
 * Holds a whole array of scalars. Reading takes one access; a controller has no way to write a
 * whole array (krl.md 1.4), so that writing takes one access for each element.
 */
public abstract class KRLArray extends KRLVariable {
  private final int declaredLength;
  private int length;

  KRLArray(String name, int declaredLength) {
    super(ScannedVariable.wholeArray(name));
    if (!getName().endsWith("[]")) {
      throw new IllegalArgumentException(
          "the name of a whole array is NAME or NAME[], is \"" + name + "\"");
    }
    if (declaredLength < 0) {
      throw new IllegalArgumentException(
          name + ": the length must be 0 (unknown) or more, is " + declaredLength);
    }
    this.declaredLength = declaredLength;
  }

  /**
   * Gives the length that the program said the array has. A server that cannot read the array whole
   * is asked for so many elements.
   *
   * @return 0 if the program did not say
   */
  public int getDeclaredLength() {
    return declaredLength;
  }

  /**
   * Gives the number of elements.
   *
   * @return 0 if the array was neither set nor read
   */
  public int length() {
    return length;
  }

  /**
   * Gives the name of an element.
   *
   * @param index from 1, as in KRL
   * @return such as {@code MYINTS[3]}
   */
  public String getElementName(int index) {
    return getName().substring(0, getName().length() - 1) + index + "]";
  }

  /**
   * Gives the text of an element, as a write sends it.
   *
   * @param index from 1, as in KRL, to {@link #length()}
   * @return the text
   * @throws IndexOutOfBoundsException if there is no such element
   */
  public String getElementStringValue(int index) {
    if (index < 1 || index > length) {
      throw new IndexOutOfBoundsException(
          getName() + " index must be 1 to " + length + ", is " + index);
    }
    StringBuilder text = new StringBuilder();
    print(text, index - 1);
    return text.toString();
  }

  @Override
  public String getStringValue() {
    if (length == 0) {
      throw noValue();
    }
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < length; i++) {
      if (i > 0) {
        text.append(' ');
      }
      print(text, i);
    }
    return text.toString();
  }

  /** Sets the length when the elements were set. */
  void setLength(int newLength) {
    if (newLength == 0) {
      throw new IllegalArgumentException(getName() + " must have at least 1 element, has 0");
    }
    length = newLength;
  }

  /** Appends the text of an element, from 0. */
  abstract void print(StringBuilder text, int index);

  /** Reads one element into a place, from 0, that is not visible before {@link #accept}. */
  abstract void read(KrlScanner scanner, int index);

  /** Makes what was read the value. */
  abstract void accept(int count);

  final void acceptAll(int count) {
    accept(count);
    length = count;
  }

  @Override
  protected final boolean setValueFrom(KrlScanner scanner, boolean written) {
    int count = 0;
    do {
      read(scanner, count++);
    } while (scanner.hasMore());
    acceptAll(count);
    return true;
  }

  @Override
  protected void setValueFromString(String strValue) {
    setValueFrom(new KrlScanner(strValue), false);
  }
}
