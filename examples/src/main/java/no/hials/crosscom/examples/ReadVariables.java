package no.hials.crosscom.examples;

import java.io.IOException;
import java.util.Arrays;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLAny;
import no.hials.crosscom.KRL.KRLBool;
import no.hials.crosscom.KRL.KRLEnum;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLRealArray;
import no.hials.crosscom.KRL.KRLString;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLE6Axis;

/** Reads variables of every type. */
public final class ReadVariables {
  private ReadVariables() {}

  /**
   * Runs the example.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   * @throws IOException if reading failed
   */
  public static void main(String[] args) throws IOException {
    try (Controller controller = Controller.of(args)) {
      read(controller.client());
    }
  }

  private static void read(CrossComClient client) throws IOException {
    KRLInt override = new KRLInt("$OV_PRO");
    client.readVariable(override);
    System.out.println("program override: " + override.intValue() + " %");

    KRLEnum mode = new KRLEnum("$MODE_OP");
    client.readVariable(mode);
    System.out.println("operating mode: " + mode.getValue());

    KRLBool input = new KRLBool("$IN[1025]");
    client.readVariable(input);
    System.out.println("input 1025: " + input.booleanValue());

    KRLString model = new KRLString("$MODEL_NAME[]");
    client.readVariable(model);
    System.out.println("model: " + model.getValue());

    KRLE6Axis axes = KRLVariable.AXIS_ACT();
    client.readVariable(axes);
    System.out.println("A1 to A6: " + Arrays.toString(axes.asArrayA1ToA6()));

    KRLRealArray torques = new KRLRealArray("$TORQUE_AXIS_ACT[]");
    client.readVariable(torques);
    System.out.println("torques: " + Arrays.toString(torques.getValue()));

    KRLAny load = new KRLAny("$LOAD");
    client.readVariable(load);
    System.out.println("load: " + load.getValue());
  }
}
