package no.hials.crosscom.simulator.internal.data;

import java.util.Optional;
import no.hials.crosscom.lang.Declaration;
import no.hials.crosscom.lang.Position;

/**
 * An {@code IMPORT ... IS /R1/MODULE..NAME}: a variable of the data list of another module.
 *
 * @param position where it begins
 * @param module the name of the other module, as written
 * @param name the name of the variable in upper case
 */
public record Import(Position position, String module, String name) {
  /**
   * Returns the import of a declaration; empty for {@code EXT} and {@code EXTFCT}.
   *
   * @throws KrlErrorException if the variable gets another name
   */
  public static Optional<Import> of(Declaration.External external) throws KrlErrorException {
    String source = external.source();
    int dots = source.lastIndexOf("..");
    if (dots < 0) {
      return Optional.empty();
    }
    String original = source.substring(dots + 2);
    if (!Scope.key(original).equals(Scope.key(external.name()))) {
      // assumed: KSS can import a variable under another name
      throw new KrlErrorException(
          external.position(),
          "IMPORT keeps the name of the variable in this simulation, expected "
              + original
              + ", found "
              + external.name());
    }
    String path = source.substring(0, dots);
    String module = path.substring(path.lastIndexOf('/') + 1);
    return Optional.of(new Import(external.position(), module, Scope.key(original)));
  }
}
