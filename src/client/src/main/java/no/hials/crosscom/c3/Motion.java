package no.hials.crosscom.c3;

import no.hials.crosscom.CrossComException;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.CrossComUnsupportedException;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLFrame;

/**
 * Moves the robot to a position (docs/reference/c3-messages.md#motion-11).
 *
 * <p><b>Every method moves a machine.</b> No motion is ever repeated. If the outcome of one is
 * unknown, {@link CrossComException#isOutcomeUnknown} returns true. An answer means that the motion
 * was accepted, not that it has ended (assumed).
 *
 * <p>A position is a local FRAME, POS, E6POS, AXIS or E6AXIS, whose name on the controller does not
 * matter. Only the fields that were set or read are sent, in mm and degrees; the others stay as
 * they are, as in a KRL motion to an aggregate.
 *
 * <p>Thread-safe, but only one thread at a time may use a position. All methods block for at most
 * the request time-out. They throw {@link IllegalArgumentException} if no field of the position has
 * a value; {@link CrossComUnsupportedException} on KUKAVARPROXY, before the motion is sent; {@link
 * CrossComRefusedException} with the server's code if it refuses; another {@link CrossComException}
 * if the exchange fails.
 *
 * <p>Programs get this object from {@link no.hials.crosscom.CrossComClient#motion}.
 */
public interface Motion {
  /**
   * Moves point to point.
   *
   * @param target a FRAME, POS or E6POS, in mm and degrees
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void ptp(KRLFrame target) throws CrossComException;

  /**
   * Moves point to point.
   *
   * @param target an AXIS or E6AXIS, in degrees, or mm for linear axes
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void ptp(KRLAxis target) throws CrossComException;

  /**
   * Moves in a straight line.
   *
   * @param target a FRAME, POS or E6POS, in mm and degrees
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void lin(KRLFrame target) throws CrossComException;

  /**
   * Moves point to point, relative to the actual position.
   *
   * @param offset a FRAME, POS or E6POS, in mm and degrees
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void ptpRel(KRLFrame offset) throws CrossComException;

  /**
   * Moves point to point, relative to the actual position.
   *
   * @param offset an AXIS or E6AXIS, in degrees, or mm for linear axes
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void ptpRel(KRLAxis offset) throws CrossComException;

  /**
   * Moves in a straight line, relative to the actual position.
   *
   * @param offset a FRAME, POS or E6POS, in mm and degrees
   * @throws CrossComException if the server does not support it, refuses, or the exchange fails
   */
  void linRel(KRLFrame offset) throws CrossComException;
}
