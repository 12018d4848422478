package no.hials.crosscom.control;

import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/**
 * The state of the robot for a law.
 *
 * @param time the time for which the law has moved the robot, s, without the times in which it
 *     stood still without the dead-man
 * @param period the loop's period {@code dt}, s
 * @param axes the axes, {@code $AXIS_ACT}: read in this period for a joint law, up to {@link
 *     Safety#checkInterval} old for a Cartesian law
 * @param position the tool in {@code $BASE}, {@code $POS_ACT}: read in this period for a Cartesian
 *     law, up to {@link Safety#checkInterval} old for a joint law
 * @param incrementFactor the factor by which the loop shortens the increments of a velocity law,
 *     because of the override, 0 to 1; 1 if it does not
 * @param input the state of the input device; {@link Input#NONE} without a device
 */
public record State(
    double time, double period, Axis axes, Frame position, double incrementFactor, Input input) {}
