package program;

import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLAxis;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.KRL.structs.KRLFrame;
import no.hials.crosscom.KRL.structs.KRLPos;

/** Calls each setter. */
public class Setters {
  public static String run(String host, int port) throws Exception {
    StringBuilder out = new StringBuilder();
    CrossComClient client = new CrossComClient(host, port);

    KRLAxis axis = new KRLAxis("MYAXIS");
    axis.setA1ToA6(9, 9, 9, 9, 9, 9);
    axis.setA1(1);
    axis.setA2(2);
    axis.setA3(3);
    axis.setA4(4);
    axis.setA5(5);
    axis.setA6(6);
    out.append(axis.getStringValue()).append('\n');

    KRLE6Axis e6axis = new KRLE6Axis("MYE6AXIS");
    e6axis.setA1ToA6(1, 2, 3, 4, 5, 6);
    e6axis.setA1(0);
    e6axis.setE1ToE6(9, 9, 9, 9, 9, 9);
    e6axis.setE1(1);
    e6axis.setE2(2);
    e6axis.setE3(3);
    e6axis.setE4(4);
    e6axis.setE5(5);
    e6axis.setE6(6);
    out.append(e6axis.getStringValue()).append('\n');

    KRLFrame frame = new KRLFrame("MYFRAME").setX(1).setY(2).setZ(3).setA(4).setB(5).setC(6);
    frame.setXToZ(7, 8, 9);
    frame.setAToC(10, 11, 12);
    out.append(frame.getStringValue()).append('\n');

    KRLPos pos = new KRLPos("MYPOS");
    pos.setX(1).setY(2).setZ(3).setA(4).setB(5).setC(6);
    pos.setXToZ(7, 8, 9);
    pos.setAToC(10, 11, 12);
    pos.setS(2);
    pos.setT(34);
    client.writeVariable(pos);
    out.append(pos.getStringValue()).append('\n');

    KRLE6Pos e6pos = new KRLE6Pos("MYE6POS").setE1(9).setE2(9).setE3(9).setE4(9).setE5(9).setE6(9);
    e6pos.setE1ToE6(1, 2, 3, 4, 5, 6);
    e6pos.setS(2);
    e6pos.setT(34);
    out.append(e6pos.getStringValue()).append('\n');

    client.close();
    return out.toString();
  }
}
