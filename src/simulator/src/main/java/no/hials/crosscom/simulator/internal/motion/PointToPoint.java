package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;

/**
 * Moves all axes so that they start and end together, as KRL's PTP; the slowest sets the time.
 *
 * @param id the number of the motion
 * @param target the end of the axes, degrees
 * @param rates the speeds of the axes
 * @param tool the TCP in the flange
 * @param approximation where the blend into the next motion can start
 */
public record PointToPoint(
    long id, Axes target, AxisRates rates, Frame tool, ApproximationZone approximation)
    implements MotionCommand {}
