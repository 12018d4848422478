package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;

/**
 * What a declaration says of a variable besides its name.
 *
 * @param type the type of an element
 * @param dimensions the length of each, none for what is no array; the last one of a CHAR array is
 *     the length of its texts
 */
record DeclaredType(Type type, List<Integer> dimensions) {

  /** Finds out how contents were declared. */
  static DeclaredType of(Storage contents) {
    List<Integer> dimensions = new ArrayList<>();
    Storage element = contents;
    if (contents instanceof Storage.Array array) {
      for (int length : array.lengths()) {
        dimensions.add(length);
      }
      element = array.elements().get(0);
    }
    if (element instanceof Storage.Text text) {
      dimensions.add(text.capacity());
      return new DeclaredType(Type.Base.CHAR, List.copyOf(dimensions));
    }
    Type type =
        element instanceof Storage.Struc struc ? struc.type() : ((Storage.Scalar) element).type();
    return new DeclaredType(type, List.copyOf(dimensions));
  }

  /** Prints it as behind a name: {@code FRAME[16]}. */
  @Override
  public String toString() {
    return dimensions.isEmpty()
        ? type.name()
        : type.name() + dimensions.toString().replace(" ", "");
  }
}
