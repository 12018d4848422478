package no.hials.crosscom.protocol.value;

/**
 * A {@link Pos} with six external axes, like KRL's type E6POS.
 *
 * @param x the position along X, mm
 * @param y the position along Y, mm
 * @param z the position along Z, mm
 * @param a the rotation about Z, degrees
 * @param b the rotation about the new Y, degrees
 * @param c the rotation about the new X, degrees
 * @param s Status (docs/reference/kinematics.md#status-and-turn)
 * @param t Turn
 * @param e1 external axis 1, degrees, or mm if linear
 * @param e2 external axis 2, degrees, or mm if linear
 * @param e3 external axis 3, degrees, or mm if linear
 * @param e4 external axis 4, degrees, or mm if linear
 * @param e5 external axis 5, degrees, or mm if linear
 * @param e6 external axis 6, degrees, or mm if linear
 */
public record E6Pos(
    double x,
    double y,
    double z,
    double a,
    double b,
    double c,
    int s,
    int t,
    double e1,
    double e2,
    double e3,
    double e4,
    double e5,
    double e6) {

  /** Checks that the numbers are finite; -0 becomes 0. */
  public E6Pos {
    x = Fields.finite("X", x);
    y = Fields.finite("Y", y);
    z = Fields.finite("Z", z);
    a = Fields.finite("A", a);
    b = Fields.finite("B", b);
    c = Fields.finite("C", c);
    e1 = Fields.finite("E1", e1);
    e2 = Fields.finite("E2", e2);
    e3 = Fields.finite("E3", e3);
    e4 = Fields.finite("E4", e4);
    e5 = Fields.finite("E5", e5);
    e6 = Fields.finite("E6", e6);
  }

  /** Returns position and orientation. */
  public Frame frame() {
    return new Frame(x, y, z, a, b, c);
  }

  /** Returns position, orientation, Status and Turn. */
  public Pos pos() {
    return new Pos(x, y, z, a, b, c, s, t);
  }
}
