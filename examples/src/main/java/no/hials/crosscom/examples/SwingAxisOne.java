package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.control.ControlLoop;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.LoopConfig;
import no.hials.crosscom.control.LoopStatistics;
import no.hials.crosscom.control.StopReason;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.KrlPrograms;

/**
 * Swings A1 with its own control law, one command every 20 ms, and shows how a law that is too fast
 * is stopped. {@code krl/ext_move_axis.src} moves the robot; {@code krl/jov_sps.sub} is the
 * watchdog.
 */
public final class SwingAxisOne {
  private static final double SPEED = 10; // degrees/s
  private static final double TURNS_A_SECOND = 0.5;

  private SwingAxisOne() {}

  /**
   * Runs the example. <b>With arguments it moves that robot</b>: T1, and a hand on the enabling
   * switch.
   *
   * @param args {@code HOST PORT} of a controller in which {@code EXT_MOVE_AXIS} and {@code
   *     JOV_SPS} run, or nothing for a simulated controller
   * @throws IOException if an access failed, or the loop refused to start
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args) throws IOException, InterruptedException {
    if (Arguments.nameAController(args)) {
      try (CrossComClient client = new CrossComClient(args[0], Integer.parseInt(args[1]))) {
        run(client, OperatingMode.T1);
      }
      return;
    }
    try (MockServer robot = MockServer.start();
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      KrlPrograms.start(robot.controller(), KrlPrograms.START, "ext_move_axis");
      run(client, OperatingMode.AUT);
    }
  }

  private static void run(CrossComClient client, OperatingMode mode)
      throws ControlRefusedException, InterruptedException {
    LoopConfig config =
        LoopConfig.create(
            cfg ->
                cfg.period(Duration.ofMillis(20))
                    .noInput() // the law moves the robot without an input device
                    .duration(Duration.ofSeconds(2))
                    .safety(safety -> safety.modes(mode)));

    Law swing =
        Law.jointVelocity(
            state -> {
              double phase = 2 * Math.PI * TURNS_A_SECOND * state.time();
              return Axis.ZERO.with(0, SPEED * Math.sin(phase));
            });
    try (ControlLoop loop = ControlLoop.start(client, config, swing)) {
      StopReason end = loop.await();
      System.out.println("swing: " + end);
      print(loop.statistics());
      if (end.kind() != StopKind.TIME_OVER) {
        System.out.println("start the robot program again, then this example");
        return;
      }
    }

    Law tooFast = Law.jointVelocity(state -> Axis.ZERO.with(0, 90));
    try (ControlLoop loop = ControlLoop.start(client, config, tooFast)) {
      System.out.println("too fast: " + loop.await());
    }
  }

  private static void print(LoopStatistics statistics) {
    System.out.printf(
        Locale.ROOT,
        "%d cycles, %d missed; a cycle takes %.1f ms of 20 to read and %.1f ms to write%n",
        statistics.cycles(),
        statistics.missed(),
        statistics.read().median(),
        statistics.write().median());
    System.out.printf(
        Locale.ROOT,
        "A1 was at most %.2f degrees from its target%n",
        statistics.errors().get(0).maximum());
  }
}
