package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers a {@link ProgramRequest} (types 10 to 12): {@code code}.
 *
 * @param id u16, of the request
 * @param type u8, of the request
 * @param code u8, the command, the motion or the key of the request, 0 to 255
 * @param tail the end of the answer
 */
public record ProgramResponse(int id, MessageType type, int code, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public ProgramResponse {
    Ranges.u16("id", id);
    Ranges.type(type, MessageType.PROGRAM_CONTROL, MessageType.MOTION, MessageType.PENDANT_KEY);
    Ranges.u8("code", code);
  }
}
