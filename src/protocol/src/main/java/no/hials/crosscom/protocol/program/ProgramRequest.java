package no.hials.crosscom.protocol.program;

import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.internal.ProgramLayouts;
import no.hials.crosscom.protocol.internal.Ranges;

/** Asks to control programs, to move the robot or to press a key of the pendant. */
public sealed interface ProgramRequest extends Request {

  /**
   * Asks an interpreter to reset, start, stop or cancel its program (type 10, I): {@code command,
   * interpreter}. The command may be unknown, since a server answers that too.
   *
   * @param id u16, echoed in the answer
   * @param command u8; neither {@link ProgramCommand#SELECT} nor {@link ProgramCommand#RUN}, which
   *     are commands of {@link ProgramSelectRequest}
   * @param interpreter i16
   */
  record ProgramControlRequest(int id, Code<ProgramCommand> command, Code<Interpreter> interpreter)
      implements ProgramRequest {

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
  record ProgramSelectRequest(
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

  /**
   * Asks to move the robot (type 11): {@code motion, position}.
   *
   * @param id u16, echoed in the answer
   * @param motion u8
   * @param position WSTRING, the KRL text of a position; 32,765 characters at most
   */
  record MotionRequest(int id, Code<MotionType> motion, String position) implements ProgramRequest {
    /** Checks the ranges. */
    public MotionRequest {
      Ranges.u16("id", id);
      Ranges.u8("motion", motion.number());
      Ranges.frame("position", 1 + 1 + Ranges.wide(position));
    }
  }

  /**
   * Asks to press or release a key of the pendant (type 12): {@code key, number, keyCode,
   * direction, released}.
   *
   * @param id u16, echoed in the answer
   * @param key u8
   * @param number i32; the interpreter, or the number of the axis for {@link PendantKey#JOG}
   * @param keyCode i32; 2 in the one example, a jog
   * @param direction u8, 0 or 1; 0 for a start forward, 1 for a jog in plus direction
   *     (docs/reference/c3-messages.md#pendant-keys-12)
   * @param released u8, 0 for pressed or 1 for released
   */
  record PendantKeyRequest(
      int id, Code<PendantKey> key, int number, int keyCode, boolean direction, boolean released)
      implements ProgramRequest {
    /** Checks the ranges. */
    public PendantKeyRequest {
      Ranges.u16("id", id);
      Ranges.u8("key", key.number());
    }
  }
}
