package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.protocol.value.Axis;

/**
 * The end of the external axes in a motion.
 *
 * @param axes E1 to E6, degrees, or mm if linear
 * @param rates their speeds and accelerations ({@code $VEL_EXTAX}, {@code $ACC_EXTAX})
 */
public record ExternalTarget(Axis axes, AxisRates rates) {
  /** Returns a target at the highest speeds. */
  static ExternalTarget of(Axis axes) {
    return new ExternalTarget(axes, AxisRates.of(100, 100));
  }
}
