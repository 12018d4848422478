package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.structs.KRLPos;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;

/**
 * Moves the simulated robot by increments that a client writes, with {@code krl/actuator.src}. It
 * needs the simulation, since it advances the time itself.
 */
public final class MoveTheSimulatedRobot {
  private MoveTheSimulatedRobot() {}

  /**
   * Runs the example.
   *
   * @param args not used
   * @throws IOException if a file could not be read or an access failed
   * @throws KrlFileException if a file has errors
   */
  public static void main(String[] args) throws IOException, KrlFileException {
    try (MockServer robot = MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()))) {
      Controller controller = robot.controller();
      controller.load(KrlFolder.file("config.dat"));
      controller.setMode(OperatingMode.AUT);
      controller.robot().select(controller.load(KrlFolder.file("actuator.src")));
      controller.runProgram();
      controller.step(Duration.ofMillis(120)); // until the program is in its loop
      try (CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
        move(controller, client);
      }
    }
  }

  private static void move(Controller controller, CrossComClient client) throws IOException {
    print(controller, client);
    client.writeVariable(new KRLPos("MYPOS").setX(-2).setZ(1)); // mm per step
    for (int i = 0; i < 5; i++) {
      controller.step(Duration.ofMillis(240));
      print(controller, client);
    }
    client.writeVariable(new KRLPos("MYPOS")); // zeros: stop
    controller.stepUntil(controller::standing, Duration.ofSeconds(10));
    print(controller, client);
  }

  private static void print(Controller controller, CrossComClient client) throws IOException {
    Frame position = client.read("$POS_ACT", Frame.class);
    System.out.printf(
        "%5d ms: X %.1f mm, Z %.1f mm, %s%n",
        controller.time().toMillis(), position.x(), position.z(), controller);
  }
}
