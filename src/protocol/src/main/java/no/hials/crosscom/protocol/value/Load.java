package no.hials.crosscom.protocol.value;

import java.util.Objects;

/**
 * The load on the flange or on an axis, like KRL's type LOAD
 * (docs/reference/krl-values.md#fields-of-the-structures).
 *
 * @param m the mass, kg
 * @param cm the centre of mass, mm, and the orientation of the principal axes of inertia, degrees
 * @param j the moments of inertia
 */
public record Load(double m, Frame cm, Inertia j) {

  /** Checks that the mass is finite. */
  public Load {
    m = Fields.finite("M", m);
    Objects.requireNonNull(cm, "cm");
    Objects.requireNonNull(j, "j");
  }

  /**
   * The moments of inertia about the principal axes, like KRL's type INERTIA.
   *
   * @param x about X, kg m²
   * @param y about Y, kg m²
   * @param z about Z, kg m²
   */
  public record Inertia(double x, double y, double z) {

    /** Checks that the numbers are finite; -0 becomes 0. */
    public Inertia {
      x = Fields.finite("X", x);
      y = Fields.finite("Y", y);
      z = Fields.finite("Z", z);
    }
  }
}
