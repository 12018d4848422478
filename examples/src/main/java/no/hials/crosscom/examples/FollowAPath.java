package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Watch;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.KrlEnum;
import no.hials.crosscom.protocol.value.KrlInt;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;

/**
 * Writes a path of 24 points and lets {@code krl/play_path.src} execute it: A1 swings 10 degrees to
 * one side and back.
 */
public final class FollowAPath {
  private static final int POINTS = 24;
  private static final double SWING = 10;

  private FollowAPath() {}

  /**
   * Runs the example. <b>With arguments it moves that robot</b>: T1, and a hand on the enabling
   * switch.
   *
   * @param args {@code HOST PORT} of a controller in which {@code PLAY_PATH} runs, or nothing for a
   *     simulated controller
   * @throws IOException if a file could not be read or an access failed
   * @throws KrlFileException if a file has errors
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args)
      throws IOException, KrlFileException, InterruptedException {
    if (Arguments.nameAController(args)) {
      follow(args[0], Integer.parseInt(args[1]));
      return;
    }
    try (MockServer robot = MockServer.start()) {
      Controller controller = robot.controller();
      controller.load(KrlFolder.file("config.dat"));
      controller.setMode(OperatingMode.AUT);
      controller.robot().select(controller.load(KrlFolder.file("play_path.src")));
      controller.runProgram();
      follow(robot.host(), robot.port());
    }
  }

  private static void follow(String host, int port) throws IOException, InterruptedException {
    try (CrossComClient client = new CrossComClient(host, port)) {
      awaitReady(client);
      Axis start = client.read("$AXIS_ACT", Axis.class);
      for (int i = 1; i <= POINTS; i++) {
        double a1 = start.a1() + SWING / 2 * (1 - Math.cos(2 * Math.PI * i / POINTS));
        client.write("JOV_PATH_AXIS[" + i + "]", start.with(0, a1));
      }
      client.writeInt("JOV_COUNT", POINTS);
      client.writeInt("JOV_RESULT", 0);
      client.writeInt("JOV_COMMAND", 1); // last, because it starts the motion
      printUntilDone(client);
    }
  }

  /** Waits until the program is ready; until then it would clear the command. */
  private static void awaitReady(CrossComClient client) throws IOException {
    long end = System.nanoTime() + Duration.ofSeconds(10).toNanos();
    while (client.readInt("JOV_RESULT") == 0) {
      if (System.nanoTime() > end) {
        throw new IOException("PLAY_PATH is not ready: it does not run, or plays a path");
      }
    }
  }

  private static void printUntilDone(CrossComClient client)
      throws IOException, InterruptedException {
    BlockingQueue<Sample> samples = new LinkedBlockingQueue<>();
    String[] names = {"JOV_RESULT", "JOV_INDEX", "$AXIS_ACT.A1", "$PRO_STATE1"};
    try (Watch watch = client.watch(Duration.ofMillis(50), samples::add, names)) {
      Sample sample;
      do {
        sample = samples.take();
        System.out.println(
            "planning point " + sample.value("JOV_INDEX") + ", A1 " + sample.value("$AXIS_ACT.A1"));
      } while (sample.value("JOV_RESULT").equals(new KrlInt(0))
          && sample.value("$PRO_STATE1").equals(new KrlEnum("P_ACTIVE")));
      System.out.println("JOV_RESULT = " + sample.value("JOV_RESULT"));
      System.out.println("missed periods: " + watch.missedPeriods());
    }
  }
}
