package no.hials.crosscom.cli.experiment;

import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.mock.Latency;
import no.hials.crosscom.mock.MockServer;

/** A simulated KR 6 R900 sixx whose program waits for increments, and a client of it. */
final class SimulatedRobot implements AutoCloseable {
  static final RobotModel MODEL = RobotModel.kr6r900sixx();

  private static final Duration PATIENCE = Duration.ofSeconds(10);
  private static final Duration PAUSE = Duration.ofMillis(12);

  private final MockServer server;
  private final CrossComClient client;

  private SimulatedRobot(MockServer server, CrossComClient client) {
    this.server = server;
    this.client = client;
  }

  /**
   * Starts everything.
   *
   * @param latency as {@link Latency#parse} reads it
   * @param start where the axes are at first
   * @param program what the robot is to run
   * @throws IOException if it cannot be started or reached
   */
  static SimulatedRobot start(String latency, Axes start, RobotProgram program) throws IOException {
    Latency times = Latency.parse(latency, 1);
    MockServer server = MockServer.start(cfg -> cfg.latency(times).recordedRequests(0));
    try {
      CrossComClient client =
          new CrossComClient(ClientConfig.create(server.host(), cfg -> cfg.port(server.port())));
      SimulatedRobot robot = new SimulatedRobot(server, client);
      KrlPrograms.start(server.controller(), start, program.name().toLowerCase(Locale.ROOT));
      robot.awaitFirstStep();
      return robot;
    } catch (IOException | RuntimeException e) {
      server.close();
      throw e;
    }
  }

  /** Waits until the program is in its loop: before, it sets the increment to zeros. */
  private void awaitFirstStep() throws IOException {
    KRLInt steps = new KRLInt("JOV_STEPS");
    long end = System.nanoTime() + PATIENCE.toNanos();
    do {
      if (System.nanoTime() > end) {
        throw new IOException(
            "the program on the simulated controller must come to its loop within "
                + PATIENCE
                + ", is "
                + server.controller());
      }
      LockSupport.parkNanos(PAUSE.toNanos());
      client.readVariable(steps);
    } while (steps.intValue() == 0);
  }

  CrossComClient client() {
    return client;
  }

  @Override
  public void close() throws IOException {
    try {
      client.close();
    } finally {
      server.close();
    }
  }
}
