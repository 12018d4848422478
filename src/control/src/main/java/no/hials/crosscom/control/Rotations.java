package no.hials.crosscom.control;

import static no.hials.crosscom.kinematics.Frames.angle;
import static no.hials.crosscom.kinematics.Frames.interpolate;
import static no.hials.crosscom.kinematics.Frames.inverse;
import static no.hials.crosscom.kinematics.Frames.product;

import no.hials.crosscom.protocol.value.Frame;

/**
 * Rotations as frames without a position. All methods use whole rotations, never A, B and C alone,
 * so neither their wrap at 180 degrees nor B = 90 degrees matters.
 */
final class Rotations {
  private static final Frame X = new Frame(1, 0, 0, 0, 0, 0);
  private static final Frame Y = new Frame(0, 1, 0, 0, 0, 0);
  private static final Frame Z = new Frame(0, 0, 1, 0, 0, 0);

  private Rotations() {}

  /**
   * Returns the rotation about the direction of a vector; the direction is irrelevant at 0 degrees.
   */
  static Frame about(double x, double y, double z, double degrees) {
    // in a frame with X along the vector, the rotation is C alone
    double a = Math.toDegrees(Math.atan2(y, x));
    double b = -Math.toDegrees(Math.atan2(z, Math.hypot(x, y)));
    Frame along = new Frame(0, 0, 0, a, b, 0);
    return product(along, new Frame(0, 0, 0, 0, 0, degrees), inverse(along));
  }

  static Frame orientation(Frame frame) {
    return new Frame(0, 0, 0, frame.a(), frame.b(), frame.c());
  }

  /** Turns the orientation of a frame about the axes of its reference. */
  static Frame turned(Frame from, Frame turn) {
    return product(turn, orientation(from));
  }

  /** Returns the rotation about the axes of the base from one orientation to another. */
  static Frame leading(Frame from, Frame to) {
    return product(orientation(to), inverse(orientation(from)));
  }

  /** Returns a part of a rotation about its axis, in the shorter direction. */
  static Frame part(Frame rotation, double part) {
    return interpolate(Frame.IDENTITY, rotation, part);
  }

  /** Returns the rotation vector: the axis, with the angle in degrees as its length. */
  static double[] vector(Frame rotation) {
    double angle = angle(Frame.IDENTITY, rotation);
    // the antisymmetric part of the half rotation does not vanish at 180 degrees
    Frame half = part(rotation, 0.5);
    Frame x = product(half, X);
    Frame y = product(half, Y);
    Frame z = product(half, Z);
    double[] axis = {y.z() - z.y(), z.x() - x.z(), x.y() - y.x()};
    double length = Math.hypot(Math.hypot(axis[0], axis[1]), axis[2]);
    for (int i = 0; i < axis.length; i++) {
      axis[i] = length == 0 ? 0 : axis[i] / length * angle;
    }
    return axis;
  }
}
