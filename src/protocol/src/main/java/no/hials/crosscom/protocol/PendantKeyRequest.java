package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.PendantKey;

/**
 * Asks to press or release a key of the pendant (c3-bridge.md, type 12): {@code key, number,
 * keyCode, direction, released}.
 *
 * @param id u16, echoed in the answer
 * @param key u8
 * @param number i32; the interpreter, or the number of the axis for {@link PendantKey#JOG}
 * @param keyCode i32; 2 in the one example, a jog (c3-vectors.tsv)
 * @param direction u8, 0 or 1; 0 in the example of a start forward, 1 in that of a jog in plus
 *     direction (c3-vectors.tsv)
 * @param released u8, 0 for pressed or 1 for released
 */
public record PendantKeyRequest(
    int id, Code<PendantKey> key, int number, int keyCode, boolean direction, boolean released)
    implements Request {
  static final Layout<PendantKeyRequest> LAYOUT =
      new Layout<>(
          (m, out) -> {
            out.u8(m.key.number());
            out.i32(m.number);
            out.i32(m.keyCode);
            out.bool(m.direction);
            out.bool(m.released);
          },
          (id, in, tail) ->
              new PendantKeyRequest(
                  id,
                  new Code<>(PendantKey.class, in.u8("key")),
                  in.i32("number"),
                  in.i32("key code"),
                  in.bool("direction"),
                  in.bool("released")));

  /** Checks the ranges. */
  public PendantKeyRequest {
    Ranges.u16("id", id);
    Ranges.u8("key", key.number());
  }

  @Override
  public MessageType type() {
    return MessageType.PENDANT_KEY;
  }
}
