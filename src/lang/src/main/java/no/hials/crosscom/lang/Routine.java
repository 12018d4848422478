package no.hials.crosscom.lang;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A subprogram ({@code DEF}) or a function ({@code DEFFCT}).
 *
 * @param position where it begins
 * @param global whether it is {@code GLOBAL}
 * @param returnType the type that a function returns; null for a subprogram
 * @param returnDimensions the length of each dimension of an array that a function returns, as in
 *     {@code DEFFCT CHAR[16] F()}; null for an open dimension; empty for all others
 * @param name its name as written
 * @param parameters its parameters
 * @param declarations its declarations; interrupt declarations are statements
 * @param body its statements
 * @param end where its {@code END} or {@code ENDFCT} is
 */
public record Routine(
    Position position,
    boolean global,
    @Nullable String returnType,
    List<@Nullable Expression> returnDimensions,
    String name,
    List<Parameter> parameters,
    List<Declaration> declarations,
    List<Statement> body,
    Position end) {

  /**
   * A parameter. Its type is declared like the type of a variable; the interpreter reports a
   * parameter without a declaration.
   *
   * @param position where it is
   * @param name its name as written
   * @param array the number of dimensions: 0, 1 for {@code NAME[]}, 2 for {@code NAME[,]}
   * @param out whether it is {@code :OUT}, so that assignments change the caller's variable; {@code
   *     :IN} is a copy. The default is {@code :OUT} (assumed)
   */
  public record Parameter(Position position, String name, int array, boolean out) {}
}
