package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link ReadRequest}, {@link WriteRequest} and {@link WriteArrayRequest}: {@code id,
 * length, type, value length, value, tail}.
 *
 * @param id u16, of the request
 * @param type u8; {@link MessageType#READ}, {@link MessageType#WRITE} or {@link
 *     MessageType#WRITE_ARRAY}
 * @param value u16 byte count and ISO 8859-1 bytes; 65,529 at most. The value read, or empty if the
 *     read failed, which some servers report with a success tail
 *     (docs/reference/kukavarproxy.md#refused-accesses). Of a write the text sent, which the
 *     controller may have stored in another form (docs/reference/wire-format.md#answers); of an
 *     array empty
 * @param tail the end of the answer
 */
public record ValueResponse(int id, MessageType type, String value, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public ValueResponse {
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.READ, MessageType.WRITE, MessageType.WRITE_ARRAY);
    Ranges.latin1("value", value);
    Ranges.frame("value", 1 + 2 + value.length() + Tail.LENGTH);
  }
}
