package program;

import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.KRLReal;
import no.hials.crosscom.Request;
import no.hials.crosscom.variables.Bool;

/** Shows the ids of its variables, the text of a callback and the name of a type. */
public class Ids {
  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    CrossComClient client = new CrossComClient(host, port);
    KRLInt first = new KRLInt("MYINT");
    KRLReal second = new KRLReal("MYREAL");
    out.append(first.getId()).append(' ').append(second.getId()).append('\n');
    client.readVariable(first);
    out.append(first).append('\n');
    out.append(client.sendRequest(new Request(1, "MYINT"))).append('\n');
    out.append(new Bool(1, "B", true, 0).getDataType()).append('\n');
    client.close();
    return out.toString();
  }
}
