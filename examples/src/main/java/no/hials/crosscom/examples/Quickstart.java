package no.hials.crosscom.examples;

import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.value.E6Pos;

/** Reads the position and the override of a simulated robot: the program of the README. */
public final class Quickstart {
  private Quickstart() {}

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if reading failed
   */
  public static void main(String[] args) throws IOException {
    try (MockServer robot = MockServer.start(); // a simulated KR C4
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      E6Pos position = client.read("$POS_ACT", E6Pos.class);
      System.out.println("X " + position.x() + " mm, Z " + position.z() + " mm");

      KRLInt override = new KRLInt("$OV_PRO"); // as in JOpenShowVar 0.2.2
      client.readVariable(override);
      System.out.println("override " + override.intValue() + " %");
    }
  }
}
