package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import no.hials.crosscom.CrossComClient;
import no.hials.crosscom.Handle;
import no.hials.crosscom.Sample;
import no.hials.crosscom.Watch;
import no.hials.crosscom.WatchConfig;
import no.hials.crosscom.protocol.value.E6Axis;

/** Reads two variables fifty times a second, and prints five samples. */
public final class WatchVariables {
  private WatchVariables() {}

  /**
   * Runs the example.
   *
   * @param args {@code HOST PORT}, or nothing for a simulated controller
   * @throws IOException if reading failed
   */
  public static void main(String[] args) throws IOException {
    try (ExampleConnection connection = ExampleConnection.of(args)) {
      watch(connection.client());
    }
  }

  private static void watch(CrossComClient client) throws IOException {
    Handle<E6Axis> axes = client.handle("$AXIS_ACT", E6Axis.class);
    Handle<Integer> override = client.intHandle("$OV_PRO");
    WatchConfig config =
        WatchConfig.ofHandles(List.of(axes, override), cfg -> cfg.period(Duration.ofMillis(20)));
    try (Watch watch = client.watch(config)) {
      for (Sample sample : watch) {
        System.out.println(sample.number() + ": A1 = " + sample.get(axes).a1());
        System.out.println(sample.number() + ": $OV_PRO = " + sample.get(override));
        if (sample.number() == 5) {
          break;
        }
      }
      System.out.println("missed periods: " + watch.missedPeriods());
    }
  }
}
