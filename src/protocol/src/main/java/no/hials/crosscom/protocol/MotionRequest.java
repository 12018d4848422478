package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.MotionType;

/**
 * Asks to move the robot (c3-bridge.md, type 11): {@code motion, position}.
 *
 * @param id u16, echoed in the answer
 * @param motion u8
 * @param position WSTRING, the KRL text of a position; 32,765 characters at most
 */
public record MotionRequest(int id, Code<MotionType> motion, String position) implements Request {
  static final Layout<MotionRequest> LAYOUT =
      new Layout<>(
          (m, out) -> {
            out.u8(m.motion.number());
            out.putWide(m.position);
          },
          (id, in, tail) ->
              new MotionRequest(
                  id, new Code<>(MotionType.class, in.u8("motion")), in.wide("position")));

  /** Checks the ranges. */
  public MotionRequest {
    Ranges.u16("id", id);
    Ranges.u8("motion", motion.number());
    Ranges.frame("position", 1 + 1 + Ranges.wide(position));
  }

  @Override
  public MessageType type() {
    return MessageType.MOTION;
  }
}
