package no.hials.crosscom.kinematics;

/** A point in space, mm, or a direction. */
record Vector(double x, double y, double z) {
  static final Vector ZERO = new Vector(0, 0, 0);
  static final Vector Y = new Vector(0, 1, 0);
  static final Vector Z = new Vector(0, 0, 1);

  Vector plus(Vector other) {
    return new Vector(x + other.x, y + other.y, z + other.z);
  }

  Vector minus(Vector other) {
    return new Vector(x - other.x, y - other.y, z - other.z);
  }

  Vector times(double factor) {
    return new Vector(x * factor, y * factor, z * factor);
  }

  Vector cross(Vector other) {
    return new Vector(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  double length() {
    return Math.hypot(Math.hypot(x, y), z);
  }
}
