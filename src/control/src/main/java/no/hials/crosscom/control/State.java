package no.hials.crosscom.control;

import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.Frame;

/**
 * What a law is told.
 *
 * @param time how long the robot has been under the law, s; the times in which it had to stand
 *     because of the dead-man do not count
 * @param period the loop's period {@code dt}, s
 * @param axes the axes, {@code $AXIS_ACT}: read in this period for a joint law, up to {@link
 *     Safety#checkInterval} old for a Cartesian one
 * @param position the tool in {@code $BASE}, {@code $POS_ACT}: read in this period for a Cartesian
 *     law, up to {@link Safety#checkInterval} old for a joint one
 * @param input what the input device says; {@link Input#NONE} if the loop has none
 */
public record State(double time, double period, Axes axes, Frame position, Input input) {}
