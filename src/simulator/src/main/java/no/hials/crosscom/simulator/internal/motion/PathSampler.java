package no.hials.crosscom.simulator.internal.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.AxisLimit;
import no.hials.crosscom.simulator.internal.motion.MotionProblem.Singularity;
import org.jspecify.annotations.Nullable;

/**
 * The axes along a path, computed before the robot moves: the points are close enough for the
 * inverse to follow from one to the next, as far as the robot can follow the path.
 */
final class PathSampler {
  /** The number of points beyond a limit that are computed. */
  private static final int BEYOND = 8;

  /** The largest turn of an axis between two points, degrees. */
  private static final double STEP = 2;

  /** The smallest distance between two points, in parts of the path. */
  private static final double CLOSEST = 1e-6;

  /** A larger turn between the closest points, degrees, is a jump. */
  private static final double JUMP = 5;

  private final Arm arm;
  private final Solver solver;
  private final List<Double> found = new ArrayList<>();
  private final List<Axis> foundAxes = new ArrayList<>();
  private double[] parameters = {};
  private List<Axis> axes = List.of();
  private @Nullable MotionProblem problem;

  private PathSampler(Arm arm, Solver solver) {
    this.arm = arm;
    this.solver = solver;
  }

  /**
   * Follows a path from the axes at its start.
   *
   * @param fewest the number of points even if the axes hardly turn
   */
  static PathSampler of(Arm arm, Solver solver, Axis start, int fewest) {
    double[] even = new double[fewest];
    Arrays.setAll(even, i -> (i + 1.0) / fewest);
    return of(arm, solver, start, even);
  }

  /**
   * Follows a path from the axes at its start.
   *
   * @param through points to compute, ascending to 1
   */
  static PathSampler of(Arm arm, Solver solver, Axis start, double[] through) {
    PathSampler sampler = new PathSampler(arm, solver);
    sampler.put(0, start);
    for (int i = 0; i < through.length && sampler.problem == null; i++) {
      sampler.problem = sampler.extend(through[i]);
    }
    if (sampler.problem instanceof AxisLimit limit) {
      sampler.problem = sampler.furthest(limit);
    }
    sampler.parameters = sampler.found.stream().mapToDouble(Double::doubleValue).toArray();
    sampler.axes = List.copyOf(sampler.foundAxes);
    return sampler;
  }

  /** Returns the parameters of the points, ascending from 0; to 1 if there is no problem. */
  double[] parameters() {
    return parameters.clone();
  }

  List<Axis> axes() {
    return axes;
  }

  /** Returns the reason why the robot cannot follow the path beyond the last point. */
  @Nullable MotionProblem problem() {
    return problem;
  }

  double lastParameter() {
    return parameters[parameters.length - 1];
  }

  Axis lastAxes() {
    return foundAxes.get(foundAxes.size() - 1);
  }

  /** Returns the axes between the first and the last point. */
  Axis at(double parameter) throws MotionRefusedException {
    return arm.clamped(solver.axes(parameter, near(parameter)));
  }

  /** Returns the axes at the last point before a parameter. */
  Axis near(double parameter) {
    int index = Arrays.binarySearch(parameters, parameter);
    return axes.get(index >= 0 ? index : -index - 2);
  }

  private void put(double parameter, Axis at) {
    found.add(parameter);
    foundAxes.add(arm.clamped(at));
  }

  /** Adds points up to a parameter, or to the first that fails; returns the reason. */
  private @Nullable MotionProblem extend(double to) {
    double from = found.get(found.size() - 1);
    MotionProblem inTheWay;
    try {
      Axis there = solver.axes(to, lastAxes());
      inTheWay = inTheWay(there, to - from > CLOSEST ? STEP : JUMP);
      if (inTheWay == null) {
        put(to, there);
        return null;
      }
    } catch (MotionRefusedException e) {
      inTheWay = e.problem();
    }
    if (to - from <= CLOSEST) {
      return inTheWay;
    }
    MotionProblem before = extend((from + to) / 2);
    return before == null ? extend(to) : before;
  }

  private @Nullable MotionProblem inTheWay(Axis there, double mostTurn) {
    double turn = there.largestDifference(lastAxes());
    if (turn > mostTurn) {
      Axis turns = there.minus(lastAxes());
      int axis = 0;
      while (Math.abs(turns.get(axis)) < turn) {
        axis++;
      }
      return new Singularity(axis, turn);
    }
    return arm.beyondLimit(there).orElse(null);
  }

  /** Continues without limits, to find the furthest angle of the axis. */
  private AxisLimit furthest(AxisLimit limit) {
    AxisLimit furthest = limit;
    Axis last = lastAxes();
    double from = found.get(found.size() - 1);
    try {
      for (int i = 1; i <= BEYOND; i++) {
        last = solver.axes(Math.min(1, from + (1 - from) * i / BEYOND), last);
        double value = last.get(limit.axis());
        if (Math.abs(value - limit.limit()) > Math.abs(furthest.value() - limit.limit())
            && value > limit.limit() == limit.value() > limit.limit()) {
          furthest = new AxisLimit(limit.axis(), limit.limit(), value);
        }
      }
    } catch (MotionRefusedException e) {
      return furthest;
    }
    return furthest;
  }
}
