package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import no.hials.crosscom.control.ControlLoop;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.LoopConfig;
import no.hials.crosscom.control.LoopStatistics;
import no.hials.crosscom.control.Trace;
import no.hials.crosscom.control.Twist;
import no.hials.crosscom.control.input.Input;
import no.hials.crosscom.control.input.InputDevice;
import no.hials.crosscom.simulator.KrlFileException;
import org.jspecify.annotations.Nullable;

/**
 * Moves the tool with a joystick: its deflection is a velocity, and the robot stops when the
 * dead-man is released. {@code krl/actuator.src} moves the robot.
 */
public final class ControlByVelocity {
  private static final double SPEED = 40; // mm/s at full deflection
  private static final Duration HELD = Duration.ofSeconds(1); // then the person releases it

  private ControlByVelocity() {}

  /**
   * Runs the example. <b>With arguments it moves that robot</b>: T1, and a hand on the enabling
   * switch.
   *
   * @param args {@code HOST PORT} of a controller in which {@code ACTUATOR} and {@code JOV_SPS}
   *     run, or nothing for a simulated controller
   * @throws IOException if a file could not be read, an access failed, or the loop refused to start
   * @throws KrlFileException if a file has errors
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args)
      throws IOException, KrlFileException, InterruptedException {
    try (Cell cell = Cell.of(args, "actuator.src", "JOV_STEPS")) {
      LoopConfig config =
          LoopConfig.create(
              cfg ->
                  cfg.period(Duration.ofMillis(12))
                      .input(new Joystick().shaped(0.1, 0.5)) // a dead zone; at most half speed
                      .duration(Duration.ofSeconds(2))
                      .safety(cell::limit));
      Law law =
          Law.cartesianVelocity(
              state -> Twist.linear(0, SPEED * state.input().axis(0), 0)); // along Y of $BASE
      try (ControlLoop loop = ControlLoop.start(cell.client(), config, law)) {
        System.out.println(loop.await());
        print(loop);
      }
    }
  }

  private static void print(ControlLoop loop) {
    LoopStatistics statistics = loop.statistics();
    boolean stood = statistics.holding() > 0;
    System.out.println("the robot stopped after the dead-man was released: " + stood);
    List<Trace.Cycle> cycles = loop.trace().cycles();
    double begin = cycles.get(0).actual().get(1);
    double end = cycles.get(cycles.size() - 1).actual().get(1);
    System.out.printf(Locale.ROOT, "moved along Y: %.1f mm%n", end - begin);
  }

  /** A simulated device: fully deflected, then released. */
  private static final class Joystick implements InputDevice {
    private @Nullable Long begin;

    @Override
    public Input read() {
      long now = System.nanoTime();
      if (begin == null) {
        begin = now;
      }
      boolean deadMan = now - begin < HELD.toNanos();
      // the time shows the age of the input: too old counts as released
      return new Input(List.of(1.0), List.of(), deadMan, now);
    }
  }
}
