package no.hials.crosscom.lab.experiment;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import no.hials.crosscom.control.ControlLoop;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.LoopConfig;
import no.hials.crosscom.control.LoopStatistics;
import no.hials.crosscom.control.Safety;
import no.hials.crosscom.control.StopReason;
import no.hials.crosscom.control.Trace;
import no.hials.crosscom.kinematics.Axes;
import no.hials.crosscom.protocol.code.OperatingMode;

/**
 * What a loop has done.
 *
 * @param name what the chart and the files call it; empty if it is the only one of its experiment
 * @param end why it ended
 * @param statistics its numbers
 * @param trace its cycles, all of them
 */
public record Run(String name, StopReason end, LoopStatistics statistics, Trace trace) {

  /** Cycles beyond those that should be, as the first and the last are both in the time. */
  private static final int SPARE_CYCLES = 10;

  /**
   * How long a loop lets the robot stand before, at most: the first cycles of a process are slow.
   */
  private static final Duration WARM_UP = Duration.ofSeconds(10);

  /**
   * Runs a loop on a robot of its own, until its time is over or it stops the robot.
   *
   * @param start where the axes are at first
   */
  static Run of(
      String name, Experiment.Settings settings, Axes start, RobotProgram program, Law law)
      throws ControlRefusedException, IOException {
    return of(name, settings, start, program, program.standing(), law);
  }

  /**
   * Does the same.
   *
   * @param standing lets the robot stand, in the way of the law if its first cycle is not to be
   *     slower than the others
   */
  static Run of(
      String name,
      Experiment.Settings settings,
      Axes start,
      RobotProgram program,
      Law standing,
      Law law)
      throws ControlRefusedException, IOException {
    try (SimulatedRobot robot = SimulatedRobot.start(settings.latency(), start, program)) {
      Duration length = settings.length();
      Duration warmUp = length.dividedBy(10);
      run(
          "",
          robot,
          config(settings, warmUp.compareTo(WARM_UP) < 0 ? warmUp : WARM_UP, program),
          standing);
      return run(name, robot, config(settings, length, program), law);
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

  private static Run run(String name, SimulatedRobot robot, LoopConfig config, Law law)
      throws ControlRefusedException {
    try (ControlLoop loop = ControlLoop.start(robot.client(), config, law)) {
      StopReason end = await(loop);
      return new Run(name, end, loop.statistics(), loop.trace());
    }
  }

  /** Sets limits that are wider than the defaults, with patience for a computer that is busy. */
  private static void limits(Safety.Builder safety) {
    safety
        .modes(OperatingMode.AUT)
        .path(100, 25, 75)
        .rotation(30, 8, 20)
        .axes(60, 8, 20)
        .maxFeedbackAge(Duration.ofSeconds(1))
        .maxStall(Duration.ofSeconds(3))
        .watchdog(Duration.ofSeconds(4));
  }

  private static StopReason await(ControlLoop loop) {
    try {
      return loop.await();
    } catch (InterruptedException e) {
      loop.close();
      Thread.currentThread().interrupt();
      return loop.stopReason().orElseThrow();
    }
  }

  /** Returns its cycles. */
  List<Trace.Cycle> cycles() {
    return trace.cycles();
  }
}
