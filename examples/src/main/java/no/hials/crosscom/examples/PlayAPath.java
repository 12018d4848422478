package no.hials.crosscom.examples;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.PathPlayer;
import no.hials.crosscom.control.Safety;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.KrlFileException;

/**
 * Plays a path of ten points with {@code krl/play_path.src}, and shows that a path with a bad point
 * is refused as a whole. {@link FollowAPath} does the same without the player.
 */
public final class PlayAPath {
  private static final Duration LIMIT = Duration.ofSeconds(30);

  private PlayAPath() {}

  /**
   * Runs the example. <b>With arguments it moves that robot</b>: T1, and a hand on the enabling
   * switch.
   *
   * @param args {@code HOST PORT} of a controller in which {@code PLAY_PATH} and {@code JOV_SPS}
   *     run, or nothing for a simulated controller
   * @throws IOException if a file could not be read, an access failed, or the path was refused
   * @throws KrlFileException if a file has errors
   * @throws InterruptedException if the wait was interrupted
   */
  public static void main(String[] args)
      throws IOException, KrlFileException, InterruptedException {
    try (Cell cell = Cell.of(args, "play_path.src", "JOV_RESULT")) {
      PathPlayer player = new PathPlayer(cell.client(), Safety.create(cell::limit));
      Axis start = Axis.of(cell.client().readJointAngles());
      List<Axis> points = new ArrayList<>();
      for (int i = 1; i <= 10; i++) {
        // A1 to 5 degrees and back, A5 by 0.5 degrees a point
        double swing = 0.2 * i * (10 - i);
        points.add(start.plus(Axis.of(swing, 0, 0, 0, 0.5 * i, 0)));
      }
      player.playAxes(points, LIMIT); // returns when the robot is at the last point
      Axis end = Axis.of(cell.client().readJointAngles());
      System.out.println("came to " + Arrays.toString(end.toArray()) + " degrees");

      points.add(start.with(0, 169)); // too close to the end of A1's range
      try {
        player.playAxes(points, LIMIT);
      } catch (ControlRefusedException e) {
        System.out.println("nothing was moved: " + e.getMessage());
      }
    }
  }
}
