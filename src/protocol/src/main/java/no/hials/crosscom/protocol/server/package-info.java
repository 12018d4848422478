/**
 * The messages about the server itself: its version, clock and features.
 *
 * <p>Only C3 Bridge knows them; their requests have no fields.
 */
@NullMarked
package no.hials.crosscom.protocol.server;

import org.jspecify.annotations.NullMarked;
