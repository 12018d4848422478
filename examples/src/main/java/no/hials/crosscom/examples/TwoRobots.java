package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;

/** Reads two robots at once, and lets one follow the other. */
public final class TwoRobots {
  private static final Duration CYCLE = Duration.ofMillis(12);
  private static final int CYCLES = 250;

  private static final String LEAD =
      """
      DEF LEAD ( )
        $VEL_AXIS[1] = 2
        PTP {A1 20}
      END
      """;

  private TwoRobots() {}

  /**
   * Runs the example. It needs the simulation, since it moves two robots and advances their time.
   *
   * @param args not used
   * @throws IOException if a file could not be read or an access failed
   * @throws KrlFileException if a file has errors
   * @throws ExecutionException if reading failed
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args)
      throws IOException, KrlFileException, ExecutionException, InterruptedException {
    try (MockServer first =
            MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()).bco(false));
        MockServer second =
            MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()).bco(false));
        CrossComClient leader = new CrossComClient(first.host(), first.port());
        CrossComClient follower = new CrossComClient(second.host(), second.port())) {
      run(first.controller(), first.controller().load("lead.src", LEAD));
      second.controller().load(KrlFolder.file("config.dat"));
      run(second.controller(), second.controller().load(KrlFolder.file("follow_axis.src")));
      second.controller().step(Duration.ofMillis(240)); // until the program is in its loop
      for (int i = 0; i <= CYCLES; i++) {
        follow(leader, follower, i % 50 == 0);
        first.controller().step(CYCLE);
        second.controller().step(CYCLE);
      }
    }
  }

  private static void run(Controller controller, String program) throws KrlFileException {
    controller.setMode(OperatingMode.AUT);
    controller.robot().select(program);
    controller.start();
  }

  private static void follow(CrossComClient leader, CrossComClient follower, boolean print)
      throws IOException, ExecutionException, InterruptedException {
    // Each client waits for its own controller: two at once take the time of the slower one.
    CompletableFuture<Axis> lead = leader.async(c -> c.read("$AXIS_ACT", Axis.class));
    CompletableFuture<Axis> actual = follower.async(c -> c.read("$AXIS_ACT", Axis.class));
    CompletableFuture.allOf(lead, actual).get();

    follower.write("JOV_AXIS", lead.get());
    if (print) {
      System.out.printf(
          Locale.ROOT,
          "leader A1 %.2f degrees, follower A1 %.2f degrees%n",
          lead.get().a1(),
          actual.get().a1());
    }
  }
}
