/**
 * The motion of the simulated robot: what a main run makes of the motions that a program plans.
 *
 * <p>{@link no.hials.crosscom.simulator.internal.motion.Interpolator} is all that the core calls;
 * it has no clock and no thread, and each call of its cycle stands for 12 ms. A motion is planned
 * when it is added (path, limits, profile of speed) and only then run through, so that override,
 * holds and brakes change when the robot is somewhere, and never where.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.motion;

import org.jspecify.annotations.NullMarked;
