package program;

import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Request;

/** Derives classes from Request. */
public class Requests {
  static class Write extends Request {
    private final String value;

    Write(String name, String value) {
      super(Request.WRITE, name, value);
      this.value = value;
    }

    /** Has the name of a method that the original does not have. */
    public String getValue() {
      return "value " + value;
    }
  }

  static class Named extends Request {
    Named(int id) {
      super(id, "UNUSED");
    }

    @Override
    public String getVariable() {
      return "$OV_PRO";
    }
  }

  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    out.append((int) Request.READ).append((int) Request.WRITE).append('\n');
    CrossComClient client = new CrossComClient(host, port);
    Write write = new Write("$OV_PRO", "42");
    out.append(write.getValue()).append(' ').append(write.getCmd().length).append('\n');
    out.append(client.sendRequest(write).getStringValue()).append('\n');
    out.append(client.sendRequest(new Named(5))).append('\n');
    client.close();
    return out.toString();
  }
}
