package no.hials.crosscom.simulator.internal.data;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Expression;

/**
 * The type of a variable or component.
 *
 * @param element the type of an element
 * @param dimensions the length of each dimension; empty without an array; the last length of a CHAR
 *     array is the length of its texts
 */
record DeclaredType(Type element, List<Integer> dimensions) {
  /** Keeps a typing error from filling the memory. */
  private static final long MAX_ELEMENTS = 1_000_000;

  /**
   * Evaluates a declaration.
   *
   * @param scope where types and constants are looked up
   * @param type the name of the type
   */
  static DeclaredType of(Scope scope, String type, Declaration.Declarator declarator)
      throws KrlErrorException {
    if (!scope.knowsType(type)) {
      throw new KrlErrorException(declarator.position(), "type " + type + " is not declared");
    }
    Type element = scope.type(type);
    List<Integer> lengths = lengths(scope, element, declarator);
    // three dimensions of an INT each would not fit a long
    double elements = 1;
    for (int length : lengths) {
      elements *= length;
    }
    if (elements > MAX_ELEMENTS) {
      throw new KrlErrorException(
          declarator.position(),
          String.format(
              Locale.ROOT,
              "%s must have 1 to %d elements, has %.0f",
              declarator.name(),
              MAX_ELEMENTS,
              elements));
    }
    DeclaredType declared = new DeclaredType(element, lengths);
    if (declared.bytes() > Scope.MAX_BYTES) {
      throw new KrlErrorException(
          declarator.position(), Scope.tooLarge(declarator.name(), declared.bytes()));
    }
    return declared;
  }

  /** Returns the bytes that a variable of this type takes at most, about. */
  long bytes() {
    // at most 1,000,000 elements of at most MAX_BYTES each
    long elements = 1;
    for (int length : dimensions) {
      elements *= length;
    }
    if (element != Type.Base.CHAR || dimensions.isEmpty()) {
      return elements * element.bytes();
    }
    return elements + elements / dimensions.get(dimensions.size() - 1) * Type.SCALAR_BYTES;
  }

  private static List<Integer> lengths(Scope scope, Type element, Declaration.Declarator declarator)
      throws KrlErrorException {
    if (element == Type.Base.CHAR
        && declarator.dimensions().size() == 1
        && declarator.dimensions().get(0) == null
        && declarator.initial() instanceof Expression.TextLiteral text
        && !text.text().isEmpty()) {
      return List.of(text.text().length());
    }
    List<Integer> lengths = new ArrayList<>();
    for (Expression dimension : declarator.dimensions()) {
      if (dimension == null) {
        throw new KrlErrorException(
            declarator.position(),
            "only a CHAR array with a text as its value may leave its length open, "
                + declarator.name()
                + " needs a length");
      }
      int length = ConstantExpressions.integer(dimension, scope);
      if (length < 1) {
        throw new KrlErrorException(
            dimension.position(), "the length of a dimension is 1 or more, is " + length);
      }
      lengths.add(length);
    }
    return List.copyOf(lengths);
  }

  /** Returns the type with which contents were declared. */
  static DeclaredType of(Storage contents) {
    List<Integer> dimensions = new ArrayList<>();
    Storage element = contents;
    if (contents instanceof ArrayStorage array) {
      for (int length : array.lengths()) {
        dimensions.add(length);
      }
      element = array.element(0);
    }
    if (element instanceof TextStorage text) {
      dimensions.add(text.capacity());
    }
    return new DeclaredType(element.type(), List.copyOf(dimensions));
  }

  /** Returns this type with the dimensions of another where those are longer. */
  DeclaredType atLeast(DeclaredType other) {
    if (dimensions.size() != other.dimensions.size()) {
      return this;
    }
    List<Integer> longer = new ArrayList<>();
    for (int i = 0; i < dimensions.size(); i++) {
      longer.add(Math.max(dimensions.get(i), other.dimensions.get(i)));
    }
    return new DeclaredType(element, List.copyOf(longer));
  }

  /** Returns a variable of this type without a value. */
  Storage uninitialised() {
    int depth = dimensions.size();
    Storage first = element.uninitialised();
    if (element == Type.Base.CHAR && depth > 0) {
      depth--;
      first = new TextStorage(dimensions.get(depth), null);
    }
    if (depth == 0) {
      return first;
    }
    int[] lengths = new int[depth];
    for (int i = 0; i < depth; i++) {
      lengths[i] = dimensions.get(i);
    }
    return new ArrayStorage(lengths, first);
  }

  /** Prints the dimensions as in a declaration: {@code [16,24]}. */
  String printDimensions() {
    return dimensions.isEmpty() ? "" : dimensions.toString().replace(" ", "");
  }

  /** Prints the type as in messages: {@code FRAME[16]}. */
  @Override
  public String toString() {
    return element.name() + printDimensions();
  }
}
