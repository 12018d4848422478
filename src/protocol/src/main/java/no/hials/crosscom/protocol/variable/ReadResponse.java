package no.hials.crosscom.protocol.variable;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link ReadRequest}: {@code id, length, 00, value length, value, tail}.
 *
 * @param id u16, of the request
 * @param value u16 byte count and ISO 8859-1 bytes; 65,529 at most. Empty if the access failed,
 *     which some servers report with a success tail
 *     (docs/reference/kukavarproxy.md#refused-accesses)
 * @param tail the end of the answer
 */
public record ReadResponse(int id, String value, Tail tail) implements TypedResponse {
  /** Checks the ranges. */
  public ReadResponse {
    Ranges.u16("id", id);
    Ranges.latin1("value", value);
    Ranges.frame("value", 1 + 2 + value.length() + Tail.LENGTH);
  }

  @Override
  public MessageType type() {
    return MessageType.READ;
  }
}
