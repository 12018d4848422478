package no.hials.crosscom.protocol.internal;

import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.program.MotionRequest;
import no.hials.crosscom.protocol.program.MotionResponse;
import no.hials.crosscom.protocol.program.PendantKeyRequest;
import no.hials.crosscom.protocol.program.PendantKeyResponse;
import no.hials.crosscom.protocol.program.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramControlResponse;
import no.hials.crosscom.protocol.program.ProgramSelectRequest;

/** The layouts of the messages about programs, motions and keys: types 10 to 12. */
public final class ProgramLayouts {
  private ProgramLayouts() {}

  static void addTo(Layouts all) {
    all.request(MessageType.PROGRAM_CONTROL, ProgramLayouts::readControl);
    all.writer(
        ProgramControlRequest.class,
        (m, out) -> {
          out.u8(m.command().number());
          out.u16(m.interpreter().number());
        });
    all.writer(
        ProgramSelectRequest.class,
        (m, out) -> {
          out.u8(m.command().number());
          out.u16(m.interpreter().number());
          out.wide(m.name());
          out.wide(m.parameters());
          out.bool(m.force());
        });
    all.answer(
        MessageType.PROGRAM_CONTROL,
        ProgramControlResponse.class,
        (m, out) -> out.u8(m.command().number()),
        (id, in, tail) -> new ProgramControlResponse(id, command(in), tail));
    all.request(
        MessageType.MOTION,
        MotionRequest.class,
        (m, out) -> {
          out.u8(m.motion().number());
          out.wide(m.position());
        },
        (id, in) -> new MotionRequest(id, motion(in), in.wide("position")));
    all.answer(
        MessageType.MOTION,
        MotionResponse.class,
        (m, out) -> out.u8(m.motion().number()),
        (id, in, tail) -> new MotionResponse(id, motion(in), tail));
    all.request(
        MessageType.PENDANT_KEY,
        PendantKeyRequest.class,
        (m, out) -> {
          out.u8(m.key().number());
          out.i32(m.number());
          out.i32(m.keyCode());
          out.bool(m.direction());
          out.bool(m.released());
        },
        (id, in) ->
            new PendantKeyRequest(
                id,
                key(in),
                in.i32("number"),
                in.i32("key code"),
                in.bool("direction"),
                in.bool("released")));
    all.answer(
        MessageType.PENDANT_KEY,
        PendantKeyResponse.class,
        (m, out) -> out.u8(m.key().number()),
        (id, in, tail) -> new PendantKeyResponse(id, key(in), tail));
  }

  /** Returns whether a command has the fields of {@link ProgramSelectRequest}. */
  public static boolean selects(Code<ProgramCommand> command) {
    return command.is(ProgramCommand.SELECT) || command.is(ProgramCommand.RUN);
  }

  private static Request readControl(int id, FieldReader in) throws MalformedFrameException {
    Code<ProgramCommand> command = command(in);
    Code<Interpreter> interpreter = new Code<>(Interpreter.class, in.i16("interpreter"));
    return selects(command)
        ? new ProgramSelectRequest(
            id, command, interpreter, in.wide("name"), in.wide("parameters"), in.bool("force"))
        : new ProgramControlRequest(id, command, interpreter);
  }

  private static Code<ProgramCommand> command(FieldReader in) throws MalformedFrameException {
    return new Code<>(ProgramCommand.class, in.u8("command"));
  }

  private static Code<MotionType> motion(FieldReader in) throws MalformedFrameException {
    return new Code<>(MotionType.class, in.u8("motion"));
  }

  private static Code<PendantKey> key(FieldReader in) throws MalformedFrameException {
    return new Code<>(PendantKey.class, in.u8("key"));
  }
}
