/**
 * Types that the public packages of the client share. Not for users: it may change at any time.
 *
 * <p>{@link no.hials.crosscom.internal.VariableAccess} lets the client use methods that a variable
 * hides from programs.
 */
@NullMarked
package no.hials.crosscom.internal;

import org.jspecify.annotations.NullMarked;
