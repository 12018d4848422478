package program;

import no.hials.crosscom.Callback;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Request;

/** A console that shows whatever was asked for, and goes on after an unknown name. */
public class Console {
  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    CrossComClient client = new CrossComClient(host, port);
    for (String name : new String[] {"$OV_PRO", "NOSUCH", "$MODE_OP"}) {
      out.append(client.simpleRead(name)).append('\n');
    }
    out.append(client.simpleWrite("NOSUCH", "1")).append('\n');
    out.append(client.simpleWrite("$OV_PRO", "50")).append('\n');
    Callback refused = client.sendRequest(new Request(3, "NOSUCH"));
    out.append(refused.getId()).append('[').append(refused.getStringValue()).append("]\n");
    out.append(client.sendRequest(new Request(4, "NOSUCH", "1"))).append('\n');
    client.close();
    return out.toString();
  }
}
