package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to move the robot (type 11): {@code motion, position}.
 *
 * @param id u16, echoed in the answer
 * @param motion u8
 * @param position WSTRING, the KRL text of a position; 32,765 characters at most
 */
public record MotionRequest(int id, Code<MotionType> motion, String position)
    implements ProgramRequest {
  /** Checks the ranges. */
  public MotionRequest {
    Ranges.u16("id", id);
    Ranges.u8("motion", motion.number());
    Ranges.frame("position", 1 + 1 + Ranges.wide(position));
  }
}
