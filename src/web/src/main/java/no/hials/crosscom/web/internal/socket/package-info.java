/**
 * The WebSocket of a page: commands with their answers, and events. Handlers register by the names
 * of their commands.
 */
@NullMarked
package no.hials.crosscom.web.internal.socket;

import org.jspecify.annotations.NullMarked;
