package no.hials.crosscom.cell;

import java.util.List;
import no.hials.crosscom.lang.Access;
import org.jspecify.annotations.Nullable;

/**
 * What is known of a variable.
 *
 * @param name as declared, without dimensions
 * @param type the name of its type, of an array that of an element
 * @param dimensions the length of each, 0 for one that is not known; none for what is no array
 * @param access what clients may do; null if that is not known
 * @param unit of its values; empty if none or not known
 * @param meaning what it stands for; empty if not known
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

  /** Returns the name as it is declared, as {@code $TORQUE_AXIS_ACT[12]}. */
  public String declarator() {
    return name + brackets(dimensions);
  }

  private static String brackets(List<Integer> dimensions) {
    if (dimensions.isEmpty()) {
      return "";
    }
    return dimensions.stream()
        .map(length -> length == 0 ? "" : Integer.toString(length))
        .collect(java.util.stream.Collectors.joining(",", "[", "]"));
  }

  /** Returns {@code RO} or {@code RW}, empty if it is not known. */
  public String shortAccess() {
    return access == null ? "" : access == Access.READ_ONLY ? "RO" : "RW";
  }

  /** Returns whether it is a text: an array of CHAR. */
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
