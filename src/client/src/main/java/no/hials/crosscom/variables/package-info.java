/**
 * The values of the original's version 0.1, made from the text of an answer without knowing its
 * type.
 *
 * <p>Kept for its programs; {@link no.hials.crosscom.KRL} has what new programs use.
 */
@NullMarked
package no.hials.crosscom.variables;

import org.jspecify.annotations.NullMarked;
