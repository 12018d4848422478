package no.hials.crosscom.lab.experiment;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import no.hials.crosscom.control.ControlRefusedException;

/** An experiment on a simulated robot and its measurements. */
public interface Experiment {

  /**
   * Returns all experiments.
   *
   * @return the experiments with figures first, ordered by kind of control
   */
  static List<Experiment> all() {
    List<Experiment> all = new ArrayList<>();
    for (ControlMethod control : ControlMethod.values()) {
      for (Shape shape : Shape.values()) {
        all.add(new FollowShape(control, shape));
      }
    }
    all.add(new FollowLine());
    all.add(new Endurance());
    return List.copyOf(all);
  }

  /**
   * Returns the name.
   *
   * @return the name, such as {@code position-circle}
   */
  String name();

  /**
   * Returns a description.
   *
   * @return a sentence
   */
  String description();

  /**
   * Returns the names of the loops, which run one after the other.
   *
   * @return one name per loop; the name is empty for a single loop
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
   * Runs the experiment in real time and blocks until it ends.
   *
   * @param settings the duration, the period and the latency
   * @param observer is told how far it is, and can end it
   * @return the outcome, even if the loop stopped the robot; if the observer ended it, of what was
   *     measured until then, or empty if that is nothing
   * @throws ControlRefusedException if a loop did not start, or had no time for two cycles
   * @throws IOException if the simulated controller cannot be started or reached
   */
  Optional<ExperimentResult> run(Settings settings, CycleObserver observer)
      throws ControlRefusedException, IOException;

  /** Follows an experiment. */
  @FunctionalInterface
  interface CycleObserver {
    /**
     * Called when a phase begins, and ten times a second while a loop runs.
     *
     * @param phase the phase
     * @param elapsed the time since the phase began
     * @param length the time that the phase takes; zero if that is not known
     * @return false to end the experiment
     */
    boolean goesOn(String phase, Duration elapsed, Duration length);
  }

  /**
   * The settings of an experiment.
   *
   * @param length the duration
   * @param lap the time for one lap of the figure
   * @param period the period of the control loop, 4 ms to 1 s
   * @param step the assumed time of the program for one increment, 4 ms to 1 s
   * @param latency the access time of the simulated controller, as {@link
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
