package no.hials.crosscom.lab.experiment;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import no.hials.crosscom.control.ControlLoop;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.LoopConfig;
import no.hials.crosscom.control.LoopStatistics;
import no.hials.crosscom.control.Safety;
import no.hials.crosscom.control.StopReason;
import no.hials.crosscom.control.StopReason.StopKind;
import no.hials.crosscom.control.Trace;
import no.hials.crosscom.protocol.code.OperatingMode;
import no.hials.crosscom.protocol.value.Axis;
import org.jspecify.annotations.Nullable;

/**
 * A run of a control loop.
 *
 * @param name its name in the chart and the files; empty for the only run of an experiment
 * @param end the reason it ended
 * @param statistics its statistics
 * @param trace all its cycles
 */
public record Run(String name, StopReason end, LoopStatistics statistics, Trace trace) {

  /** Room for more cycles than periods in the time, which includes the first and the last cycle. */
  private static final int SPARE_CYCLES = 10;

  /** A run of fewer cycles shows nothing. */
  private static final int MIN_CYCLES = 2;

  /** The maximum time at rest before a run, because the first cycles of a process are slow. */
  private static final Duration WARM_UP = Duration.ofSeconds(10);

  /**
   * Runs a loop on a new simulated robot until its time is over or it stops the robot.
   *
   * @param start the initial position of the axes
   * @return the run; null if the observer ended it before anything was measured
   */
  static @Nullable Run of(
      String name,
      Experiment.Settings settings,
      Experiment.CycleObserver observer,
      Axis start,
      RobotProgram program,
      Law law)
      throws ControlRefusedException, IOException {
    return of(name, settings, observer, start, program, program.standing(), law);
  }

  /**
   * Runs a loop after the robot was at rest.
   *
   * @param standing the law that keeps the robot at rest; of the same kind as the law of the run,
   *     so that its first cycle is not slower than the others
   */
  static @Nullable Run of(
      String name,
      Experiment.Settings settings,
      Experiment.CycleObserver observer,
      Axis start,
      RobotProgram program,
      Law standing,
      Law law)
      throws ControlRefusedException, IOException {
    String suffix = name.isEmpty() ? "" : ", " + name;
    if (!observer.goesOn("starting the robot" + suffix, Duration.ZERO, Duration.ZERO)) {
      return null;
    }
    try (SimulatedRobot robot = SimulatedRobot.start(settings.latency(), start, program)) {
      Duration length = settings.length();
      Duration tenth = length.dividedBy(10);
      Duration warmUp = tenth.compareTo(WARM_UP) < 0 ? tenth : WARM_UP;
      Phase rest = new Phase("warming up" + suffix, warmUp, observer);
      Phase moves = new Phase("measuring" + suffix, length, observer);
      if (rest.begins()) {
        run("", robot, config(settings, warmUp, program), standing, rest);
      }
      if (!moves.begins()) {
        return null;
      }
      Run run = run(name, robot, config(settings, length, program), law, moves);
      if (run.cycles().size() >= MIN_CYCLES || !run.end().isPlanned()) {
        return run;
      }
      if (run.end().kind() == StopKind.ASKED) {
        return null;
      }
      throw new ControlRefusedException(
          new StopReason(
              StopKind.TIME_OVER,
              String.format(
                  Locale.ROOT,
                  "a run must have at least %d cycles, had %d in %d ms;"
                      + " it needs more time, or the computer is too busy",
                  MIN_CYCLES,
                  run.cycles().size(),
                  length.toMillis()),
              null));
    }
  }

  /** The time of one loop. */
  private record Phase(String name, Duration length, Experiment.CycleObserver observer) {
    boolean begins() {
      return goesOn(Duration.ZERO);
    }

    boolean goesOn(Duration elapsed) {
      return observer.goesOn(name, elapsed, length);
    }
  }

  private static LoopConfig config(
      Experiment.Settings settings, Duration length, RobotProgram program) {
    return LoopConfig.create(
        cfg ->
            cfg.period(settings.period())
                .stepTime(settings.step())
                .target(program.target())
                .duration(length)
                .noInput()
                .safety(Run::limits)
                .traceLength(
                    (int) (length.toNanos() / settings.period().toNanos()) + SPARE_CYCLES));
  }

  private static Run run(String name, SimulatedRobot robot, LoopConfig config, Law law, Phase phase)
      throws ControlRefusedException {
    try (ControlLoop loop = ControlLoop.start(robot.client(), config, law)) {
      StopReason end = await(loop, phase);
      return new Run(name, end, loop.statistics(), loop.trace());
    }
  }

  /** Sets limits wider than the defaults, so that a busy computer does not end the run. */
  private static void limits(Safety.Builder safety) {
    safety
        .modes(OperatingMode.AUT)
        .path(100, 25, 75)
        .rotation(30, 8, 20)
        .axes(60, 8, 20)
        .wristMargin(0) // they compare methods near the singularity
        .maxFeedbackAge(Duration.ofSeconds(1))
        .maxStall(Duration.ofSeconds(3))
        .watchdog(Duration.ofSeconds(4));
  }

  private static StopReason await(ControlLoop loop, Phase phase) {
    long start = System.nanoTime();
    try {
      while (!ends(loop)) {
        if (!phase.goesOn(Duration.ofNanos(System.nanoTime() - start))) {
          loop.stop();
        }
      }
      return loop.await();
    } catch (InterruptedException e) {
      loop.close();
      Thread.currentThread().interrupt();
      return loop.stopReason().orElseThrow();
    }
  }

  /** Returns whether the loop ends within a tenth of a second. */
  private static boolean ends(ControlLoop loop) throws InterruptedException {
    try {
      loop.ended().get(100, TimeUnit.MILLISECONDS);
      return true;
    } catch (ExecutionException e) {
      return true;
    } catch (TimeoutException e) {
      return false;
    }
  }

  List<Trace.Cycle> cycles() {
    return trace.cycles();
  }
}
