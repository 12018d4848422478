package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Watch;

/** Reads two variables fifty times a second, and prints five samples. */
public final class WatchVariables {
  private WatchVariables() {}

  /**
   * Runs the example.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   * @throws IOException if reading failed
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args) throws IOException, InterruptedException {
    try (Controller controller = Controller.of(args)) {
      watch(controller.client());
    }
  }

  private static void watch(CrossComClient client) throws IOException, InterruptedException {
    BlockingQueue<Sample> samples = new LinkedBlockingQueue<>();
    try (Watch watch = client.watch(Duration.ofMillis(20), samples::add, "$AXIS_ACT", "$OV_PRO")) {
      for (int i = 0; i < 5; i++) {
        Sample sample = samples.take();
        System.out.println(sample.number() + ": $OV_PRO = " + sample.value("$OV_PRO"));
      }
      System.out.println("missed periods: " + watch.missedPeriods());
    }
  }
}
