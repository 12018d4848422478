package no.hials.crosscom.simulator;

import java.util.List;
import no.hials.crosscom.lang.Access;

/**
 * The declaration and the meaning of a variable.
 *
 * @param name the name as declared, without dimensions
 * @param type the name of its type, or of the type of an element; {@code SIGNAL} for a signal
 * @param dimensions the length of each dimension; empty without an array; the last length of a CHAR
 *     array is the length of its texts
 * @param access the access of clients
 * @param unit the unit of its values, such as {@code mm/deg}; empty without one
 * @param meaning the meaning; for a variable from a user's data list the comment after its
 *     declaration; empty without one
 * @param source the source of access, unit and meaning: tags of
 *     docs/reference/sources.md#source-tags, {@code U} if unconfirmed, {@code assumed} if chosen
 *     for this simulation; empty for a user's variable
 */
public record VariableInfo(
    String name,
    String type,
    List<Integer> dimensions,
    Access access,
    String unit,
    String meaning,
    String source) {

  /** Copies the dimensions. */
  public VariableInfo {
    dimensions = List.copyOf(dimensions);
  }
}
