package no.hials.crosscom.lab.experiment;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import no.hials.crosscom.control.ControlRefusedException;

/** Something that a simulated robot is to do, and what of it is measured. */
public interface Experiment {

  /**
   * Lists all experiments.
   *
   * @return those with figures first, each kind of control after the other
   */
  static List<Experiment> all() {
    List<Experiment> all = new ArrayList<>();
    for (Control control : Control.values()) {
      for (Shape shape : Shape.values()) {
        all.add(new FollowShape(control, shape));
      }
    }
    all.add(new FollowLine());
    all.add(new Endurance());
    return List.copyOf(all);
  }

  /**
   * Returns its name.
   *
   * @return such as {@code position-circle}
   */
  String name();

  /**
   * Returns a description.
   *
   * @return a sentence
   */
  String description();

  /**
   * Names its loops, which run one after the other.
   *
   * @return one name for each; empty for the only one
   */
  default List<String> loops() {
    return List.of("");
  }

  /**
   * Returns the default settings.
   *
   * @return the settings
   */
  Settings usual();

  /**
   * Runs it, in real time.
   *
   * @param settings how long, how often, and against which latency
   * @return what came out, also if the loop stopped the robot
   * @throws ControlRefusedException if a loop did not start
   * @throws IOException if the simulated controller cannot be started or reached
   */
  Outcome run(Settings settings) throws ControlRefusedException, IOException;

  /**
   * How an experiment runs.
   *
   * @param length how long
   * @param lap how long the robot has for the figure once
   * @param period of the control loop, 4 ms to 1 s
   * @param step how long the program is taken to need for one increment, 4 ms to 1 s
   * @param latency how long an access takes the simulated controller, as {@link
   *     no.hials.crosscom.mock.Latency#parse} reads it
   */
  record Settings(Duration length, Duration lap, Duration period, Duration step, String latency) {
    /** The settings of an experiment with the access times of the papers. */
    static final Settings OF_THE_PAPERS =
        new Settings(
            Duration.ofSeconds(10),
            Duration.ofSeconds(10),
            Duration.ofMillis(20),
            Duration.ofMillis(12),
            "krc4-2014");

    double lapSeconds() {
      return lap.toNanos() / 1e9;
    }

    /** Returns the title of a chart. */
    String title(String what) {
      return what + ", dt = " + period.toMillis() + " ms, simulated robot, latency " + latency;
    }
  }
}
