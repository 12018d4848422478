/**
 * The codec for the messages of KUKAVARPROXY and C3 Bridge, used by the client and the mock server.
 *
 * <p>A message is a record under {@link no.hials.crosscom.protocol.Request} or {@link
 * no.hials.crosscom.protocol.Response}, in the package of its family. To add a message type, add a
 * constant to {@link no.hials.crosscom.protocol.MessageType} and its layouts to {@code
 * protocol.internal}.
 */
@NullMarked
package no.hials.crosscom.protocol;

import org.jspecify.annotations.NullMarked;
