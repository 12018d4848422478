package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.internal.ProgramLayouts;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks an interpreter to reset, start, stop or cancel its program (type 10, I): {@code command,
 * interpreter}. The command may be unknown, since a server answers that too.
 *
 * @param id u16, echoed in the answer
 * @param command u8; neither {@link ProgramCommand#SELECT} nor {@link ProgramCommand#RUN}, which
 *     are commands of {@link ProgramSelectRequest}
 * @param interpreter i16
 */
public record ProgramControlRequest(
    int id, Code<ProgramCommand> command, Code<Interpreter> interpreter) implements ProgramRequest {

  /** Checks the ranges. */
  public ProgramControlRequest {
    Ranges.u16("id", id);
    Ranges.u8("command", command.number());
    if (ProgramLayouts.selects(command)) {
      throw new IllegalArgumentException("command must not be SELECT or RUN, is " + command);
    }
    Ranges.i16("interpreter", interpreter.number());
  }
}
