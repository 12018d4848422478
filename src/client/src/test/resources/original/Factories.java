package program;

import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLE6Axis;

/** Calls the factory methods of KRLVariable. */
public class Factories {
  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    CrossComClient client = new CrossComClient(host, port);
    KRLReal jog = KRLVariable.OV_JOG();
    KRLReal pro = KRLVariable.OV_PRO();
    KRLE6Axis axes = KRLVariable.AXIS_ACT();
    client.readVariable(jog);
    client.readVariable(pro);
    client.readVariable(axes);
    out.append(jog.getValue()).append(' ').append(pro.getValue()).append('\n');
    out.append(axes.asArrayA1ToA6()[1]).append('\n');
    client.close();
    return out.toString();
  }
}
