package no.hials.crosscom.kinematics;

/**
 * The pose of a coordinate system in another coordinate system, like KRL's type FRAME: a position,
 * and an orientation as three rotations, each about an axis that the previous rotation has turned
 * (docs/reference/kinematics.md#orientation).
 *
 * <p>The constructor keeps its angles. Methods return A and C above -180 and up to 180 and B from
 * -90 to 90; at B = ±90, where A and C turn about the same axis, they return C = 0.
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

  /** Checks that the numbers are finite. */
  public Frame {
    Numbers.finite("X", x);
    Numbers.finite("Y", y);
    Numbers.finite("Z", z);
    Numbers.finite("A", a);
    Numbers.finite("B", b);
    Numbers.finite("C", c);
  }

  /**
   * Transforms a frame in this coordinate system to the reference of this frame: KRL's geometric
   * operator, {@code this:right}.
   *
   * @param right a frame in this coordinate system
   * @return the same pose in the reference of this frame
   */
  public Frame times(Frame right) {
    return Transform.of(this).times(Transform.of(right)).toFrame();
  }

  /**
   * Returns the inverse: the reference of this frame in this coordinate system.
   *
   * @return the frame whose product with this frame is {@link #IDENTITY}, on either side
   */
  public Frame inverse() {
    return Transform.of(this).inverse().toFrame();
  }

  /**
   * Interpolates to another frame: the position on a straight line, the orientation about one fixed
   * axis in the shorter direction. For orientations 180 degrees apart the direction is arbitrary
   * but always the same.
   *
   * @param to the frame for {@code s = 1}
   * @param s 0 for this frame to 1 for {@code to}
   */
  public Frame interpolate(Frame to, double s) {
    // The negation also refuses NaN.
    if (!(s >= 0 && s <= 1)) {
      throw new IllegalArgumentException("s must be 0 to 1, is " + s);
    }
    Transform from = Transform.of(this);
    Transform end = Transform.of(to);
    Rotation way = from.rotation().inverse().times(end.rotation());
    return new Transform(
            from.position().times(1 - s).plus(end.position().times(s)),
            from.rotation().times(way.part(s)))
        .toFrame();
  }

  /**
   * Returns the distance to the position of another frame.
   *
   * @param other the other frame, with the same reference
   * @return the distance, mm
   */
  public double distance(Frame other) {
    return new Vector(x - other.x, y - other.y, z - other.z).length();
  }

  /**
   * Returns the angle to the orientation of another frame.
   *
   * @param other the other frame, with the same reference
   * @return the angle of the rotation from this orientation to the other, 0 to 180 degrees
   */
  public double angle(Frame other) {
    return Transform.of(this).rotation().inverse().times(Transform.of(other).rotation()).angle();
  }
}
