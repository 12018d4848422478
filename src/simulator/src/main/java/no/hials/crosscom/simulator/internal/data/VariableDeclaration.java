package no.hials.crosscom.simulator.internal.data;

import java.util.List;
import java.util.Optional;
import no.hials.crosscom.lang.Access;

/**
 * The declaration of a variable.
 *
 * @param name as declared, without dimensions
 * @param type the name of the type of an element; {@code SIGNAL} for a signal
 * @param dimensions the length of each dimension; empty without an array; the last length of a CHAR
 *     array is the length of its texts
 * @param access what clients and programs may do
 */
public record VariableDeclaration(
    String name, String type, List<Integer> dimensions, Access access) {

  /**
   * Returns the declaration of a variable, in a scope or around it, by its name in any case without
   * index.
   */
  public static Optional<VariableDeclaration> find(Scope scope, String name) {
    return Optional.ofNullable(scope.lookup(Scope.key(name))).map(VariableDeclaration::of);
  }

  private static VariableDeclaration of(VariableEntry variable) {
    Storage contents = variable.contents();
    if (contents == null) {
      return new VariableDeclaration(variable.name(), "SIGNAL", List.of(), variable.access());
    }
    DeclaredType shape = DeclaredType.of(contents);
    return new VariableDeclaration(
        variable.name(), shape.element().name(), shape.dimensions(), variable.access());
  }
}
