package no.hials.crosscom.simulator;

import java.util.List;
import no.hials.crosscom.lang.Access;

/**
 * What is known of a variable besides its value.
 *
 * @param name the name as declared, without dimensions
 * @param type the name of its type, of an array that of an element; {@code SIGNAL} for a signal
 * @param dimensions the length of each dimension, none for what is no array; the last one of a CHAR
 *     array is the length of its texts
 * @param access what clients may do
 * @param unit the unit of its values, such as {@code mm/deg}; empty if it has none or none is known
 * @param meaning what it stands for; of a variable from a user's data list the comment behind its
 *     declaration; empty if there is none
 * @param source where access, unit and meaning are known from:
 *     docs/reference/sources.md#source-tags, {@code U} for what is unconfirmed there, {@code
 *     assumed} for what was chosen for this server; empty for a user's own
 */
public record VariableInfo(
    String name,
    String type,
    List<Integer> dimensions,
    Access access,
    String unit,
    String meaning,
    String source) {

  /** Keeps a copy of the dimensions. */
  public VariableInfo {
    dimensions = List.copyOf(dimensions);
  }
}
