/**
 * The messages that control programs, move the robot and press keys of the pendant.
 *
 * <p>Only C3 Bridge supports them (docs/reference/c3-messages.md#program-control-10).
 */
@NullMarked
package no.hials.crosscom.protocol.program;

import org.jspecify.annotations.NullMarked;
