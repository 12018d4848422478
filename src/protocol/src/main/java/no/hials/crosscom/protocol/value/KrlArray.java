package no.hials.crosscom.protocol.value;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The elements of a whole numeric, BOOL or ENUM array, as a read of {@code NAME[]} returns them.
 *
 * @param elements at least one; all INT, all REAL, all BOOL or all ENUM
 */
public record KrlArray(List<KrlValue> elements) implements KrlValue {

  /** Checks that all elements are scalars of one type. */
  public KrlArray {
    elements = List.copyOf(elements);
    if (elements.isEmpty()) {
      throw new IllegalArgumentException("an array must have at least 1 element, has 0");
    }
    KrlValue first = elements.get(0);
    if (!isElement(first)) {
      throw new IllegalArgumentException(
          "an array's elements must be INT, REAL, BOOL or ENUM, [1] is " + first);
    }
    for (int i = 1; i < elements.size(); i++) {
      if (elements.get(i).getClass() != first.getClass()) {
        throw new IllegalArgumentException(
            "an array's elements must be of one type, [1] is "
                + first
                + ", ["
                + (i + 1)
                + "] is "
                + elements.get(i));
      }
    }
  }

  /**
   * Returns whether a value can be an element of an array.
   *
   * @param value the value
   * @return true for an INT, REAL, BOOL or ENUM
   */
  public static boolean isElement(KrlValue value) {
    return value instanceof KrlInt
        || value instanceof KrlReal
        || value instanceof KrlBool
        || value instanceof KrlEnum;
  }

  @Override
  public List<KrlValue> asList() {
    return elements;
  }

  @Override
  public <R extends @Nullable Object> R accept(KrlVisitor<R> visitor) {
    return visitor.visit(this);
  }

  @Override
  public String toString() {
    return print();
  }
}
