/**
 * Structures of KRL as local copies: FRAME, POS, E6POS, AXIS and E6AXIS, and the base class for
 * others.
 *
 * <p>One access reads or writes a whole structure. Lengths are in mm, angles in degrees.
 */
@NullMarked
package no.hials.crosscom.KRL.structs;

import org.jspecify.annotations.NullMarked;
