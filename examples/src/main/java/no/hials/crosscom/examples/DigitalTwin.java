package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Handle;
import no.hials.crosscom.ReadResults;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;

/**
 * Keeps a model at the position of the robot: computes the flange from the axes, and compares it
 * with the position from the controller.
 */
public final class DigitalTwin {
  private static final int SAMPLES = 5;

  private DigitalTwin() {}

  /** Waits between two samples. */
  private interface Pause {
    void pause() throws InterruptedException;
  }

  /**
   * Runs the example.
   *
   * @param args {@code HOST PORT} of a KR 6 R900 sixx with neither tool nor base set, or nothing
   *     for a simulated controller
   * @throws IOException if reading failed
   * @throws KrlFileException if the program has errors
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args)
      throws IOException, KrlFileException, InterruptedException {
    if (Arguments.nameAController(args)) {
      try (CrossComClient client = new CrossComClient(args[0], Integer.parseInt(args[1]))) {
        mirror(client, () -> Thread.sleep(200));
      }
      return;
    }
    try (MockServer robot = MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()));
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      String program = "DEF GO ( )\n  PTP {A1 60, A2 -70, A5 30}\nEND\n";
      robot.controller().robot().select(robot.controller().load("go.src", program));
      robot.controller().runProgram();
      mirror(client, () -> robot.controller().step(Duration.ofMillis(300)));
    }
  }

  private static void mirror(CrossComClient client, Pause pause)
      throws IOException, InterruptedException {
    RobotModel model = RobotModel.kr6r900sixx();
    Handle<Axis> axes = client.handle("$AXIS_ACT", Axis.class);
    Handle<Frame> position = client.handle("$POS_ACT", Frame.class);
    for (int i = 0; i < SAMPLES; i++) {
      pause.pause();
      ReadResults results = client.read(axes, position);
      Frame twin = model.forward(results.get(axes));
      double apart = twin.distance(results.get(position));
      // on a moving robot, the two are not read at the same moment
      System.out.printf(
          Locale.ROOT,
          "X %.1f, Y %.1f, Z %.1f mm; $POS_ACT is %.3f mm away%n",
          twin.x(),
          twin.y(),
          twin.z(),
          apart);
    }
  }
}
