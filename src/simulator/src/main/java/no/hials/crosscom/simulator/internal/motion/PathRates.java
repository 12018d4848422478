package no.hials.crosscom.simulator.internal.motion;

/**
 * The speeds and accelerations of the TCP on a LIN or CIRC ({@code $VEL}, {@code $ACC}).
 *
 * @param velocity the speed of the TCP, m/s
 * @param acceleration the acceleration of the TCP along the path, m/s²
 * @param turnVelocity the speed of the orientation, degrees/s
 * @param turnAcceleration the acceleration of the orientation, degrees/s²
 */
public record PathRates(
    double velocity, double acceleration, double turnVelocity, double turnAcceleration) {
  public PathRates {
    requireRate("velocity", velocity);
    requireRate("acceleration", acceleration);
    requireRate("turn velocity", turnVelocity);
    requireRate("turn acceleration", turnAcceleration);
  }

  private static void requireRate(String what, double value) {
    if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(what + " must be above 0 and finite, is " + value);
    }
  }

  /** Returns the lower of both rates. */
  static PathRates lower(PathRates one, PathRates other) {
    return new PathRates(
        Math.min(one.velocity, other.velocity),
        Math.min(one.acceleration, other.acceleration),
        Math.min(one.turnVelocity, other.turnVelocity),
        Math.min(one.turnAcceleration, other.turnAcceleration));
  }
}
