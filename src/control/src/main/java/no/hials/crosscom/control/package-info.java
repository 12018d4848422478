/**
 * Moves a robot from outside, by a variable that a KRL program follows: a {@link
 * no.hials.crosscom.control.ControlLoop} reads the position of the robot, calls a {@link
 * no.hials.crosscom.control.Law} and writes the target, once in each period.
 *
 * <p>Every command is checked against the limits of a {@link no.hials.crosscom.control.Safety}
 * before it is written. Any error ends the loop with a command to stand; nothing restarts
 * automatically. The limits help against mistakes; they are not a safety function in the sense of a
 * standard.
 */
@NullMarked
package no.hials.crosscom.control;

import org.jspecify.annotations.NullMarked;
