package no.hials.crosscom.protocol.value;

/**
 * The positions of six robot axes and six external axes, like KRL's type E6AXIS.
 *
 * @param a1 axis 1, degrees
 * @param a2 axis 2, degrees
 * @param a3 axis 3, degrees
 * @param a4 axis 4, degrees
 * @param a5 axis 5, degrees
 * @param a6 axis 6, degrees
 * @param e1 external axis 1, degrees, or mm if linear
 * @param e2 external axis 2, degrees, or mm if linear
 * @param e3 external axis 3, degrees, or mm if linear
 * @param e4 external axis 4, degrees, or mm if linear
 * @param e5 external axis 5, degrees, or mm if linear
 * @param e6 external axis 6, degrees, or mm if linear
 */
public record E6Axis(
    double a1,
    double a2,
    double a3,
    double a4,
    double a5,
    double a6,
    double e1,
    double e2,
    double e3,
    double e4,
    double e5,
    double e6) {

  /** Checks that the numbers are finite; -0 becomes 0. */
  public E6Axis {
    a1 = Fields.finite("A1", a1);
    a2 = Fields.finite("A2", a2);
    a3 = Fields.finite("A3", a3);
    a4 = Fields.finite("A4", a4);
    a5 = Fields.finite("A5", a5);
    a6 = Fields.finite("A6", a6);
    e1 = Fields.finite("E1", e1);
    e2 = Fields.finite("E2", e2);
    e3 = Fields.finite("E3", e3);
    e4 = Fields.finite("E4", e4);
    e5 = Fields.finite("E5", e5);
    e6 = Fields.finite("E6", e6);
  }

  /** Returns the positions of the robot axes. */
  public Axis axis() {
    return new Axis(a1, a2, a3, a4, a5, a6);
  }
}
