package no.hials.crosscom.simulator;

import no.hials.crosscom.protocol.value.KrlStruct;

/**
 * The end of a motion.
 *
 * @param position the E6POS of the TCP in the base of the motion, in mm and degrees
 * @param axes the E6AXIS, in degrees; external axes in mm or degrees
 */
public record MotionTarget(KrlStruct position, KrlStruct axes) {}
