package no.hials.crosscom.KRL;

import no.hials.crosscom.protocol.value.KrlScanner;

/**
 * Holds a whole array of scalars. Reading takes one access. A controller cannot write a whole
 * array, so writing takes one access per element (docs/reference/krl-values.md#arrays).
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
   * Returns the length given by the program. The client reads this number of elements from servers
   * that cannot read a whole array.
   *
   * @return 0 if unknown
   */
  public int getDeclaredLength() {
    return declaredLength;
  }

  /** Returns the number of elements; 0 if the array was neither set nor read. */
  public int length() {
    return length;
  }

  @Override
  protected boolean holdsText() {
    return false;
  }

  /**
   * Returns the name of an element.
   *
   * @param index from 1, as in KRL
   * @return such as {@code MYINTS[3]}
   */
  public String getElementName(int index) {
    return getName().substring(0, getName().length() - 1) + index + "]";
  }

  /**
   * Returns the text of an element, as sent by a write.
   *
   * @param index from 1, as in KRL, to {@link #length()}
   * @return the text
   * @throws IndexOutOfBoundsException if the index is out of range
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

  /** Sets the length after the elements were set. */
  void setLength(int newLength) {
    if (newLength == 0) {
      throw new IllegalArgumentException(getName() + " must have at least 1 element, has 0");
    }
    length = newLength;
  }

  /** Appends the text of an element; the index starts at 0. */
  abstract void print(StringBuilder text, int index);

  /** Reads an element, from 0; it is not visible before {@link #accept}. */
  abstract void read(KrlScanner scanner, int index);

  /** Sets the value to the elements that were read. */
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
