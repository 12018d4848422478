package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;

/**
 * Runs your own data list and program, first with a mistake in it. It needs the simulation, which
 * loads them itself; {@link RunKrlProgram} uploads a program over the network.
 */
public final class LoadOwnProgram {
  private static final String CONFIG =
      """
      DEFDAT $CONFIG
      DECL INT PARTS=3
      DECL REAL TOTAL=0.0
      ENDDAT
      """;

  private static final String PROGRAM =
      """
      DEF WEIGH ( )
        DECL INT I
        FOR I=1 TO PARTS
          TOTAL=TOTAL+1.5*I
        ENDFOR
        PTP {A1 10}
      END
      """;

  private LoadOwnProgram() {}

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if an access failed
   * @throws KrlFileException if the program has errors
   */
  public static void main(String[] args) throws IOException, KrlFileException {
    try (MockServer robot = MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()));
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      Controller controller = robot.controller();
      controller.load("$config.dat", CONFIG);
      try {
        controller.load("weigh.src", PROGRAM.replace("PTP", "ASYPTP"));
      } catch (KrlFileException e) {
        System.out.println(e.getMessage());
      }
      controller.load("weigh.src", PROGRAM);
      controller.robot().select("WEIGH");
      client.writeInt("PARTS", 4);
      controller.runProgram();
      boolean ended =
          controller.stepUntil(
              () -> controller.robot().state() == ProgramState.END, Duration.ofMinutes(1));
      System.out.println("ended: " + ended);
      System.out.println("TOTAL = " + client.readText("TOTAL"));
      System.out.println("A1 = " + client.readText("$AXIS_ACT.A1"));
      System.out.println("simulated time: " + controller.time().toMillis() + " ms");
    }
  }
}
