/**
 * The codes and flags in the messages of C3 Bridge, with names for the numbers that the reference
 * has.
 *
 * <p>A number that it has not is kept: {@link no.hials.crosscom.protocol.code.Code} and {@link
 * no.hials.crosscom.protocol.code.Flags} hold what was on the wire and give constants where they
 * can.
 */
@NullMarked
package no.hials.crosscom.protocol.code;

import org.jspecify.annotations.NullMarked;
