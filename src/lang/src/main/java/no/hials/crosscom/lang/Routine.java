package no.hials.crosscom.lang;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A subprogram ({@code DEF}) or a function ({@code DEFFCT}).
 *
 * @param position where it begins
 * @param global whether it says {@code GLOBAL}
 * @param returnType the type of a function's value; null for a subprogram
 * @param name its name as written
 * @param parameters its parameters
 * @param declarations its declarations; those of interrupts are statements
 * @param body its statements
 * @param end where its {@code END} or {@code ENDFCT} stands
 */
public record Routine(
    Position position,
    boolean global,
    @Nullable String returnType,
    String name,
    List<Parameter> parameters,
    List<Declaration> declarations,
    List<Statement> body,
    Position end) {

  /**
   * A parameter. Its type is declared like that of a variable; one without a declaration is an
   * error that the interpreter reports.
   *
   * @param position where it stands
   * @param name its name as written
   * @param array how many dimensions it has: 0, 1 for {@code NAME[]}, 2 for {@code NAME[,]}
   * @param out whether it is {@code :OUT}, so that the caller sees what is assigned to it; {@code
   *     :IN} is a copy. Without either KRL takes {@code :OUT} (assumed)
   */
  public record Parameter(Position position, String name, int array, boolean out) {}
}
