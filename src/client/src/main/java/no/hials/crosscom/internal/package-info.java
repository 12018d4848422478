/**
 * The joints between the public packages of the client. Not for users: it may change at any time.
 *
 * <p>{@link no.hials.crosscom.internal.VariableAccess} lets the client reach what a variable hides
 * from programs.
 */
@NullMarked
package no.hials.crosscom.internal;

import org.jspecify.annotations.NullMarked;
