package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;

/**
 * Checks mode, program and limits before it moves the robot, and whether the robot has arrived.
 * {@code krl/follow_axis.src} moves the robot.
 */
public final class CheckBeforeMoving {
  private static final double MARGIN = 5;
  private static final double ARRIVED = 0.01;
  private static final Duration LIMIT = Duration.ofSeconds(30);

  private CheckBeforeMoving() {}

  /**
   * Runs the example. <b>With arguments it moves that robot</b>: in T1, A1 to 10 degrees.
   *
   * @param args {@code HOST PORT} of a controller in which {@code FOLLOW_AXIS} runs, or nothing for
   *     a simulated controller
   * @throws IOException if a file could not be read or an access failed
   * @throws KrlFileException if a file has errors
   */
  public static void main(String[] args) throws IOException, KrlFileException {
    if (Arguments.nameAController(args)) {
      try (CrossComClient client = new CrossComClient(args[0], Integer.parseInt(args[1]))) {
        turn(client, 10);
      }
      return;
    }
    try (MockServer robot = MockServer.start(cfg -> cfg.clock(SimulationClock.unlimited()));
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      Controller controller = robot.controller();
      controller.load(KrlFolder.file("config.dat"));
      controller.robot().select(controller.load(KrlFolder.file("follow_axis.src")));
      turn(client, 10);
      controller.runProgram();
      await(client, "the program's target is where the robot stands", () -> isReady(client));
      turn(client, 168);
      turn(client, 10);
    }
  }

  private static void turn(CrossComClient client, double to) throws IOException {
    Optional<String> objection = objection(client, to);
    if (objection.isPresent()) {
      System.out.println("not moved: " + objection.get());
      return;
    }
    client.writeReal("JOV_AXIS.A1", to);
    await(client, "A1 at " + to, () -> Math.abs(client.readJointAngles()[0] - to) < ARRIVED);
    System.out.println("A1 is at " + client.readJointAngles()[0]);
  }

  private static Optional<String> objection(CrossComClient client, double to) throws IOException {
    String mode = client.readText("$MODE_OP"); // a failed read throws, and permits nothing
    if (!mode.equals("#T1")) {
      return Optional.of("the mode must be #T1, is " + mode);
    }
    String program = client.readString("$PRO_NAME1[]");
    String state = client.readText("$PRO_STATE1");
    if (!program.equals("FOLLOW_AXIS") || !state.equals("#P_ACTIVE")) {
      return Optional.of(program + " is " + state);
    }
    double min = client.readReal("$SOFTN_END[1]") + MARGIN;
    double max = client.readReal("$SOFTP_END[1]") - MARGIN;
    if (to < min || to > max) {
      return Optional.of("A1 must be " + min + " to " + max + ", would be " + to);
    }
    return Optional.empty();
  }

  private static boolean isReady(CrossComClient client) throws IOException {
    return client.readText("JOV_AXIS").equals(client.readText("$AXIS_ACT"));
  }

  private interface Condition {
    boolean holds() throws IOException;
  }

  private static void await(CrossComClient client, String what, Condition condition)
      throws IOException {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (!condition.holds()) {
      String state = client.readText("$PRO_STATE1");
      if (!state.equals("#P_ACTIVE") || System.nanoTime() > end) {
        throw new IOException("not reached: " + what + "; the program is " + state);
      }
    }
  }
}
