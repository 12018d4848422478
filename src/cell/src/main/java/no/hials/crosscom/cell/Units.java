package no.hials.crosscom.cell;

import java.util.Locale;
import java.util.Set;

/**
 * The units of variables, from the table of system variables or, if the table has no unit, from the
 * names of fields: KRL has X, Y and Z in mm, A, B, C and axes in degrees
 * (docs/reference/krl-values.md#fields-of-the-structures).
 */
public final class Units {
  private static final String DEGREES = "°";

  /** The units of positions in the table: each field has its own. */
  private static final Set<String> POSITIONS = Set.of("mm/deg", "deg");

  private final Catalogue catalogue = Catalogue.system();

  public Units() {}

  /**
   * Returns the unit of a number.
   *
   * @param name the name in a recording: {@code $POS_ACT.X}, {@code cell1:$TORQUE_AXIS_ACT[1]}
   * @return the unit; empty if it has no unit or the unit is unknown
   */
  public String of(String name) {
    String variable = name.substring(name.indexOf(':') + 1);
    String base = variable.split("[.\\[]", 2)[0];
    String field = variable.substring(variable.lastIndexOf('.') + 1).toUpperCase(Locale.ROOT);
    boolean isField = variable.indexOf('.') >= 0;
    String unit = catalogue.find(base).map(CatalogueEntry::unit).orElse("");
    boolean nested = variable.indexOf('.') != variable.lastIndexOf('.');
    if (nested && variable.toUpperCase(Locale.ROOT).contains(".J.")) {
      return "kg m²";
    }
    if (nested || (isField && (unit.isEmpty() || POSITIONS.contains(unit)))) {
      return ofField(field);
    }
    if (field.startsWith("ORI")) {
      return DEGREES + "/s";
    }
    return unit.equals("deg") ? DEGREES : unit;
  }

  private static String ofField(String field) {
    if (field.matches("[XYZ]")) {
      return "mm";
    }
    // E1 to E6 are mm or degrees, depending on the machine
    return field.matches("[ABC]|A[1-6]") ? DEGREES : "";
  }
}
