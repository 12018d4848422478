package no.hials.crosscom.kinematics;

import no.hials.crosscom.protocol.value.Frame;

/** A {@link Frame} as a vector and a quaternion, for computing. */
record Transform(Vector position, Rotation rotation) {
  static final Transform IDENTITY = new Transform(Vector.ZERO, Rotation.NONE);

  /**
   * This close to B = ±90 (cosine of B), A and C are one angle. More than the rounding errors of
   * products of rotations, and far below the resolution of a REAL.
   */
  private static final double GIMBAL_LOCK = 1e-9;

  static Transform of(Frame frame) {
    Rotation rotation =
        Rotation.aboutZ(frame.a())
            .times(Rotation.aboutY(frame.b()))
            .times(Rotation.aboutX(frame.c()));
    return new Transform(new Vector(frame.x(), frame.y(), frame.z()), rotation);
  }

  Transform times(Transform right) {
    return new Transform(
        position.plus(rotation.rotate(right.position)), rotation.times(right.rotation));
  }

  Transform inverse() {
    Rotation back = rotation.inverse();
    return new Transform(back.rotate(position).times(-1), back);
  }

  Transform translate(double x, double y, double z) {
    return new Transform(position.plus(rotation.rotate(new Vector(x, y, z))), rotation);
  }

  Transform rotateY(double degrees) {
    return new Transform(position, rotation.times(Rotation.aboutY(degrees)));
  }

  Transform rotateZ(double degrees) {
    return new Transform(position, rotation.times(Rotation.aboutZ(degrees)));
  }

  /** Extracts A, B and C from the matrix of the quaternion. */
  Frame toFrame() {
    double w = rotation.w();
    double x = rotation.x();
    double y = rotation.y();
    double z = rotation.z();
    double r11 = 1 - 2 * (y * y + z * z);
    double r21 = 2 * (x * y + w * z);
    double sineOfB = 2 * (w * y - x * z);
    double cosineOfB = Math.hypot(r11, r21);
    if (cosineOfB < GIMBAL_LOCK) {
      // The choice of KSS between A and C is not known. C = 0 is assumed: at home with A1 turned, A
      // then shows the angle of A1.
      double r12 = 2 * (x * y - w * z);
      double r22 = 1 - 2 * (x * x + z * z);
      return frame(Math.atan2(-r12, r22), Math.copySign(Math.PI / 2, sineOfB), 0);
    }
    double r32 = 2 * (y * z + w * x);
    double r33 = 1 - 2 * (x * x + y * y);
    return frame(Math.atan2(r21, r11), Math.atan2(sineOfB, cosineOfB), Math.atan2(r32, r33));
  }

  /** Creates a frame from angles in radians. */
  private Frame frame(double a, double b, double c) {
    return new Frame(
        position.x(),
        position.y(),
        position.z(),
        Numbers.normalised(Math.toDegrees(a)),
        Numbers.normalised(Math.toDegrees(b)),
        Numbers.normalised(Math.toDegrees(c)));
  }
}
