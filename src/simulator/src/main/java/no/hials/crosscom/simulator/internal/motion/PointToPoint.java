package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;

/**
 * Moves all axes so that they start and end together, as KRL's PTP; the slowest sets the time.
 *
 * @param id the number by which the core knows the motion
 * @param target where the axes end, degrees
 * @param rates how fast the axes may be
 * @param tool the TCP in the flange
 * @param approximation where the blend into the next motion may begin
 */
public record PointToPoint(
    long id, Axes target, AxisRates rates, Frame tool, ApproximationZone approximation)
    implements MotionCommand {}
