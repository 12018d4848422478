package no.hials.crosscom.lab.plot;

/**
 * What an axis shows.
 *
 * @param name what is counted or measured, such as {@code time}
 * @param unit its unit, such as {@code s}; empty if it has none or none is known
 */
public record Axis(String name, String unit) {

  /**
   * Returns the label of the axis.
   *
   * @return name and unit
   */
  public String label() {
    return unit.isEmpty() ? name : name.isEmpty() ? unit : name + " [" + unit + "]";
  }
}
