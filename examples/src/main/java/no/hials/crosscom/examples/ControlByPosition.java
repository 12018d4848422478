package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import no.hials.crosscom.control.ControlLoop;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.LoopConfig;
import no.hials.crosscom.control.LoopStatistics.TrackingError;
import no.hials.crosscom.control.StopReason;
import no.hials.crosscom.control.Twist;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.KrlFileException;

/**
 * Moves the tool along a circle by a law that returns its position at each time. {@code
 * krl/follow_pos.src} moves the robot.
 */
public final class ControlByPosition {
  private static final double RADIUS = 10; // mm
  private static final double SECONDS = 1.5;

  private ControlByPosition() {}

  /**
   * Runs the example. <b>With arguments it moves that robot</b>: T1, and a hand on the enabling
   * switch.
   *
   * @param args {@code HOST PORT} of a controller in which {@code FOLLOW_POS} and {@code JOV_SPS}
   *     run, or nothing for a simulated controller
   * @throws IOException if a file could not be read, an access failed, or the loop refused to start
   * @throws KrlFileException if a file has errors
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args)
      throws IOException, KrlFileException, InterruptedException {
    try (Cell cell = Cell.of(args, "follow_pos.src", "JOV_POS")) {
      Frame start = cell.client().read("$POS_ACT", Frame.class);
      LoopConfig config =
          LoopConfig.create(
              cfg ->
                  cfg.period(Duration.ofMillis(20))
                      .noInput() // the law moves the robot without an input device
                      .duration(Duration.ofSeconds(2)) // then it stands still
                      .safety(cell::limit));
      StopReason reason;
      try (ControlLoop loop = ControlLoop.start(cell.client(), config, circle(start))) {
        reason = loop.await();
        System.out.println(reason);
        for (TrackingError error : loop.statistics().errors()) {
          System.out.printf(
              Locale.ROOT,
              "%s: at most %.2f %s from its target%n",
              error.quantity(),
              error.maximum(),
              error.unit());
        }
      }
      double away = cell.client().read("$POS_ACT", Frame.class).distance(start);
      boolean closed = reason.isPlanned() && away < 1;
      System.out.println(
          closed ? "the circle is closed" : "the circle is not closed: " + away + " mm from start");
    }
  }

  /** Returns a circle in the Y-Z plane that starts and ends at the robot's position. */
  private static Law circle(Frame start) {
    return Law.cartesianPosition(
        state -> {
          double angle = 2 * Math.PI * Math.min(1, state.time() / SECONDS);
          double y = RADIUS * Math.sin(angle);
          double z = RADIUS * (1 - Math.cos(angle));
          return Twist.linear(0, y, z).move(start, 1);
        });
  }
}
