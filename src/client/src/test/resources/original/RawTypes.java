package program;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import no.hials.crosscom.Callback;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLStruct;
import no.hials.crosscom.Request;
import no.hials.crosscom.variables.Struct;
import no.hials.crosscom.variables.StructNode;
import no.hials.crosscom.variables.Variable;

/** Relies on raw types, which compile without a cast. */
public class RawTypes {
  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    CrossComClient client = new CrossComClient(host, port);

    Callback callback = client.sendRequest(new Request(1, "MYREAL"));
    Variable<Double> number = callback.getVariable();
    Variable<Double> parsed = Variable.parseVariable(callback);
    out.append(number.getValue() + parsed.getValue()).append('\n');

    Struct struct = (Struct) client.sendRequest(new Request(2, "MYFRAME")).getVariable();
    List<StructNode> nodes = struct.getValue();
    for (StructNode node : nodes) {
      out.append(node.getName()).append(' ').append(node.getValue()).append(';');
    }
    List<StructNode> own = Struct.parseString("{X 1.5}");
    out.append(own.get(0).getName()).append('\n');

    KRLStruct frame = new KRLFrame("MYFRAME");
    client.readVariable(frame);
    HashMap<String, Double> map = frame.getValue();
    Map raw = frame.getValue();
    raw.put("Y", 7.0);
    map.put("Z", map.get("X") + 1);
    client.writeVariable(frame);
    out.append(client.simpleRead("MYFRAME").replaceAll(".*#value=", "")).append('\n');

    client.close();
    return out.toString();
  }
}
