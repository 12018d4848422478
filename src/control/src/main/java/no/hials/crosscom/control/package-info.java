/**
 * Moves a robot from outside, by a variable that a KRL program follows: a {@link
 * no.hials.crosscom.control.ControlLoop} reads where the robot is, asks a {@link
 * no.hials.crosscom.control.Law} and writes the target, once in each period.
 *
 * <p>Every command passes the limits of a {@link no.hials.crosscom.control.Safety} before it is
 * written, and whatever is wrong ends the loop with the robot told to stand; nothing starts again
 * by itself. It is a help against mistakes, no safety function in the sense of a standard.
 */
@NullMarked
package no.hials.crosscom.control;

import org.jspecify.annotations.NullMarked;
