package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Frame;

/**
 * Moves the TCP on a straight line, as KRL's LIN.
 *
 * @param id the number by which the core knows the motion
 * @param target where the TCP ends, in {@code $ROBROOT}
 * @param tool the TCP in the flange
 * @param rates how fast the TCP may be
 * @param orientation what the orientation does on the way
 * @param approximation where the blend into the next motion may begin
 */
public record Linear(
    long id,
    Frame target,
    Frame tool,
    PathRates rates,
    OrientationControl orientation,
    ApproximationZone approximation)
    implements MotionCommand {}
