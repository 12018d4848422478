package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ProgramCommand;

/**
 * Answers {@link ProgramControlRequest} and {@link ProgramSelectRequest} (c3-bridge.md, type 10):
 * {@code command}.
 *
 * @param id u16, of the request
 * @param command u8, of the request, known or not
 * @param tail how the access ended
 */
public record ProgramControlResponse(int id, Code<ProgramCommand> command, Tail tail)
    implements TypedResponse {
  static final Layout<ProgramControlResponse> LAYOUT =
      new Layout<>(
          (m, out) -> out.u8(m.command.number()),
          (id, in, tail) ->
              new ProgramControlResponse(
                  id, new Code<>(ProgramCommand.class, in.u8("command")), tail));

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
