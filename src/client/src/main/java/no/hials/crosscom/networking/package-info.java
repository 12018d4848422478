/**
 * The package of version 0.1 of the original, as thin adapters.
 *
 * <p>Kept for its programs; new programs use {@link no.hials.crosscom.CrossComClient}.
 */
@NullMarked
package no.hials.crosscom.networking;

import org.jspecify.annotations.NullMarked;
