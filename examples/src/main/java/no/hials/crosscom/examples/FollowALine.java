package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.Locale;
import no.hials.crosscom.control.ControlLoop;
import no.hials.crosscom.control.DampedLeastSquares;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.LoopConfig;
import no.hials.crosscom.control.State;
import no.hials.crosscom.control.Twist;
import no.hials.crosscom.kinematics.RobotModel;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.KrlFileException;
import org.jspecify.annotations.Nullable;

/**
 * Follows a straight line with its own control law: it computes the axis velocities by damped least
 * squares, without the robot's inverse kinematics. {@code krl/ext_move_axis.src} moves the robot.
 */
public final class FollowALine {
  private static final Twist ALONG = Twist.linear(0, 20, -10); // mm/s
  private static final double GAIN = 2; // 1/s
  private static final double DAMPING = 0.1;

  private FollowALine() {}

  /**
   * Runs the example. <b>With arguments it moves that robot</b>: T1, and a hand on the enabling
   * switch.
   *
   * @param args {@code HOST PORT} of a KR 6 R900 sixx whose controller runs {@code EXT_MOVE_AXIS}
   *     and {@code JOV_SPS}, or nothing for a simulated controller
   * @throws IOException if a file could not be read, an access failed, or the loop refused to start
   * @throws KrlFileException if a file has errors
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args)
      throws IOException, KrlFileException, InterruptedException {
    try (Cell cell = Cell.of(args, "ext_move_axis.src", "JOV_STEPS")) {
      LoopConfig config =
          LoopConfig.create(
              cfg ->
                  cfg.period(Duration.ofMillis(12))
                      .noInput() // the law moves the robot without an input device
                      .duration(Duration.ofSeconds(2))
                      .safety(cell::limit));
      LineController line = new LineController(RobotModel.kr6r900sixx());
      try (ControlLoop loop = ControlLoop.start(cell.client(), config, line)) {
        System.out.println(loop.await());
      }
      line.print();
    }
  }

  /** Called by the thread of the loop, and printed after the loop has ended. */
  private static final class LineController implements Law.JointVelocity {
    private final RobotModel robot;
    private final DampedLeastSquares solver;
    private @Nullable Frame start;
    private double wayMm;
    private double errorMm;

    LineController(RobotModel robot) {
      this.robot = robot;
      this.solver = new DampedLeastSquares(robot, DAMPING);
    }

    @Override
    public Axis velocity(State state) {
      Frame actual = robot.forward(state.axes());
      if (start == null) {
        start = actual; // the line starts at the robot's position
      }
      Frame wanted = ALONG.move(start, state.time());
      wayMm = actual.distance(start);
      errorMm = actual.distance(wanted);
      // the velocity of the point, plus a correction back to it
      Twist twist = ALONG.plus(Twist.between(actual, wanted).times(GAIN));
      return solver.velocity(state.axes(), twist);
    }

    void print() {
      System.out.printf(
          Locale.ROOT, "%.1f mm along the line, %.1f mm from its target%n", wayMm, errorMm);
    }
  }
}
