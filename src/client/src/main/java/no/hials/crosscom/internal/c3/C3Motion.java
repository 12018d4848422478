package no.hials.crosscom.internal.c3;

import java.util.Arrays;
import java.util.Objects;
import java.util.function.Predicate;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.c3.Motion;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.program.ProgramRequest.MotionRequest;
import no.hials.crosscom.protocol.program.ProgramResponse;

/** Moves the robot by messages of type 11. */
public final class C3Motion implements Motion {
  private final MessageChannel channel;

  public C3Motion(MessageChannel channel) {
    this.channel = channel;
  }

  @Override
  public void ptp(KRLFrame target) throws CrossComException {
    move(MotionType.PTP, Objects.requireNonNull(target, "target"), target::isSet);
  }

  @Override
  public void ptp(KRLAxis target) throws CrossComException {
    move(MotionType.PTP, Objects.requireNonNull(target, "target"), target::isSet);
  }

  @Override
  public void lin(KRLFrame target) throws CrossComException {
    move(MotionType.LIN, Objects.requireNonNull(target, "target"), target::isSet);
  }

  @Override
  public void ptpRel(KRLFrame offset) throws CrossComException {
    move(MotionType.PTP_REL, Objects.requireNonNull(offset, "offset"), offset::isSet);
  }

  @Override
  public void ptpRel(KRLAxis offset) throws CrossComException {
    move(MotionType.PTP_REL, Objects.requireNonNull(offset, "offset"), offset::isSet);
  }

  @Override
  public void linRel(KRLFrame offset) throws CrossComException {
    move(MotionType.LIN_REL, Objects.requireNonNull(offset, "offset"), offset::isSet);
  }

  private void move(MotionType type, KRLStruct position, Predicate<String> isSet)
      throws CrossComException {
    String[] fields = Arrays.stream(position.getNodes()).filter(isSet).toArray(String[]::new);
    if (fields.length == 0) {
      throw new IllegalArgumentException(
          position.getName() + " has no position: none of its fields was set or read");
    }
    String text = position.getStringValueOf(fields);
    channel.ask(
        new MotionRequest(0, Code.of(type), text),
        ProgramResponse.class,
        "motion " + type + " " + text);
  }
}
