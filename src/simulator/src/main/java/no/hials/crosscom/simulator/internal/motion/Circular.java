package no.hials.crosscom.simulator.internal.motion;

import java.util.OptionalDouble;
import no.hials.crosscom.kinematics.Frame;

/**
 * Moves the TCP on the circle through its start, an auxiliary point and a target, as KRL's CIRC.
 *
 * <p>The orientation goes from that at the start to that of the target, whatever the angle; that of
 * the auxiliary point is of no account (assumed for both, and {@code $CIRC_TYPE} is #BASE).
 *
 * @param id the number by which the core knows the motion
 * @param auxiliary a point of the circle, in {@code $ROBROOT}
 * @param target where the TCP ends, or a second point of the circle if there is an angle
 * @param angle how far the TCP goes on the circle (KRL's CA), degrees: in the direction that leads
 *     by the auxiliary point to the target if positive, the other way round if negative, and more
 *     than once round beyond 360; empty to end at the target
 * @param tool the TCP in the flange
 * @param rates how fast the TCP may be
 * @param orientation what the orientation does on the way
 * @param approximation where the blend into the next motion may begin
 */
public record Circular(
    long id,
    Frame auxiliary,
    Frame target,
    OptionalDouble angle,
    Frame tool,
    PathRates rates,
    OrientationControl orientation,
    ApproximationZone approximation)
    implements MotionCommand {
  /** Refuses an angle that is not finite. */
  public Circular {
    if (angle.isPresent() && !Double.isFinite(angle.getAsDouble())) {
      throw new IllegalArgumentException(
          "the circular angle must be finite, is " + angle.getAsDouble());
    }
  }
}
