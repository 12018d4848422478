/**
 * Devices with which a person moves a robot: axes from -1 to 1, buttons and a dead-man.
 *
 * <p>Reading a device returns its latest state and never blocks. The state has a time stamp, so
 * that the robot stands still if a device sends nothing.
 */
@NullMarked
package no.hials.crosscom.control.input;

import org.jspecify.annotations.NullMarked;
