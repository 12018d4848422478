/** The command that drives the robot with an input device. */
@NullMarked
package no.hials.crosscom.cli.drive;

import org.jspecify.annotations.NullMarked;
