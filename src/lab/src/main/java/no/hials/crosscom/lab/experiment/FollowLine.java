package no.hials.crosscom.lab.experiment;

import static no.hials.crosscom.kinematics.Frames.angle;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import no.hials.crosscom.control.ControlRefusedException;
import no.hials.crosscom.control.DampedLeastSquares;
import no.hials.crosscom.control.Law;
import no.hials.crosscom.control.Trace;
import no.hials.crosscom.control.Twist;
import no.hials.crosscom.kinematics.UnreachableException;
import no.hials.crosscom.lab.plot.Chart;
import no.hials.crosscom.lab.plot.Panel;
import no.hials.crosscom.lab.plot.Quantity;
import no.hials.crosscom.lab.plot.Series;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/**
 * Follows a straight line twice with the same velocity of the tool: once the controller computes
 * the axes, once damped least squares.
 */
final class FollowLine implements Experiment {
  private static final String KRC = "controller's kinematics";
  private static final String OWN = "damped least squares";
  private static final String KRC_LOOP = "krc";
  private static final String OWN_LOOP = "dls";
  private static final double DAMPING = 0.1;

  /** The gain of the correction towards the line, 1/s. */
  private static final double GAIN = 2;

  /** The distance of a lap, mm. */
  private static final Twist WAY = Twist.linear(0, 240, 0);

  /** Half way: near the singularity of the wrist at A5 = 0. */
  private static final Axis HALF_WAY = Axis.of(0, -90, 90, 0, 10, 0);

  private static final Axis START_AXES = start();
  private static final Frame START = SimulatedRobot.MODEL.forward(START_AXES);
  private static final int AXES = 6;
  private static final int HEIGHT = 1700;

  /** The positions of axes and tool in a run. */
  private record Motion(String name, Run run, List<Axis> axes, List<Frame> tool) {
    double[] times() {
      return Plots.times(run.cycles());
    }

    double[] each(ToDoubleFunction<Frame> value) {
      return tool.stream().mapToDouble(value).toArray();
    }
  }

  @Override
  public String name() {
    return "line-dls";
  }

  @Override
  public String description() {
    return "A straight line by damped least squares (EXT_MOVE_AXIS), next to the controller's own"
        + " kinematics (ACTUATOR).";
  }

  @Override
  public List<String> loops() {
    return List.of(KRC_LOOP, OWN_LOOP);
  }

  @Override
  public Settings usual() {
    return Settings.OF_THE_PAPERS;
  }

  @Override
  public Optional<ExperimentResult> run(Settings settings, CycleObserver observer)
      throws ControlRefusedException, IOException {
    double lap = settings.lapSeconds();
    Run krc =
        Run.of(
            KRC_LOOP,
            settings,
            observer,
            START_AXES,
            RobotProgram.ACTUATOR,
            Law.cartesianVelocity(state -> wanted(state.position(), state.time(), lap)));
    DampedLeastSquares solver = new DampedLeastSquares(SimulatedRobot.MODEL, DAMPING);
    Run own =
        Run.of(
            OWN_LOOP,
            settings,
            observer,
            START_AXES,
            RobotProgram.EXT_MOVE_AXIS,
            Law.jointVelocity(
                state -> {
                  Frame tool = SimulatedRobot.MODEL.forward(state.axes());
                  return solver.velocity(state.axes(), wanted(tool, state.time(), lap));
                }));
    List<Motion> motions = new ArrayList<>();
    if (krc != null) {
      motions.add(ofTool(krc));
    }
    if (own != null) {
      motions.add(ofAxes(own));
    }
    return motions.isEmpty() ? Optional.empty() : Optional.of(outcome(motions, settings));
  }

  /**
   * Returns the start, computed backwards from half way so that the arm has the same configuration.
   */
  private static Axis start() {
    Frame middle = SimulatedRobot.MODEL.forward(HALF_WAY);
    Axis axes = HALF_WAY;
    int steps = 50;
    for (int i = 1; i <= steps; i++) {
      axes = inverse(WAY.move(middle, -0.5 * i / steps), axes);
    }
    return axes;
  }

  private static Axis inverse(Frame tool, Axis near) {
    try {
      return SimulatedRobot.MODEL.inverse(tool, near);
    } catch (UnreachableException e) {
      throw new IllegalStateException("the robot cannot be at " + tool, e);
    }
  }

  /** Returns the set point of the tool on the line. */
  private static Frame line(double time, double lap) {
    return WAY.move(START, Math.min(1, time / lap));
  }

  private static Twist wanted(Frame tool, double time, double lap) {
    Twist back = Twist.between(tool, line(time, lap)).times(GAIN);
    return time < lap ? back.plus(WAY.times(1 / lap)) : back;
  }

  // a run measures either the axes or the tool; the other is computed

  private static Motion ofAxes(Run run) {
    List<Axis> axes = run.cycles().stream().map(FollowLine::axes).toList();
    List<Frame> tool = axes.stream().map(SimulatedRobot.MODEL::forward).toList();
    return new Motion(OWN, run, axes, tool);
  }

  private static Axis axes(Trace.Cycle cycle) {
    return Axis.of(cycle.actual().stream().mapToDouble(Double::doubleValue).toArray());
  }

  private static Motion ofTool(Run run) {
    List<Frame> tool = new ArrayList<>();
    List<Axis> axes = new ArrayList<>();
    Axis near = START_AXES;
    for (Trace.Cycle cycle : run.cycles()) {
      List<Double> p = cycle.actual();
      Frame frame = new Frame(p.get(0), p.get(1), p.get(2), p.get(3), p.get(4), p.get(5));
      near = inverse(frame, near);
      tool.add(frame);
      axes.add(near);
    }
    return new Motion(KRC, run, axes, tool);
  }

  // measurements

  /** Returns the distance of the tool from the nearest point of the line. */
  private static double deviation(Frame tool) {
    double x = tool.x() - START.x();
    double y = tool.y() - START.y();
    double z = tool.z() - START.z();
    double along = (x * WAY.x() + y * WAY.y() + z * WAY.z()) / WAY.speed();
    return Math.sqrt(Math.max(0, x * x + y * y + z * z - along * along));
  }

  private static double[] lag(Motion motion, double lap) {
    double[] lag = motion.times();
    for (int i = 0; i < lag.length; i++) {
      lag[i] = motion.tool.get(i).distance(line(lag[i], lap));
    }
    return lag;
  }

  private static ExperimentResult outcome(List<Motion> motions, Settings settings) {
    List<ExperimentResult.Figure> figures = new ArrayList<>();
    for (Motion motion : motions) {
      String name = ", " + motion.run.name();
      figures.addAll(
          ErrorMetrics.figures("tracking error" + name, "mm", lag(motion, settings.lapSeconds())));
      figures.addAll(
          ErrorMetrics.figures("deviation" + name, "mm", motion.each(FollowLine::deviation)));
      figures.addAll(
          ErrorMetrics.figures("rotation" + name, "°", motion.each(tool -> angle(tool, START))));
    }
    return new ExperimentResult(
        motions.stream().map(Motion::run).toList(),
        figures,
        new Chart(settings.title("line-dls: two kinematics"), panels(motions, settings), 2),
        HEIGHT);
  }

  private static List<Panel> panels(List<Motion> motions, Settings settings) {
    List<Panel> panels = new ArrayList<>();
    panels.add(path(motions));
    panels.add(
        overTime(
            "deviation from the line",
            new Quantity("distance", "mm"),
            motions,
            motion -> motion.each(FollowLine::deviation)));
    panels.add(
        overTime(
            "tracking error",
            new Quantity("distance", "mm"),
            motions,
            motion -> lag(motion, settings.lapSeconds())));
    panels.add(
        overTime(
            "rotation of the tool, which should be none",
            new Quantity("angle", "°"),
            motions,
            motion -> motion.each(tool -> angle(tool, START))));
    for (int i = 0; i < AXES; i++) {
      int axis = i;
      panels.add(
          overTime(
              "A" + (i + 1),
              new Quantity("A" + (i + 1), "°"),
              motions,
              motion -> motion.axes.stream().mapToDouble(axes -> axes.get(axis)).toArray()));
    }
    panels.add(
        overTime(
            "access times of each cycle, reading and writing",
            new Quantity("time", "ms"),
            motions,
            motion -> Plots.values(motion.run.cycles(), cycle -> cycle.read() + cycle.write())));
    return panels;
  }

  private static Panel path(List<Motion> motions) {
    List<Series> series = new ArrayList<>();
    series.add(
        Series.of(
            "desired",
            Series.Style.GUIDE,
            new double[] {START.y(), START.y() + WAY.y()},
            new double[] {START.z(), START.z() + WAY.z()}));
    for (Motion motion : motions) {
      series.add(
          Series.of(motion.name, Series.Style.LINE, motion.each(Frame::y), motion.each(Frame::z)));
    }
    return Panel.of(
        "path from the front",
        new Quantity("Y", "mm"),
        new Quantity("Z", "mm"),
        Panel.Scale.EQUAL,
        series);
  }

  private static Panel overTime(
      String title, Quantity y, List<Motion> motions, Function<Motion, double[]> values) {
    return Plots.overTime(
        title,
        y,
        motions.stream()
            .map(each -> Series.of(each.name, Series.Style.LINE, each.times(), values.apply(each)))
            .toList());
  }
}
