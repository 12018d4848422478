package no.hials.crosscom.control;

import no.hials.crosscom.protocol.value.Frame;

/**
 * A box along the axes of {@code $BASE} in which the tool centre point must stay.
 *
 * @param minX the minimum X, mm
 * @param maxX the maximum X, mm
 * @param minY the minimum Y, mm
 * @param maxY the maximum Y, mm
 * @param minZ the minimum Z, mm
 * @param maxZ the maximum Z, mm
 */
public record Workspace(
    double minX, double maxX, double minY, double maxY, double minZ, double maxZ) {
  /** Checks that each minimum is less than its maximum. */
  public Workspace {
    ordered("X", minX, maxX);
    ordered("Y", minY, maxY);
    ordered("Z", minZ, maxZ);
  }

  private static void ordered(String axis, double min, double max) {
    Checks.finite("minimum of " + axis, min);
    Checks.finite("maximum of " + axis, max);
    Checks.holds(
        min < max,
        "the workspace must have a minimum of "
            + axis
            + " below the maximum, has "
            + min
            + " and "
            + max);
  }

  /**
   * Returns a cube.
   *
   * @param centre its centre
   * @param reach the distance from the centre to each side, mm
   */
  public static Workspace around(Frame centre, double reach) {
    Checks.positive("reach of the workspace", reach);
    return new Workspace(
        centre.x() - reach,
        centre.x() + reach,
        centre.y() - reach,
        centre.y() + reach,
        centre.z() - reach,
        centre.z() + reach);
  }

  double min(int axis) {
    return axis == 0 ? minX : axis == 1 ? minY : minZ;
  }

  double max(int axis) {
    return axis == 0 ? maxX : axis == 1 ? maxY : maxZ;
  }
}
