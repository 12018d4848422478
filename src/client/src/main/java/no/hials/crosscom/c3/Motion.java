package no.hials.crosscom.c3;

import java.util.Arrays;
import java.util.function.Predicate;
import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.internal.MessageChannel;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.MotionType;
import no.hials.crosscom.protocol.program.MotionRequest;
import no.hials.crosscom.protocol.program.MotionResponse;

/**
 * Moves the robot to a position (c3-bridge.md, type 11).
 *
 * <p><b>Every method moves a machine.</b> No motion is ever repeated; if the outcome of one is
 * unknown, {@link CrossComException#isOutcomeUnknown} says so. An answer says that the motion was
 * accepted, not that it has ended (assumed).
 *
 * <p>A position is a local FRAME, POS, E6POS, AXIS or E6AXIS, whose name on the controller does not
 * matter. Only those of its fields are sent that were set or read, in mm and degrees; what is not
 * sent stays as it is, as in a KRL motion to an aggregate.
 *
 * <p>For several threads, but a position is for one at a time. All methods block for the request
 * time-out at most, and throw: {@link IllegalArgumentException} if no field of the position has a
 * value; {@link CrossComUnsupportedException} on KUKAVARPROXY, before the motion is sent; {@link
 * CrossComRefusedException} with the server's code if it refused; another {@link CrossComException}
 * if the exchange failed.
 */
public final class Motion {
  private final MessageChannel link;

  /**
   * Makes the object of a client. For the client; programs get it from {@link
   * no.hials.crosscom.CrossComClient#motion}.
   *
   * @param link sends the messages
   */
  public Motion(MessageChannel link) {
    this.link = link;
  }

  /**
   * Moves point to point.
   *
   * @param target a FRAME, POS or E6POS, in mm and degrees
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void ptp(KRLFrame target) throws CrossComException {
    move(MotionType.PTP, text(target));
  }

  /**
   * Moves point to point.
   *
   * @param target an AXIS or E6AXIS, in degrees, or mm for linear axes
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void ptp(KRLAxis target) throws CrossComException {
    move(MotionType.PTP, text(target));
  }

  /**
   * Moves in a straight line.
   *
   * @param target a FRAME, POS or E6POS, in mm and degrees
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void lin(KRLFrame target) throws CrossComException {
    move(MotionType.LIN, text(target));
  }

  /**
   * Moves point to point, relative to the actual position.
   *
   * @param offset a FRAME, POS or E6POS, in mm and degrees
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void ptpRel(KRLFrame offset) throws CrossComException {
    move(MotionType.PTP_REL, text(offset));
  }

  /**
   * Moves point to point, relative to the actual position.
   *
   * @param offset an AXIS or E6AXIS, in degrees, or mm for linear axes
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void ptpRel(KRLAxis offset) throws CrossComException {
    move(MotionType.PTP_REL, text(offset));
  }

  /**
   * Moves in a straight line, relative to the actual position.
   *
   * @param offset a FRAME, POS or E6POS, in mm and degrees
   * @throws CrossComException if the server cannot, refused, or the exchange failed
   */
  public void linRel(KRLFrame offset) throws CrossComException {
    move(MotionType.LIN_REL, text(offset));
  }

  private void move(MotionType type, String position) throws CrossComException {
    link.ask(
        new MotionRequest(0, Code.of(type), position),
        MotionResponse.class,
        "motion " + type + " " + position);
  }

  private static String text(KRLFrame position) {
    return text(position, position::isSet);
  }

  private static String text(KRLAxis position) {
    return text(position, position::isSet);
  }

  private static String text(KRLStruct position, Predicate<String> isSet) {
    String[] fields =
        Arrays.stream(position.getNodes()).filter(isSet).toList().toArray(new String[0]);
    if (fields.length == 0) {
      throw new IllegalArgumentException(
          position.getName() + " is no position: none of its fields was set or read");
    }
    return position.getStringValueOf(fields);
  }
}
