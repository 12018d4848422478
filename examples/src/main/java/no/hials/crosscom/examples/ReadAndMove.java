package no.hials.crosscom.examples;

import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;

/**
 * Reads, writes and moves with calls that other languages can make too: without lambdas and
 * records. {@code python/read_and_move.py} is the same in Python; {@code krl/follow_axis.src} moves
 * the robot.
 */
public final class ReadAndMove {
  private ReadAndMove() {}

  /**
   * Runs the example. <b>With arguments it moves that robot</b>: A1 by 3 degrees, in T1, with a
   * hand on the enabling switch.
   *
   * @param args {@code HOST PORT} of a controller in which {@code FOLLOW_AXIS} runs, or nothing for
   *     a simulated controller
   * @throws IOException if a file could not be read or an access failed
   * @throws KrlFileException if a file has errors
   */
  public static void main(String[] args) throws IOException, KrlFileException {
    if (Arguments.nameAController(args)) {
      run(args[0], Integer.parseInt(args[1]));
      return;
    }
    MockServer robot = MockServer.start();
    try {
      Controller controller = robot.controller();
      controller.load(KrlFolder.file("config.dat"));
      controller.robot().select(controller.load(KrlFolder.file("follow_axis.src")));
      controller.runProgram();
      run(robot.host(), robot.port());
    } finally {
      robot.close();
    }
  }

  private static void run(String host, int port) throws IOException {
    CrossComClient client = new CrossComClient(host, port);
    try {
      System.out.println("mode " + client.readText("$MODE_OP"));
      System.out.println("A1 to A6 in degrees: " + Arrays.toString(client.readJointAngles()));
      client.writeInt("$OV_PRO", 50);
      System.out.println("override in %: " + client.readInt("$OV_PRO"));

      while (!client.readText("JOV_AXIS").equals(client.readText("$AXIS_ACT"))) {
        checkActive(client); // until the program has set its target to the robot's position
      }
      double target = client.readReal("JOV_AXIS.A1") + 3;
      client.writeReal("JOV_AXIS.A1", target); // moves a machine
      while (Math.abs(client.readReal("$AXIS_ACT.A1") - target) > 0.01) {
        checkActive(client);
      }
      System.out.printf(Locale.ROOT, "A1 is at %.1f degrees%n", client.readReal("$AXIS_ACT.A1"));
    } finally {
      client.close();
    }
  }

  private static void checkActive(CrossComClient client) throws IOException {
    String state = client.readText("$PRO_STATE1");
    if (!state.equals("#P_ACTIVE")) {
      throw new IllegalStateException("the program must be active, is " + state);
    }
  }
}
