package no.hials.crosscom.control;

import no.hials.crosscom.protocol.value.Frame;

/**
 * The velocity of a tool: the linear velocity of its centre point and the angular velocity, along
 * and about the axes of the base.
 *
 * @param x along X, mm/s
 * @param y along Y, mm/s
 * @param z along Z, mm/s
 * @param aboutX about X, degrees/s
 * @param aboutY about Y, degrees/s
 * @param aboutZ about Z, degrees/s
 */
public record Twist(double x, double y, double z, double aboutX, double aboutY, double aboutZ) {
  /** No motion. */
  public static final Twist ZERO = new Twist(0, 0, 0, 0, 0, 0);

  /** Checks that the numbers are finite. */
  public Twist {
    Checks.finite("X", x);
    Checks.finite("Y", y);
    Checks.finite("Z", z);
    Checks.finite("rotation about X", aboutX);
    Checks.finite("rotation about Y", aboutY);
    Checks.finite("rotation about Z", aboutZ);
  }

  /**
   * Returns a twist without rotation.
   *
   * @param x along X, mm/s
   * @param y along Y, mm/s
   * @param z along Z, mm/s
   */
  public static Twist linear(double x, double y, double z) {
    return new Twist(x, y, z, 0, 0, 0);
  }

  /**
   * Returns the twist that moves a frame to another frame in one second: on a straight line, and
   * about one axis in the shorter direction.
   *
   * @param from the first frame
   * @param to the second frame, with the same reference
   */
  public static Twist between(Frame from, Frame to) {
    double[] turn = Rotations.vector(Rotations.leading(from, to));
    return new Twist(
        to.x() - from.x(), to.y() - from.y(), to.z() - from.z(), turn[0], turn[1], turn[2]);
  }

  /** Returns this twist multiplied by a number. */
  public Twist times(double factor) {
    return new Twist(
        x * factor, y * factor, z * factor, aboutX * factor, aboutY * factor, aboutZ * factor);
  }

  /** Returns the sum of two twists about the same axes. */
  public Twist plus(Twist other) {
    return new Twist(
        x + other.x,
        y + other.y,
        z + other.z,
        aboutX + other.aboutX,
        aboutY + other.aboutY,
        aboutZ + other.aboutZ);
  }

  /** Returns the speed of the tool centre point, mm/s. */
  public double speed() {
    return Math.hypot(Math.hypot(x, y), z);
  }

  /** Returns the speed of the rotation, degrees/s. */
  public double rotationSpeed() {
    return Math.hypot(Math.hypot(aboutX, aboutY), aboutZ);
  }

  /**
   * Moves a frame with this velocity for a time.
   *
   * @param from the frame at the start
   * @param seconds the time, s
   * @return the frame at the end: {@code x_a + v * dt}, with the rotation about a fixed axis
   */
  public Frame move(Frame from, double seconds) {
    Frame turned =
        Rotations.turned(from, Rotations.about(aboutX, aboutY, aboutZ, rotationSpeed() * seconds));
    return new Frame(
        from.x() + x * seconds,
        from.y() + y * seconds,
        from.z() + z * seconds,
        turned.a(),
        turned.b(),
        turned.c());
  }
}
