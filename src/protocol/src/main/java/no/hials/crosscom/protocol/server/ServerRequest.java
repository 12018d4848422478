package no.hials.crosscom.protocol.server;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks for information or for features, or to confirm all messages (types 13, 14 and 63). Has no
 * fields.
 *
 * @param id u16, echoed in the answer
 * @param type u8; {@link MessageType#INFORMATION}, {@link MessageType#FEATURES} or {@link
 *     MessageType#CONFIRM_ALL}
 */
public record ServerRequest(int id, MessageType type) implements Request {
  /** Checks the ranges. */
  public ServerRequest {
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.INFORMATION, MessageType.FEATURES, MessageType.CONFIRM_ALL);
  }
}
