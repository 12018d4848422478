package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link WriteRequest}: {@code id, length, 01, value length, value, tail}.
 *
 * @param id u16, of the request
 * @param value u16 byte count and ISO 8859-1 bytes; the text sent, which the controller may have
 *     stored in another form (docs/reference/wire-format.md#answers)
 * @param tail the end of the answer
 */
public record WriteResponse(int id, String value, Tail tail) implements TypedResponse {
  /** Checks the ranges. */
  public WriteResponse {
    Ranges.u16("id", id);
    Ranges.latin1("value", value);
    Ranges.frame("value", 1 + 2 + value.length() + Tail.LENGTH);
  }

  @Override
  public MessageType type() {
    return MessageType.WRITE;
  }
}
