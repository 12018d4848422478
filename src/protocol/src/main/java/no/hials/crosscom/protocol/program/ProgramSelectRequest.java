package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.internal.ProgramLayouts;
import no.hials.crosscom.protocol.internal.Ranges;

/**
 * Asks to select a program, or to select and run it (type 10, II): {@code command, interpreter,
 * name, parameters, force}.
 *
 * @param id u16, echoed in the answer
 * @param command u8; {@link ProgramCommand#SELECT} or {@link ProgramCommand#RUN}
 * @param interpreter i16; the server ignores it
 * @param name WSTRING, such as {@code /R1/MAIN}
 * @param parameters WSTRING; name and parameters have 32,763 characters together at most
 * @param force u8, 0 or 1
 */
public record ProgramSelectRequest(
    int id,
    Code<ProgramCommand> command,
    Code<Interpreter> interpreter,
    String name,
    String parameters,
    boolean force)
    implements ProgramRequest {

  /** Checks the ranges. */
  public ProgramSelectRequest {
    Ranges.u16("id", id);
    if (!ProgramLayouts.selects(command)) {
      throw new IllegalArgumentException("command must be SELECT or RUN, is " + command);
    }
    Ranges.i16("interpreter", interpreter.number());
    Ranges.frame("name and parameters", 5 + Ranges.wide(name) + Ranges.wide(parameters));
  }
}
