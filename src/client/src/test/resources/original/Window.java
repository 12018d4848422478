package program;

import no.hials.crosscom.Callback;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Request;
import no.hials.crosscom.variables.Variable;

/** The loop of a window that shows a list of variables, some of which the robot does not have. */
public class Window {
  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    CrossComClient client = new CrossComClient(host, port);
    int id = 0;
    for (String name : new String[] {"$OV_JOG", "TYPO", "$MODE_OP", "MISSING", "$OUT[1]"}) {
      try {
        Callback callback = client.sendRequest(new Request(id++, name));
        Variable variable = id % 2 == 0 ? callback.getVariable() : Variable.parseVariable(callback);
        out.append(variable.getName()).append(" is ").append(variable.getValue()).append('\n');
      } catch (NumberFormatException e) {
        out.append(name).append(" was not found\n");
      }
    }
    client.close();
    return out.toString();
  }
}
