package no.hials.crosscom.kinematics;

/**
 * A rotation as a unit quaternion, which keeps interpolation and wrist angles exact near every
 * singularity.
 */
record Rotation(double w, double x, double y, double z) {
  static final Rotation NONE = new Rotation(1, 0, 0, 0);

  static Rotation aboutX(double degrees) {
    double half = Math.toRadians(degrees) / 2;
    return new Rotation(Math.cos(half), Math.sin(half), 0, 0);
  }

  static Rotation aboutY(double degrees) {
    double half = Math.toRadians(degrees) / 2;
    return new Rotation(Math.cos(half), 0, Math.sin(half), 0);
  }

  static Rotation aboutZ(double degrees) {
    double half = Math.toRadians(degrees) / 2;
    return new Rotation(Math.cos(half), 0, 0, Math.sin(half));
  }

  /** Returns the rotation about an axis by its length in degrees. */
  static Rotation about(Vector axis) {
    double angle = axis.length();
    double half = Math.toRadians(angle) / 2;
    double scale = angle == 0 ? 0 : Math.sin(half) / angle;
    return new Rotation(Math.cos(half), axis.x() * scale, axis.y() * scale, axis.z() * scale);
  }

  /** Returns the axis in the shorter direction, with the length 1; 0 if it is not a rotation. */
  Vector axis() {
    double sine = sineOfHalf();
    return sine == 0 ? new Vector(0, 0, 0) : new Vector(x, y, z).times(Math.copySign(1 / sine, w));
  }

  Rotation times(Rotation right) {
    return new Rotation(
        w * right.w - x * right.x - y * right.y - z * right.z,
        w * right.x + x * right.w + y * right.z - z * right.y,
        w * right.y - x * right.z + y * right.w + z * right.x,
        w * right.z + x * right.y - y * right.x + z * right.w);
  }

  Rotation inverse() {
    return new Rotation(w, -x, -y, -z);
  }

  Vector rotate(Vector v) {
    Vector axis = new Vector(x, y, z);
    Vector twice = axis.cross(v).times(2);
    return v.plus(twice.times(w)).plus(axis.cross(twice));
  }

  /** Returns the angle of the rotation, 0 to 180 degrees. */
  double angle() {
    return Math.toDegrees(2 * Math.atan2(sineOfHalf(), Math.abs(w)));
  }

  /** Returns a rotation about the same axis by a part of the angle, in the shorter direction. */
  Rotation part(double s) {
    double sine = sineOfHalf();
    if (sine == 0) {
      return NONE;
    }
    double half = s * Math.atan2(sine, Math.abs(w));
    double scale = Math.copySign(Math.sin(half) / sine, w);
    return new Rotation(Math.cos(half), x * scale, y * scale, z * scale);
  }

  private double sineOfHalf() {
    return new Vector(x, y, z).length();
  }
}
