/**
 * The motion of the simulated robot, as the main run executes the motions that a program plans.
 *
 * <p>The core calls only {@link no.hials.crosscom.simulator.internal.motion.Interpolator}; it has
 * no clock and no thread, and each call of its cycle stands for 12 ms. A motion is planned when it
 * is added (path, limits, profile of speed) and then executed, so override, holds and brakes change
 * the time of the robot's positions, never the positions.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.motion;

import org.jspecify.annotations.NullMarked;
