/**
 * What a person moves a robot with: devices that give axes from -1 to 1, buttons and a dead-man.
 *
 * <p>A device is asked for what it says now and never blocks; how old that is says its time stamp,
 * so that a device that has gone silent lets the robot stand.
 */
@NullMarked
package no.hials.crosscom.control.input;

import org.jspecify.annotations.NullMarked;
