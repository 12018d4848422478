/**
 * The layout of the fields of each message in a frame.
 *
 * <p>{@link no.hials.crosscom.protocol.internal.Layouts} is the entry point; each family of
 * messages has a class with the layouts of its messages.
 */
@NullMarked
package no.hials.crosscom.protocol.internal;

import org.jspecify.annotations.NullMarked;
