/**
 * The values of version 0.1 of the original, parsed from the text of an answer of unknown type.
 *
 * <p>Kept for its programs; new programs use {@link no.hials.crosscom.KRL}.
 */
@NullMarked
package no.hials.crosscom.variables;

import org.jspecify.annotations.NullMarked;
