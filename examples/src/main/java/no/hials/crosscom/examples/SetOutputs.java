package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.control.SubmitOutputs;
import no.hials.crosscom.mock.MockServer;
import no.hials.crosscom.simulator.Controller;
import no.hials.crosscom.simulator.KrlFileException;
import no.hials.crosscom.simulator.SimulationClock;

/**
 * Switches an output on and off, and reads an input, through the submit interpreter: a client
 * cannot write {@code $OUT}, so {@code krl/jov_sps.sub} copies global variables to it.
 */
public final class SetOutputs {
  private static final Duration CYCLE = Duration.ofMillis(12);
  private static final int GRIPPER = 3;
  private static final int PART_IS_THERE = 2;

  private SetOutputs() {}

  /**
   * Runs the example. <b>With arguments it switches output 3 of the 16 of that controller</b>.
   *
   * @param args {@code HOST PORT} of a controller in which {@code JOV_SPS} runs, or nothing for a
   *     simulated controller
   * @throws IOException if a file could not be read or an access failed
   * @throws KrlFileException if a file has errors
   */
  public static void main(String[] args) throws IOException, KrlFileException {
    if (Arguments.nameAController(args)) {
      try (CrossComClient client = new CrossComClient(args[0], Integer.parseInt(args[1]))) {
        grip(client, () -> {}); // its time passes automatically
      }
      return;
    }
    try (MockServer robot = MockServer.start(cfg -> cfg.clock(SimulationClock.stepped()));
        CrossComClient client = new CrossComClient(robot.host(), robot.port())) {
      Controller controller = robot.controller();
      controller.load(KrlFolder.file("config.dat"));
      controller.submit().select(controller.load(KrlFolder.file("jov_sps.sub")));
      robot.variables().set("$IN[" + PART_IS_THERE + "]", "TRUE");
      controller.submit().start();
      controller.step(CYCLE.multipliedBy(4)); // until the program is in its loop
      grip(client, () -> controller.step(CYCLE));
    }
  }

  private static void grip(CrossComClient client, Runnable pause) throws IOException {
    SubmitOutputs signals = new SubmitOutputs(client);
    set(signals, true, pause);
    System.out.println("part is there: " + signals.input(PART_IS_THERE));
    set(signals, false, pause);
  }

  private static void set(SubmitOutputs signals, boolean value, Runnable pause) throws IOException {
    signals.setOutput(GRIPPER, value);
    // A write does not switch the output: the submit interpreter does, in its own cycle.
    long end = System.nanoTime() + Duration.ofSeconds(5).toNanos();
    while (signals.output(GRIPPER) != value) {
      if (System.nanoTime() > end) {
        throw new IOException("output " + GRIPPER + " must be " + value + ", is not within 5 s");
      }
      pause.run();
    }
    System.out.println("output " + GRIPPER + " is " + (value ? "on" : "off"));
  }
}
