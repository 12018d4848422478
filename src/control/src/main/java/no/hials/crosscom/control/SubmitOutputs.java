package no.hials.crosscom.control;

import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLBool;
import no.hials.crosscom.KRL.KRLEnum;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.control.StopReason.Kind;

/**
 * Switches outputs and reads inputs through the globals that {@code krl/jov_sps.sub} copies to and
 * from them, since a client cannot write {@code $OUT} on every controller. Signals are numbered 1
 * to 16, from {@code JOV_FIRST_OUT} and {@code JOV_FIRST_IN} on.
 *
 * <p><b>An output can move a gripper or another machine.</b>
 *
 * <p>When the submit program starts, it takes the outputs as they are, so that none is switched by
 * that. Until then an output cannot be set; {@code JOV_OUT_READY} says so.
 *
 * <p>It can be used by several threads, and starts none.
 */
public final class SubmitOutputs {
  private static final int COUNT = 16;
  private static final String READY = "JOV_OUT_READY";

  private final CrossComClient client;

  /**
   * Makes the access.
   *
   * @param client the connection
   */
  public SubmitOutputs(CrossComClient client) {
    this.client = client;
  }

  /**
   * Switches an output. The submit program does it in its next turn; {@link #output} shows when, or
   * that it did not, as if somebody starts the submit program again at this moment.
   *
   * @param number 1 to 16
   * @param value on or off
   * @throws ControlRefusedException if no submit program runs, which would copy the value, or if it
   *     has only just begun, and would overwrite it
   * @throws IOException if an access failed
   */
  public void setOutput(int number, boolean value) throws IOException {
    check(number);
    KRLEnum state = new KRLEnum("$PRO_STATE0");
    client.readVariable(state);
    if (!state.stringValue().equals("#P_ACTIVE")) {
      throw new ControlRefusedException(
          Kind.PROGRAM,
          "$PRO_STATE0 must be #P_ACTIVE, so that JOV_SPS sets the output, is "
              + state.stringValue());
    }
    if (!read(READY)) {
      throw new ControlRefusedException(
          Kind.PROGRAM,
          READY + " must be TRUE, so that JOV_SPS does not overwrite the output, is FALSE");
    }
    KRLBool output = new KRLBool("JOV_OUT[" + number + "]");
    output.setValue(value);
    client.writeVariable(output);
  }

  /**
   * Reads an output as it is.
   *
   * @param number 1 to 16
   * @return whether it is on
   * @throws IOException if an access failed
   */
  public boolean output(int number) throws IOException {
    check(number);
    KRLInt first = new KRLInt("JOV_FIRST_OUT");
    client.readVariable(first);
    return read("$OUT[" + (first.intValue() + number - 1) + "]");
  }

  /**
   * Reads an input as the submit program copied it last.
   *
   * @param number 1 to 16
   * @return whether it is on
   * @throws IOException if an access failed
   */
  public boolean input(int number) throws IOException {
    check(number);
    return read("JOV_IN[" + number + "]");
  }

  private boolean read(String name) throws IOException {
    KRLBool variable = new KRLBool(name);
    client.readVariable(variable);
    return variable.booleanValue();
  }

  private static void check(int number) {
    Checks.holds(
        number >= 1 && number <= COUNT, "a signal must be 1 to " + COUNT + ", is " + number);
  }
}
