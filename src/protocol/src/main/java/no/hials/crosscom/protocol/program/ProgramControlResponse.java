package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Answers {@link ProgramControlRequest} and {@link ProgramSelectRequest} (type 10): {@code
 * command}.
 *
 * @param id u16, of the request
 * @param command u8, of the request, known or not
 * @param tail the end of the answer
 */
public record ProgramControlResponse(int id, Code<ProgramCommand> command, Tail tail)
    implements TypedResponse {
  /** Checks the ranges. */
  public ProgramControlResponse {
    Ranges.u16("id", id);
    Ranges.u8("command", command.number());
  }

  @Override
  public MessageType type() {
    return MessageType.PROGRAM_CONTROL;
  }
}
