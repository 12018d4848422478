package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Frame;

/**
 * Moves the TCP on a straight line, as KRL's LIN.
 *
 * @param id the number of the motion
 * @param target the end of the TCP, in {@code $ROBROOT}
 * @param tool the TCP in the flange
 * @param rates the speed of the TCP
 * @param orientation the orientation on the path
 * @param approximation where the blend into the next motion can start
 */
public record Linear(
    long id,
    Frame target,
    Frame tool,
    PathRates rates,
    OrientationControl orientation,
    ApproximationZone approximation)
    implements MotionCommand {}
