package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Frame;

/** A point or a direction in space, mm. */
record Point(double x, double y, double z) {
  static Point of(Frame frame) {
    return new Point(frame.x(), frame.y(), frame.z());
  }

  Point plus(Point other) {
    return new Point(x + other.x, y + other.y, z + other.z);
  }

  Point minus(Point other) {
    return new Point(x - other.x, y - other.y, z - other.z);
  }

  Point times(double factor) {
    return new Point(x * factor, y * factor, z * factor);
  }

  double dot(Point other) {
    return x * other.x + y * other.y + z * other.z;
  }

  Point cross(Point other) {
    return new Point(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  double length() {
    return Math.sqrt(dot(this));
  }

  /** Returns a frame at this point with the orientation of another. */
  Frame turnedAs(Frame other) {
    return new Frame(x, y, z, other.a(), other.b(), other.c());
  }
}
