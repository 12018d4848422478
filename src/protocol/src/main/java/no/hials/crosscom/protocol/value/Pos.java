package no.hials.crosscom.protocol.value;

/**
 * A position of the tool with the configuration of the robot, like KRL's type POS.
 *
 * @param x the position along X, mm
 * @param y the position along Y, mm
 * @param z the position along Z, mm
 * @param a the rotation about Z, degrees
 * @param b the rotation about the new Y, degrees
 * @param c the rotation about the new X, degrees
 * @param s Status (docs/reference/kinematics.md#status-and-turn)
 * @param t Turn
 */
public record Pos(double x, double y, double z, double a, double b, double c, int s, int t) {

  /** Checks that the numbers are finite; -0 becomes 0. */
  public Pos {
    x = Fields.finite("X", x);
    y = Fields.finite("Y", y);
    z = Fields.finite("Z", z);
    a = Fields.finite("A", a);
    b = Fields.finite("B", b);
    c = Fields.finite("C", c);
  }

  /** Returns position and orientation. */
  public Frame frame() {
    return new Frame(x, y, z, a, b, c);
  }
}
