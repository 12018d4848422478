/**
 * The messages about the server itself: its version, clock and features.
 *
 * <p>Only C3 Bridge supports them; their requests have no fields
 * (docs/reference/c3-messages.md#information-features-and-confirm-all-13-14-and-63).
 */
@NullMarked
package no.hials.crosscom.protocol.server;

import org.jspecify.annotations.NullMarked;
