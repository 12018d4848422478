package no.hials.crosscom.control;

import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLBool;
import no.hials.crosscom.KRL.KRLEnum;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.control.StopReason.StopKind;

/**
 * Switches outputs and reads inputs through global variables, which {@code krl/jov_sps.sub} copies
 * to and from the signals; not every controller lets a client write {@code $OUT}. Signals are
 * numbered 1 to 16, starting at {@code JOV_FIRST_OUT} and {@code JOV_FIRST_IN}.
 *
 * <p><b>An output can move a gripper or another machine.</b>
 *
 * <p>When the submit program starts, it reads the outputs, so the start switches no output. Until
 * then an output cannot be set, and {@code JOV_OUT_READY} is FALSE.
 *
 * <p>Thread-safe. It starts no thread.
 */
public final class SubmitOutputs {
  private static final int COUNT = 16;
  private static final String READY = "JOV_OUT_READY";

  private final CrossComClient client;

  /**
   * Creates the access.
   *
   * @param client the connection
   */
  public SubmitOutputs(CrossComClient client) {
    this.client = client;
  }

  /**
   * Switches an output. The submit program does it in its next cycle; read {@link #output} to
   * check, since a restart of the submit program at that moment prevents it.
   *
   * @param number 1 to 16
   * @param value on or off
   * @throws ControlRefusedException if no submit program is running to copy the value, or if it has
   *     just started and would overwrite the value
   * @throws IOException if an access failed
   */
  public void setOutput(int number, boolean value) throws IOException {
    check(number);
    KRLEnum state = new KRLEnum("$PRO_STATE0");
    client.readVariable(state);
    if (!state.stringValue().equals("#P_ACTIVE")) {
      throw new ControlRefusedException(
          StopKind.PROGRAM,
          "$PRO_STATE0 must be #P_ACTIVE, so that JOV_SPS sets the output, is "
              + state.stringValue());
    }
    if (!read(READY)) {
      throw new ControlRefusedException(
          StopKind.PROGRAM,
          READY + " must be TRUE, so that JOV_SPS does not overwrite the output, is FALSE");
    }
    KRLBool output = new KRLBool("JOV_OUT[" + number + "]");
    output.setValue(value);
    client.writeVariable(output);
  }

  /**
   * Reads the actual state of an output.
   *
   * @param number 1 to 16
   * @throws IOException if an access failed
   */
  public boolean output(int number) throws IOException {
    check(number);
    KRLInt first = new KRLInt("JOV_FIRST_OUT");
    client.readVariable(first);
    return read("$OUT[" + (first.intValue() + number - 1) + "]");
  }

  /**
   * Reads the last copy of an input by the submit program.
   *
   * @param number 1 to 16
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
