package no.hials.crosscom.examples;

import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.mock.MockServer;

/** Reads the position of a simulated robot: the program of the README. */
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
      KRLE6Pos position = new KRLE6Pos("$POS_ACT");
      client.readVariable(position);
      System.out.println("X " + position.getX() + " mm, Z " + position.getZ() + " mm");
      System.out.println("all: " + position.getValue());
    }
  }
}
