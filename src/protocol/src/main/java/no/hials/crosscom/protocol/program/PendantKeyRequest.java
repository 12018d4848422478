package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to press or release a key of the pendant (type 12): {@code key, number, keyCode, direction,
 * released}.
 *
 * @param id u16, echoed in the answer
 * @param key u8
 * @param number i32; the interpreter, or the number of the axis for {@link PendantKey#JOG}
 * @param keyCode i32; 2 in the one example, a jog
 * @param direction u8, 0 or 1; 0 for a start forward, 1 for a jog in plus direction
 *     (docs/reference/c3-messages.md#pendant-keys-12)
 * @param released u8, 0 for pressed or 1 for released
 */
public record PendantKeyRequest(
    int id, Code<PendantKey> key, int number, int keyCode, boolean direction, boolean released)
    implements ProgramRequest {
  /** Checks the ranges. */
  public PendantKeyRequest {
    Ranges.u16("id", id);
    Ranges.u8("key", key.number());
  }
}
