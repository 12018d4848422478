/**
 * The messages that control programs, move the robot and press keys of the pendant.
 *
 * <p>Only C3 Bridge knows them.
 */
@NullMarked
package no.hials.crosscom.protocol.program;

import org.jspecify.annotations.NullMarked;
