package no.hials.crosscom.protocol.internal;

import java.util.List;
import no.hials.crosscom.protocol.MalformedFrameException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.code.PendantKey;
import no.hials.crosscom.protocol.code.ProgramCommand;
import no.hials.crosscom.protocol.program.ProgramRequest.MotionRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.PendantKeyRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramControlRequest;
import no.hials.crosscom.protocol.program.ProgramRequest.ProgramSelectRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;

/** The layouts of the messages about programs, motions and keys: types 10 to 12. */
public final class ProgramLayouts {
  private ProgramLayouts() {}

  static void addTo(Layouts all) {
    all.writer(ProgramResponse.class, (m, out) -> out.u8(m.code()));
    for (MessageType type :
        List.of(MessageType.PROGRAM_CONTROL, MessageType.MOTION, MessageType.PENDANT_KEY)) {
      all.answer(type, (id, in, tail) -> new ProgramResponse(id, type, in.u8("code"), tail));
    }
    all.request(MessageType.PROGRAM_CONTROL, ProgramLayouts::readControl);
    all.writer(
        MessageType.PROGRAM_CONTROL,
        ProgramControlRequest.class,
        (m, out) -> out.u8(m.command().number()).u16(m.interpreter().number()));
    all.writer(
        MessageType.PROGRAM_CONTROL,
        ProgramSelectRequest.class,
        (m, out) ->
            out.u8(m.command().number())
                .u16(m.interpreter().number())
                .wide(m.name())
                .wide(m.parameters())
                .bool(m.force()));
    all.request(
        MessageType.MOTION,
        MotionRequest.class,
        (m, out) -> out.u8(m.motion().number()).wide(m.position()),
        (id, in) ->
            new MotionRequest(
                id, new Code<>(MotionType.class, in.u8("motion")), in.wide("position")));
    all.request(
        MessageType.PENDANT_KEY,
        PendantKeyRequest.class,
        (m, out) ->
            out.u8(m.key().number())
                .i32(m.number())
                .i32(m.keyCode())
                .bool(m.direction())
                .bool(m.released()),
        (id, in) ->
            new PendantKeyRequest(
                id,
                new Code<>(PendantKey.class, in.u8("key")),
                in.i32("number"),
                in.i32("key code"),
                in.bool("direction"),
                in.bool("released")));
  }

  /** Returns whether a command has the fields of {@link ProgramSelectRequest}. */
  public static boolean selects(Code<ProgramCommand> command) {
    return command.is(ProgramCommand.SELECT) || command.is(ProgramCommand.RUN);
  }

  private static Request readControl(int id, FieldReader in) throws MalformedFrameException {
    Code<ProgramCommand> command = new Code<>(ProgramCommand.class, in.u8("command"));
    Code<Interpreter> interpreter = new Code<>(Interpreter.class, in.i16("interpreter"));
    return selects(command)
        ? new ProgramSelectRequest(
            id, command, interpreter, in.wide("name"), in.wide("parameters"), in.bool("force"))
        : new ProgramControlRequest(id, command, interpreter);
  }
}
