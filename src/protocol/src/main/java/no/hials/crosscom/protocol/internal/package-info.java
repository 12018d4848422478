/**
 * How the fields of each message lie in a frame.
 *
 * <p>{@link no.hials.crosscom.protocol.internal.Layouts} is the way in; each family of messages has
 * a class with the layouts of its messages.
 */
@NullMarked
package no.hials.crosscom.protocol.internal;

import org.jspecify.annotations.NullMarked;
