package no.hials.crosscom.lab.plot;

/**
 * The quantity on an axis.
 *
 * @param name the name of the quantity, such as {@code time}
 * @param unit its unit, such as {@code s}; empty if it has no unit or the unit is unknown
 */
public record Quantity(String name, String unit) {

  /**
   * Returns the label of the axis.
   *
   * @return the name and the unit
   */
  public String label() {
    return unit.isEmpty() ? name : name.isEmpty() ? unit : name + " [" + unit + "]";
  }
}
