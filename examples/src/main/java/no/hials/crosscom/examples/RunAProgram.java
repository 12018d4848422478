package no.hials.crosscom.examples;

import java.io.IOException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.CrossComRefusedException;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.simulator.SimulationClock;

/** Uploads a program, selects it, starts it and stops it. It needs C3 Bridge. */
public final class RunAProgram {
  private static final String COUNTS =
      """
      DEF COUNTS ( )
        MYINT = 0
        LOOP
          MYINT = MYINT + 1
          WAIT SEC 0.012
        ENDLOOP
      END
      """;

  private RunAProgram() {}

  /**
   * Runs the example in a simulated controller, since it would start a program on a real one.
   *
   * @param args not used
   * @throws IOException if a command failed
   */
  public static void main(String[] args) throws IOException {
    try (MockServer robot =
            MockServer.start(
                cfg -> cfg.server(ServerType.C3_BRIDGE).clock(SimulationClock.stepped()));
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      robot.controller().setMode(OperatingMode.AUT);
      robot.files().put("/R1/COUNTS.SRC", COUNTS);
      robot.files().put("/R1/WRONG.SRC", "DEF WRONG ( )\n  NOWHERE ( )\nEND\n");
      select(client);
      run(client);
    }
  }

  private static void select(CrossComClient client) throws IOException {
    try {
      client.programs().select("/R1/WRONG");
    } catch (CrossComRefusedException e) {
      // the controller sends no reason; the pendant shows the errors
      System.out.println("not selected, code " + e.getCode());
    }
    client.programs().select("/R1/COUNTS");
    System.out.println(client.readText("$PRO_STATE1"));
  }

  private static void run(CrossComClient client) throws IOException {
    client.programs().start(Interpreter.ROBOT); // moves a machine
    System.out.println(client.readText("$PRO_STATE1"));
    client.programs().stop(Interpreter.ROBOT); // not an emergency stop: it needs a working network
    System.out.println(client.readText("$PRO_STATE1"));
    client.programs().cancel(Interpreter.ROBOT); // now its files can be changed again
    System.out.println(client.readText("$PRO_STATE1"));
  }
}
