package no.hials.crosscom.control;

import no.hials.crosscom.kinematics.Frame;

/**
 * Rotations as frames without a position. All is done with whole rotations, never with A, B and C
 * by themselves, so that neither their wrap at 180 degrees nor B = 90 degrees matters.
 */
final class Rotations {
  private static final Frame X = new Frame(1, 0, 0, 0, 0, 0);
  private static final Frame Y = new Frame(0, 1, 0, 0, 0, 0);
  private static final Frame Z = new Frame(0, 0, 1, 0, 0, 0);

  private Rotations() {}

  /** Gives the rotation about the direction of a vector, which is of no matter at 0 degrees. */
  static Frame about(double x, double y, double z, double degrees) {
    // a frame whose X lies along the vector, in which the rotation is C alone
    double a = Math.toDegrees(Math.atan2(y, x));
    double b = -Math.toDegrees(Math.atan2(z, Math.hypot(x, y)));
    Frame along = new Frame(0, 0, 0, a, b, 0);
    return along.times(new Frame(0, 0, 0, 0, 0, degrees)).times(along.inverse());
  }

  static Frame orientation(Frame frame) {
    return new Frame(0, 0, 0, frame.a(), frame.b(), frame.c());
  }

  /** Turns the orientation of a frame about the axes in which the frame is given. */
  static Frame turned(Frame from, Frame turn) {
    return turn.times(orientation(from));
  }

  /** Gives the rotation about the axes of the base that leads from one orientation to another. */
  static Frame leading(Frame from, Frame to) {
    return orientation(to).times(orientation(from).inverse());
  }

  /** Gives the part of a rotation about its axis, the shorter way round. */
  static Frame part(Frame rotation, double part) {
    return Frame.IDENTITY.interpolate(rotation, part);
  }

  /** Gives a rotation as its axis, as long as the angle in degrees. */
  static double[] vector(Frame rotation) {
    double angle = Frame.IDENTITY.angle(rotation);
    // of the half rotation the antisymmetric part does not vanish at 180 degrees
    Frame half = part(rotation, 0.5);
    Frame x = half.times(X);
    Frame y = half.times(Y);
    Frame z = half.times(Z);
    double[] axis = {y.z() - z.y(), z.x() - x.z(), x.y() - y.x()};
    double length = Math.hypot(Math.hypot(axis[0], axis[1]), axis[2]);
    for (int i = 0; i < axis.length; i++) {
      axis[i] = length == 0 ? 0 : axis[i] / length * angle;
    }
    return axis;
  }
}
