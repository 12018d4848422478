package no.hials.crosscom.protocol.value;

/**
 * The pose of a coordinate system in another coordinate system, like KRL's type FRAME: a position,
 * and an orientation as three rotations, each about an axis that the previous rotation has turned
 * (docs/reference/kinematics.md#orientation).
 *
 * @param x the position along X, mm
 * @param y the position along Y, mm
 * @param z the position along Z, mm
 * @param a the rotation about Z, degrees
 * @param b the rotation about the new Y, degrees
 * @param c the rotation about the new X, degrees
 */
public record Frame(double x, double y, double z, double a, double b, double c) {
  /** The identity ({@code $NULLFRAME}). */
  public static final Frame IDENTITY = new Frame(0, 0, 0, 0, 0, 0);

  /** Checks that the numbers are finite; -0 becomes 0. */
  public Frame {
    x = Fields.finite("X", x);
    y = Fields.finite("Y", y);
    z = Fields.finite("Z", z);
    a = Fields.finite("A", a);
    b = Fields.finite("B", b);
    c = Fields.finite("C", c);
  }

  /**
   * Returns the distance to the position of another frame.
   *
   * @param other the other frame, with the same reference
   * @return the distance, mm
   */
  public double distance(Frame other) {
    return Math.hypot(Math.hypot(x - other.x, y - other.y), z - other.z);
  }
}
