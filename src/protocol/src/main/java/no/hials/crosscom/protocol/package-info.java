/**
 * The messages of KUKAVARPROXY and C3 Bridge and the one codec for them, used by the client and the
 * mock server.
 *
 * <p>A message is a record under {@link no.hials.crosscom.protocol.Request} or {@link
 * no.hials.crosscom.protocol.Response}; {@link no.hials.crosscom.protocol.Codec} turns it into
 * bytes and back. A new message type is a constant of {@link
 * no.hials.crosscom.protocol.MessageType} with the two layouts of its own; the others stay as they
 * are.
 */
@NullMarked
package no.hials.crosscom.protocol;

import org.jspecify.annotations.NullMarked;
