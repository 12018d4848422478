package program;

import no.hials.crosscom.JOpenShowVarConstants;
import no.hials.crosscom.networking.Callback;
import no.hials.crosscom.networking.CrossComClient;
import no.hials.crosscom.networking.Request;
import no.hials.crosscom.variables.TrackException;
import no.hials.crosscom.variables.Variable;

/** A program for version 0.1. */
public class Version01 {
  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    out.append(JOpenShowVarConstants.FILELOCATION_VAR_LIST).append(' ');
    out.append(JOpenShowVarConstants.FILELOCATION_ROBOT_IP).append('\n');
    CrossComClient client = new CrossComClient(host, port);
    client.setSoTimeout(2000);
    out.append(client.isConnected()).append(client.getPort() == port).append('\n');
    for (String name : new String[] {"$OV_PRO", "NOSUCH", "$MODE_OP"}) {
      try {
        Callback callback = client.sendRequest(new Request(8, name));
        Variable variable = Variable.parseVariable(callback);
        out.append(variable.getId()).append(' ').append(callback.getVariable().getValue());
        out.append('\n');
      } catch (NumberFormatException e) {
        out.append(name).append(" was not found\n");
      }
    }
    out.append(client.sendRequest(new Request(9, "$OV_PRO", "17"))).append('\n');
    byte[] answer = {0, 3, 0, 8, (byte) Request.READ, 0, 2, '4', '2', 0, 1, 1};
    Callback own = new Callback("MYINT", answer, 2000000L);
    out.append(own).append(CrossComClient.getInt(answer, 2)).append(own.getOption()).append('\n');
    try {
      throw new TrackException("lost track");
    } catch (TrackException e) {
      out.append(e.getMessage()).append('\n');
    }
    client.close();
    out.append(client.isClosed()).append('\n');
    return out.toString();
  }
}
