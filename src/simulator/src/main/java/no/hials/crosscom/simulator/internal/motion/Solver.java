package no.hials.crosscom.simulator.internal.motion;

import java.util.Locale;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.path.Point;

/** Computes the axes, inside their limits or not, for a parameter of a path. */
sealed interface Solver permits Solver.ByPose, Solver.ByAxes, Solver.ByWrist {
  /**
   * Returns the axes nearest to others.
   *
   * @throws MotionRefusedException if none exist
   */
  Axis axes(double parameter, Axis near) throws MotionRefusedException;

  /** Keeps the TCP and its orientation on the curve. */
  record ByPose(Arm arm, Curve curve, Frame flangeInTool) implements Solver {
    @Override
    public Axis axes(double parameter, Axis near) throws MotionRefusedException {
      return arm.inverse(curve.at(parameter), flangeInTool, near);
    }
  }

  /** Follows a curve of the axes. */
  record ByAxes(JointPath.Function curve) implements Solver {
    @Override
    public Axis axes(double parameter, Axis near) throws MotionRefusedException {
      return curve.at(parameter);
    }
  }

  /**
   * Turns A4 to A6 evenly from start to end, and keeps the TCP on the curve: A1 to A3 are found by
   * Newton's method.
   */
  record ByWrist(Arm arm, Curve curve, Frame tool, Axis start, Axis end) implements Solver {
    private static final int ITERATIONS = 20;

    /** The step for the derivatives, degrees. */
    private static final double STEP = 1e-4;

    /** The position is found when the TCP is this close, mm. */
    private static final double EXACT = 1e-7;

    /** The maximum angle that an axis turns in an iteration, degrees. */
    private static final double MAX_STEP = 20;

    @Override
    public Axis axes(double parameter, Axis near) throws MotionRefusedException {
      Point wanted = Point.of(curve.at(parameter));
      Axis wrist = start.plus(times(end.minus(start), parameter));
      Axis found = new Axis(near.a1(), near.a2(), near.a3(), wrist.a4(), wrist.a5(), wrist.a6());
      for (int i = 0; i < ITERATIONS; i++) {
        Point here = position(found);
        Point missing = wanted.minus(here);
        if (missing.length() < EXACT) {
          return found;
        }
        found = found.plus(step(found, here, missing));
      }
      throw unreachable(wanted);
    }

    /** Solves for the small turns of A1 to A3 that move the TCP by the missing distance. */
    private Axis step(Axis from, Point here, Point missing) throws MotionRefusedException {
      Point[] columns = new Point[3];
      for (int axis = 0; axis < columns.length; axis++) {
        Point moved = position(from.with(axis, from.get(axis) + STEP));
        columns[axis] = moved.minus(here).times(1 / STEP);
      }
      double determinant = columns[0].dot(columns[1].cross(columns[2]));
      double[] turns = {
        missing.dot(columns[1].cross(columns[2])) / determinant,
        missing.dot(columns[2].cross(columns[0])) / determinant,
        missing.dot(columns[0].cross(columns[1])) / determinant
      };
      double largest =
          Math.max(Math.abs(turns[0]), Math.max(Math.abs(turns[1]), Math.abs(turns[2])));
      if (!Double.isFinite(largest)) {
        throw unreachable(here.plus(missing));
      }
      double part = Math.min(1, MAX_STEP / largest);
      return new Axis(turns[0] * part, turns[1] * part, turns[2] * part, 0, 0, 0);
    }

    private Point position(Axis axes) {
      return Point.of(arm.tcp(axes, tool));
    }

    private static MotionRefusedException unreachable(Point point) {
      return new MotionRefusedException(
          new MotionProblem.OutOfReach(
              String.format(
                  Locale.ROOT,
                  "no A1 to A3 bring the TCP to X %.3f Y %.3f Z %.3f",
                  point.x(),
                  point.y(),
                  point.z())));
    }

    private static Axis times(Axis axes, double factor) {
      return new Axis(
          axes.a1() * factor,
          axes.a2() * factor,
          axes.a3() * factor,
          axes.a4() * factor,
          axes.a5() * factor,
          axes.a6() * factor);
    }
  }
}
