package no.hials.crosscom.lab.experiment;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import no.hials.crosscom.ClientConfig;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.KRL.KRLInt;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;

/**
 * A simulated KR 6 R900 sixx whose program waits for increments, and its client. The robot runs in
 * a separate process, as a real one does, so that a garbage collection stops only one of the two.
 */
final class SimulatedRobot implements AutoCloseable {
  static final RobotModel MODEL = RobotModel.kr6r900sixx();

  private static final Duration PATIENCE = Duration.ofSeconds(10);
  private static final Duration PAUSE = Duration.ofMillis(12);

  private final Process process;
  private final CrossComClient client;

  private SimulatedRobot(Process process, CrossComClient client) {
    this.process = process;
    this.client = client;
  }

  /**
   * Starts the process, the program and the client.
   *
   * @param latency as {@link no.hials.crosscom.mock.Latency#parse} reads it
   * @param start the initial position of the axes
   * @param program the program to run
   * @throws IOException if the robot cannot be started or reached
   */
  static SimulatedRobot start(String latency, Axis start, RobotProgram program) throws IOException {
    Process process = RobotProcess.start(latency, start, program);
    try {
      SimulatedRobot robot = new SimulatedRobot(process, client(process));
      robot.awaitFirstStep();
      return robot;
    } catch (IOException | RuntimeException e) {
      end(process);
      throw e;
    }
  }

  private static CrossComClient client(Process process) throws IOException {
    BufferedReader said = process.inputReader(StandardCharsets.US_ASCII);
    String host = said.readLine();
    String port = said.readLine();
    if (host == null || port == null) {
      throw new IOException("the simulated robot did not start");
    }
    return new CrossComClient(ClientConfig.create(host, cfg -> cfg.port(Integer.parseInt(port))));
  }

  /**
   * Waits until the program is in its loop, because before the loop it sets the increment to zeros.
   */
  private void awaitFirstStep() throws IOException {
    KRLInt steps = new KRLInt("JOV_STEPS");
    long end = System.nanoTime() + PATIENCE.toNanos();
    do {
      if (System.nanoTime() > end) {
        throw new IOException(
            "the program on the simulated controller must reach its loop within " + PATIENCE);
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
      end(process);
    }
  }

  /** Ends the process, which exits when its input is closed. */
  private static void end(Process process) throws IOException {
    try {
      process.outputWriter().close();
      process.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      process.destroyForcibly(); // no effect if it has exited
    }
  }
}
