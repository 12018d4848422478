package no.hials.crosscom.variables;

/**
 * Holds a field of a {@link Struct}.
 *
 * @param <E> the Java type of its value
 */
public class StructNode<E> {
  private final String name;
  private final E value;

  /**
   * Creates a field.
   *
   * @param name its name
   * @param value its value
   */
  public StructNode(String name, E value) {
    this.name = name;
    this.value = value;
  }

  /** Returns the field's name. */
  public String getName() {
    return name;
  }

  /** Returns the field's value. */
  public E getValue() {
    return value;
  }

  @Override
  public String toString() {
    return name + " " + value;
  }
}
