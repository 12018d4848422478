package no.hials.crosscom.compat;

import java.io.IOException;
import java.util.Arrays;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLBool;
import no.hials.crosscom.KRL.KRLEnum;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.KRL.KRLVariable;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLPos;

/**
 * A program in the style of the original's README for version 0.2.2; only host and port are ours.
 */
final class OriginalReadme {
  private OriginalReadme() {}

  public static void main(String[] args) throws IOException, InterruptedException {
    String host = args[0];
    int port = Integer.parseInt(args[1]);
    try (CrossComClient client = new CrossComClient(host, port)) {
      KRLPos target = new KRLPos("MYPOS").setX(2).setY(1);
      client.writeVariable(target);
      System.out.println(target);

      client.readVariable(target);
      System.out.println(target);

      KRLE6Axis axes = KRLVariable.AXIS_ACT();
      client.readVariable(axes);
      System.out.println(axes);

      KRLReal jog = KRLVariable.OV_JOG();
      client.readVariable(jog);
      System.out.println(jog);

      KRLReal pro = KRLVariable.OV_PRO();
      client.readVariable(pro);
      for (int i = 0; i < 100; i++) {
        pro.setValue(i);
        client.writeVariable(pro);
      }
      System.out.println(pro);

      KRLBool out = new KRLBool("$OUT[1]");
      client.readVariable(out);
      System.out.println(out);

      KRLEnum mode = new KRLEnum("$MODE_OP");
      client.readVariable(mode);
      System.out.println(mode);

      System.out.println(Arrays.toString(client.readJointAngles()));
      System.out.println(Arrays.toString(client.readJointTorques()));
      System.out.println(client.simpleRead("$OV_JOG"));
      System.out.println(client.simpleWrite("$OV_JOG", "90"));
    }
  }
}
