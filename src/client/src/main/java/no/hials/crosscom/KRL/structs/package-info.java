/**
 * Structures of KRL as local copies: FRAME, POS, E6POS, AXIS and E6AXIS, and the base class for
 * others.
 *
 * <p>A structure is read and written whole in one access. Lengths are in mm, angles in degrees.
 */
@NullMarked
package no.hials.crosscom.KRL.structs;

import org.jspecify.annotations.NullMarked;
