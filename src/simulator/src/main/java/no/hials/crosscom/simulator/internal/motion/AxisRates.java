package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;

/**
 * The speeds and accelerations of the axes in a PTP motion ({@code $VEL_AXIS}, {@code $ACC_AXIS}).
 *
 * @param velocity the part of each axis' highest speed, above 0 to 100 %
 * @param acceleration the part of each axis' highest acceleration, above 0 to 100 %
 */
public record AxisRates(Axis velocity, Axis acceleration) {
  public AxisRates {
    requirePercentages("velocity", velocity);
    requirePercentages("acceleration", acceleration);
  }

  public static AxisRates of(double velocity, double acceleration) {
    return new AxisRates(all(velocity), all(acceleration));
  }

  private static Axis all(double value) {
    return new Axis(value, value, value, value, value, value);
  }

  private static void requirePercentages(String what, Axis percentages) {
    for (double value : percentages.toArray()) {
      if (!(value > 0 && value <= 100)) {
        throw new IllegalArgumentException(
            what + " of an axis must be above 0 to 100 %, is " + value);
      }
    }
  }

  /** Returns the lower of both rates. */
  static AxisRates lower(AxisRates one, AxisRates other) {
    return new AxisRates(
        lower(one.velocity, other.velocity), lower(one.acceleration, other.acceleration));
  }

  private static Axis lower(Axis one, Axis other) {
    double[] six = one.toArray();
    for (int axis = 0; axis < six.length; axis++) {
      six[axis] = Math.min(six[axis], other.get(axis));
    }
    return Axis.of(six);
  }
}
