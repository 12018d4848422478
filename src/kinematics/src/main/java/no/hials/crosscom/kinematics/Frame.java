package no.hials.crosscom.kinematics;

/**
 * Says where a coordinate system lies in another one, as KRL's type FRAME (krl.md 3): a position,
 * and an orientation made of three rotations, each about an axis that the one before has turned.
 *
 * <p>A frame keeps the angles that it is given. Those that a method returns have A and C above -180
 * and up to 180, B from -90 to 90, and at B = ±90, where A and C turn about the same axis, C = 0.
 *
 * @param x the position along X, mm
 * @param y the position along Y, mm
 * @param z the position along Z, mm
 * @param a the rotation about Z, degrees
 * @param b the rotation about the new Y, degrees
 * @param c the rotation about the new X, degrees
 */
public record Frame(double x, double y, double z, double a, double b, double c) {
  /** Lies where the other coordinate system lies ({@code $NULLFRAME}). */
  public static final Frame IDENTITY = new Frame(0, 0, 0, 0, 0, 0);

  /** Refuses a number that is not finite. */
  public Frame {
    Numbers.finite("X", x);
    Numbers.finite("Y", y);
    Numbers.finite("Z", z);
    Numbers.finite("A", a);
    Numbers.finite("B", b);
    Numbers.finite("C", c);
  }

  /**
   * Takes a frame that is given in this one to the coordinate system in which this one is given:
   * KRL's geometric operator, {@code this:right}.
   *
   * @param right a frame in this one
   * @return the same in the coordinate system of this one
   */
  public Frame times(Frame right) {
    return Transform.of(this).times(Transform.of(right)).toFrame();
  }

  /**
   * Says where the other coordinate system lies in this one.
   *
   * @return the frame with which this one makes {@link #IDENTITY}, from either side
   */
  public Frame inverse() {
    return Transform.of(this).inverse().toFrame();
  }

  /**
   * Goes part of the way to another frame: the position on the straight line, the orientation about
   * one fixed axis and the shorter way round. Between opposite orientations (180 degrees) both ways
   * are as short; one of them is taken, always the same.
   *
   * @param to the frame at the end of the way
   * @param s the part of the way, 0 (here) to 1 (there)
   * @return the frame on the way
   */
  public Frame interpolate(Frame to, double s) {
    // The negation refuses NaN as well.
    if (!(s >= 0 && s <= 1)) {
      throw new IllegalArgumentException("the part of the way must be 0 to 1, is " + s);
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
   * Measures how far apart the positions of two frames are.
   *
   * @param other the other frame, in the same coordinate system
   * @return the distance, mm
   */
  public double distance(Frame other) {
    return new Vector(x - other.x, y - other.y, z - other.z).length();
  }

  /**
   * Measures how far apart the orientations of two frames are.
   *
   * @param other the other frame, in the same coordinate system
   * @return the angle of the one rotation that leads from this to the other, 0 to 180 degrees
   */
  public double angle(Frame other) {
    return Transform.of(this).rotation().inverse().times(Transform.of(other).rotation()).angle();
  }
}
