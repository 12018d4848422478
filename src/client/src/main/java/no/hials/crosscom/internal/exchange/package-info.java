/**
 * Parts of an exchange with a server: its answer and time limit, whether it can be repeated, the
 * loop of the channels. Not for users: it may change at any time.
 */
@NullMarked
package no.hials.crosscom.internal.exchange;

import org.jspecify.annotations.NullMarked;
