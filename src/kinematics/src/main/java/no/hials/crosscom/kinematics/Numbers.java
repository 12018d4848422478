package no.hials.crosscom.kinematics;

/** Ranges of angles. */
final class Numbers {

  private Numbers() {}

  /** Returns the same angle in degrees, above -180 and up to 180. */
  static double normalised(double degrees) {
    double angle = Math.IEEEremainder(degrees, 360);
    return angle == -180 ? 180 : angle;
  }

  /** Returns the same angle in degrees, within 180 of another angle. */
  static double near(double degrees, double other) {
    return other + Math.IEEEremainder(degrees - other, 360);
  }
}
