package no.hials.crosscom.examples;

import java.io.IOException;
import java.util.Optional;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KrlName;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.value.Frame;

/** Reads and writes a STRUC that the user's {@code $CONFIG.DAT} declares, as a Java record. */
public final class OwnRecord {
  private OwnRecord() {}

  // STRUC WELD REAL SPEED, INT SEAM_NO, CHAR NAME[24], STATE STATE, FRAME OFFSET, REAL GAP
  record Weld(
      double speed,
      @KrlName("SEAM_NO") int seam,
      String name,
      State state,
      Frame offset,
      Optional<Double> gap) {}

  // ENUM STATE IDLE, WELDING
  enum State {
    IDLE,
    WELDING
  }

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if an access failed
   */
  public static void main(String[] args) throws IOException {
    try (MockServer robot = MockServer.start()) {
      robot.variables().declareEnum("STATE", "IDLE", "WELDING");
      robot
          .variables()
          .declareStruc(
              "STRUC WELD REAL SPEED, INT SEAM_NO, CHAR NAME[24], STATE STATE,"
                  + " FRAME OFFSET, REAL GAP");
      robot
          .variables()
          .declare(
              "MYWELD",
              "WELD",
              "{SPEED 0.5,SEAM_NO 1,NAME[] \"left\",STATE #IDLE,"
                  + "OFFSET {X 1.0,Y 2.0,Z 3.0,A 0.0,B 0.0,C 0.0}}");
      try (CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
        Weld weld = client.read("MYWELD", Weld.class); // one access for the whole structure
        System.out.println(
            "seam " + weld.seam() + " " + weld.name() + ", Z " + weld.offset().z() + " mm");

        Frame offset = new Frame(1, 2, 3.5, 0, 0, 0);
        client.write("MYWELD", new Weld(0.8, 2, "right", State.WELDING, offset, weld.gap()));
        System.out.println(client.readText("MYWELD"));
      }
    }
  }
}
