package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link PendantKeyRequest} (type 12): {@code key}.
 *
 * @param id u16, of the request
 * @param key u8, of the request, known or not
 * @param tail the end of the answer
 */
public record PendantKeyResponse(int id, Code<PendantKey> key, Tail tail) implements TypedResponse {
  /** Checks the ranges. */
  public PendantKeyResponse {
    Ranges.u16("id", id);
    Ranges.u8("key", key.number());
  }

  @Override
  public MessageType type() {
    return MessageType.PENDANT_KEY;
  }
}
