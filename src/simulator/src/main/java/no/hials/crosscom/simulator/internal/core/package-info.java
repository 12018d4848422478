/**
 * The simulated controller without its network: cycles, modes, messages, programs and the robot.
 * One lock; the only thread is the one that runs the cycles.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.core;

import org.jspecify.annotations.NullMarked;
