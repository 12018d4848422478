/**
 * The simulated controller behind the network: cycles, modes, messages, programs and the robot. One
 * lock, no thread of its own but the one that lets time pass.
 */
@NullMarked
package no.hials.crosscom.simulator.internal.core;

import org.jspecify.annotations.NullMarked;
