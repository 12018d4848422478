package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.ServerType;
import no.hials.crosscom.protocol.code.Interpreter;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.code.ProgramState;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;

/**
 * Finds out why a robot has stopped, confirms the messages, and restarts its program. It needs C3
 * Bridge.
 */
public final class HandleAStoppedRobot {
  private static final String PROGRAM = "DEF SWING ( )\n  PTP {A1 60}\n  PTP {A1 0}\nEND\n";

  private HandleAStoppedRobot() {}

  /**
   * Runs the example. It needs the simulation, whose emergency stop it presses.
   *
   * @param args not used
   * @throws IOException if an access failed
   * @throws KrlFileException if the program has errors
   */
  public static void main(String[] args) throws IOException, KrlFileException {
    try (MockServer robot =
            MockServer.start(
                cfg ->
                    cfg.server(ServerType.C3_BRIDGE)
                        .clock(SimulationClock.stepped())
                        .bco(false)); // the first motion needs no second start
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      Controller controller = robot.controller();
      controller.setMode(OperatingMode.AUT);
      controller.robot().select(controller.load("swing.src", PROGRAM));
      controller.start();
      controller.step(Duration.ofMillis(240));
      print("it moves", client);

      controller.emergencyStop(true);
      controller.step(Duration.ofSeconds(1));
      print("emergency stop", client);
      controller.messages().forEach(message -> System.out.println("  " + message));

      controller.emergencyStop(false);
      print("released", client);

      // Confirming means that a person has read the message. A program that confirms alone disables
      // the message.
      client.information().confirmAll();
      print("confirmed", client);

      client.programs().start(Interpreter.ROBOT); // moves a machine
      controller.stepUntil(
          () -> controller.robot().state() == ProgramState.END, Duration.ofSeconds(20));
      print("started again", client);
    }
  }

  private static void print(String what, CrossComClient client) throws IOException {
    System.out.println(
        what
            + ": program "
            + client.readText("$PRO_STATE1")
            + ", stop message "
            + client.readText("$STOPMESS")
            + ", A1 at "
            + client.readText("$AXIS_ACT.A1")
            + " degrees");
  }
}
