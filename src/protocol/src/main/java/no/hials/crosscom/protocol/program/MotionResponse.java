package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link MotionRequest} (type 11): {@code motion}.
 *
 * @param id u16, of the request
 * @param motion u8, of the request, known or not
 * @param tail the end of the answer
 */
public record MotionResponse(int id, Code<MotionType> motion, Tail tail) implements TypedResponse {
  /** Checks the ranges. */
  public MotionResponse {
    Ranges.u16("id", id);
    Ranges.u8("motion", motion.number());
  }

  @Override
  public MessageType type() {
    return MessageType.MOTION;
  }
}
