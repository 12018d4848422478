/**
 * The implementations of the interfaces in {@code no.hials.crosscom.c3}, and the transfers of
 * files. Not for users: it may change at any time.
 */
@NullMarked
package no.hials.crosscom.internal.c3;

import org.jspecify.annotations.NullMarked;
