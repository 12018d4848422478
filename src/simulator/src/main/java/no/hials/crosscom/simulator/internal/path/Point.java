package no.hials.crosscom.simulator.internal.path;

import no.hials.crosscom.protocol.value.Frame;

/** A point or a direction in space, mm. */
public record Point(double x, double y, double z) {
  public static Point of(Frame frame) {
    return new Point(frame.x(), frame.y(), frame.z());
  }

  public Point plus(Point other) {
    return new Point(x + other.x, y + other.y, z + other.z);
  }

  public Point minus(Point other) {
    return new Point(x - other.x, y - other.y, z - other.z);
  }

  public Point times(double factor) {
    return new Point(x * factor, y * factor, z * factor);
  }

  public double dot(Point other) {
    return x * other.x + y * other.y + z * other.z;
  }

  public Point cross(Point other) {
    return new Point(
        y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
  }

  public double length() {
    return Math.sqrt(dot(this));
  }

  /** Returns a frame at this point with the orientation of another. */
  public Frame turnedAs(Frame other) {
    return new Frame(x, y, z, other.a(), other.b(), other.c());
  }
}
