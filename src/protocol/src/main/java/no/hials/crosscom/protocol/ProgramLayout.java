package no.hials.crosscom.protocol;

import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.ProgramCommand;

/** The two layouts of type 10. */
final class ProgramLayout {
  static final Layout<Request> REQUEST = new Layout<>(ProgramLayout::write, ProgramLayout::read);

  private ProgramLayout() {}

  /** Says whether a command has the second layout. */
  static boolean selects(Code<ProgramCommand> command) {
    return command.is(ProgramCommand.SELECT) || command.is(ProgramCommand.RUN);
  }

  private static void write(Request request, WireBuffer out) {
    if (request instanceof ProgramControlRequest control) {
      out.u8(control.command().number());
      out.u16(control.interpreter().number());
    } else if (request instanceof ProgramSelectRequest select) {
      out.u8(select.command().number());
      out.u16(select.interpreter().number());
      out.putWide(select.name());
      out.putWide(select.parameters());
      out.bool(select.force());
    }
  }

  private static Request read(int id, WireBuffer in, Tail tail) throws MalformedFrameException {
    Code<ProgramCommand> command = new Code<>(ProgramCommand.class, in.u8("command"));
    Code<Interpreter> interpreter = new Code<>(Interpreter.class, in.i16("interpreter"));
    return selects(command)
        ? new ProgramSelectRequest(
            id, command, interpreter, in.wide("name"), in.wide("parameters"), in.bool("force"))
        : new ProgramControlRequest(id, command, interpreter);
  }
}
