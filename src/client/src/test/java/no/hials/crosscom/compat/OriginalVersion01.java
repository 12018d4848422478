package no.hials.crosscom.compat;

import java.io.IOException;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.util.HashMap;
import java.util.List;
import no.hials.crosscom.Callback;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.Request;
import no.hials.crosscom.variables.Int;
import no.hials.crosscom.variables.Struct;
import no.hials.crosscom.variables.StructNode;
import no.hials.crosscom.variables.Variable;

/** Programs in the style of version 0.1 and of the samples, with the exceptions they caught. */
@SuppressWarnings({"deprecation", "rawtypes"})
final class OriginalVersion01 {
  private CrossComClient client;

  void connect(String host, int port) {
    try {
      client = new CrossComClient(host, port);
      client.setSoTimeout(2000);
      System.out.println("time-out " + client.getSoTimeout());
    } catch (UnknownHostException e) {
      System.out.println("unknown host " + e.getMessage());
    } catch (SocketException e) {
      System.out.println("socket " + e.getMessage());
    } catch (IOException e) {
      System.out.println("no connection " + e.getMessage());
    }
  }

  void sendRequests() throws IOException {
    Callback read = client.sendRequest(new Request(0, "$OV_JOG"));
    System.out.println(read);
    // the original's console sent writes with the id of a read
    Callback write = client.sendRequest(new Request(0, "$OV_JOG", "100"));
    System.out.println(write);
    Variable<?> variable = client.sendRequest(new Request(7, "$OV_JOG")).getVariable();
    System.out.println(variable.getName() + " " + variable.getValue() + " " + variable.getId());
    int jog = ((Int) variable).getValue();
    System.out.println("jog " + jog);
    Variable<?> base = client.sendRequest(new Request(8, "$BASE")).getVariable();
    List<StructNode> nodes = ((Struct) base).getValue();
    System.out.println(nodes.get(0).getName() + " is " + nodes.get(0).getValue());
  }

  void structures() throws IOException {
    KRLFrame frame = new KRLFrame("MYFRAME");
    frame.setXToZ(10, 20, 30);
    frame.setAToC(1, 2, 3);
    client.writeVariable(frame);
    client.writeVariable(frame);
    HashMap<String, Double> values = frame.getValue();
    System.out.println("frame " + values.get("X") + " " + values.get("C"));

    KRLE6Axis axes = new KRLE6Axis("MYE6AXIS");
    axes.setA1ToA6(0, -90, 90, 0, 45, 0);
    axes.setE1(5);
    client.writeVariable(axes);
    System.out.println("axes " + axes.getStringValue());

    KRLE6Axis wrong = new KRLE6Axis("$POS_ACT");
    client.readVariable(wrong);
    System.out.println("x of an axis variable " + wrong.getValue().get("X"));

    KRLE6Pos position = new KRLE6Pos("$POS_ACT");
    client.readVariable(position);
    System.out.println("z " + position.getZ() + " nodes " + position.getNodes().length);

    KRLInt state = new KRLInt("MYINT");
    state.setValue(3);
    client.writeVariable(state);
    client.readVariable(state);
    System.out.println("state " + state.getValue() + " of type " + state.getType());
  }

  void close() {
    try {
      client.close();
      System.out.println("closed " + client.isClosed() + " connected " + client.isConnected());
    } catch (IOException e) {
      System.out.println(e.getMessage());
    }
  }
}
