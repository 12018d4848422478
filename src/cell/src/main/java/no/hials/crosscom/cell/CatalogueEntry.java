package no.hials.crosscom.cell;

import java.util.List;
import java.util.stream.Collectors;
import no.hials.crosscom.lang.Access;
import org.jspecify.annotations.Nullable;

/**
 * The description of a variable.
 *
 * @param name the name as declared, without dimensions
 * @param type the name of its type; for an array, the type of an element
 * @param dimensions the length of each dimension, 0 if unknown; empty if the variable is not an
 *     array
 * @param access the access of clients; null if unknown
 * @param unit the unit of its values; empty if it has no unit or the unit is unknown
 * @param meaning its meaning; empty if unknown
 * @param origin the file on the controller that declares it; empty for a system variable
 */
public record CatalogueEntry(
    String name,
    String type,
    List<Integer> dimensions,
    @Nullable Access access,
    String unit,
    String meaning,
    String origin) {

  /** Returns the name as declared, such as {@code $TORQUE_AXIS_ACT[12]}. */
  public String declarator() {
    return name + brackets(dimensions);
  }

  private static String brackets(List<Integer> dimensions) {
    if (dimensions.isEmpty()) {
      return "";
    }
    return dimensions.stream()
        .map(length -> length == 0 ? "" : Integer.toString(length))
        .collect(Collectors.joining(",", "[", "]"));
  }

  /** Returns {@code RO} or {@code RW}; empty if the access is unknown. */
  public String shortAccess() {
    return access == null ? "" : access == Access.READ_ONLY ? "RO" : "RW";
  }

  /** Returns whether the variable is a text: an array of CHAR. */
  public boolean isText() {
    return type.equals("CHAR") && !dimensions.isEmpty();
  }

  /** Returns type, unit and meaning in a few words. */
  public String summary() {
    StringBuilder words = new StringBuilder(type);
    if (!unit.isEmpty()) {
      words.append(' ').append(unit);
    }
    if (!shortAccess().isEmpty()) {
      words.append(' ').append(shortAccess());
    }
    if (!meaning.isEmpty()) {
      words.append(", ").append(meaning);
    }
    return words.toString();
  }
}
