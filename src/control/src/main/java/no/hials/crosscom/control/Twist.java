package no.hials.crosscom.control;

import no.hials.crosscom.kinematics.Frame;

/**
 * Says how fast a tool moves: the speed of its centre point and the rotation about it, both along
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
  /** Stands still. */
  public static final Twist ZERO = new Twist(0, 0, 0, 0, 0, 0);

  /** Refuses a number that is not finite. */
  public Twist {
    Checks.finite("X", x);
    Checks.finite("Y", y);
    Checks.finite("Z", z);
    Checks.finite("rotation about X", aboutX);
    Checks.finite("rotation about Y", aboutY);
    Checks.finite("rotation about Z", aboutZ);
  }

  /**
   * Makes one without rotation.
   *
   * @param x along X, mm/s
   * @param y along Y, mm/s
   * @param z along Z, mm/s
   * @return the twist
   */
  public static Twist linear(double x, double y, double z) {
    return new Twist(x, y, z, 0, 0, 0);
  }

  /**
   * Finds what leads from one frame to another in a second: straight, and about one axis the
   * shorter way round.
   *
   * @param from where it begins
   * @param to where it ends, in the same coordinate system
   * @return the twist
   */
  public static Twist between(Frame from, Frame to) {
    double[] turn = Rotations.vector(Rotations.leading(from, to));
    return new Twist(
        to.x() - from.x(), to.y() - from.y(), to.z() - from.z(), turn[0], turn[1], turn[2]);
  }

  /**
   * Multiplies the speeds by a number.
   *
   * @param factor the number
   * @return the faster or slower twist
   */
  public Twist times(double factor) {
    return new Twist(
        x * factor, y * factor, z * factor, aboutX * factor, aboutY * factor, aboutZ * factor);
  }

  /**
   * Adds another twist.
   *
   * @param other the other one, about the same axes
   * @return the sum
   */
  public Twist plus(Twist other) {
    return new Twist(
        x + other.x,
        y + other.y,
        z + other.z,
        aboutX + other.aboutX,
        aboutY + other.aboutY,
        aboutZ + other.aboutZ);
  }

  /**
   * Gives the speed of the tool centre point.
   *
   * @return 0 or more, mm/s
   */
  public double speed() {
    return Math.hypot(Math.hypot(x, y), z);
  }

  /**
   * Gives the speed of the rotation.
   *
   * @return 0 or more, degrees/s
   */
  public double rotationSpeed() {
    return Math.hypot(Math.hypot(aboutX, aboutY), aboutZ);
  }

  /**
   * Moves a frame for a time.
   *
   * @param from where it begins
   * @param seconds how long, s
   * @return where it ends: {@code x_a + v * dt}, the rotation as one about a fixed axis
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
