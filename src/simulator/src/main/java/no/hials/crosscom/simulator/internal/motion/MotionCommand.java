package no.hials.crosscom.simulator.internal.motion;

import java.util.List;
import java.util.OptionalDouble;
import no.hials.crosscom.protocol.value.Axis;
import no.hials.crosscom.protocol.value.Frame;

/** One motion of a program, as the advance run has resolved it. */
public sealed interface MotionCommand {
  /** Returns the number of the motion, by which events name it. */
  long id();

  /** Returns the TCP in the flange ({@code $TOOL}). */
  Frame tool();

  /** Returns where the blend into the next motion can start. */
  ApproximationZone approximation();

  /**
   * Moves all axes so that they start and end together, as KRL's PTP; the slowest sets the time.
   *
   * @param target the end of the axes, degrees
   * @param rates the speeds of the axes
   */
  record PointToPoint(
      long id, Axis target, AxisRates rates, Frame tool, ApproximationZone approximation)
      implements MotionCommand {}

  /**
   * Moves the TCP on a straight line, as KRL's LIN.
   *
   * @param target the end of the TCP, in {@code $ROBROOT}
   * @param rates the speed of the TCP
   * @param orientation the orientation on the path
   */
  record Linear(
      long id,
      Frame target,
      Frame tool,
      PathRates rates,
      OrientationControl orientation,
      ApproximationZone approximation)
      implements MotionCommand {}

  /**
   * Moves the TCP on the circle through its start, an auxiliary point and a target, as KRL's CIRC.
   *
   * <p>The orientation turns from that at the start to that of the target, whatever the angle; the
   * orientation of the auxiliary point is ignored (assumed for both, and {@code $CIRC_TYPE} is
   * #BASE).
   *
   * @param auxiliary a point of the circle, in {@code $ROBROOT}
   * @param target the end of the TCP, or a second point of the circle if there is an angle
   * @param angle the angle on the circle (KRL's CA), degrees: positive over the auxiliary point to
   *     the target, negative in the other direction, beyond 360 more than one turn; empty to end at
   *     the target
   * @param rates the speed of the TCP
   * @param orientation the orientation on the path
   */
  record Circular(
      long id,
      Frame auxiliary,
      Frame target,
      OptionalDouble angle,
      Frame tool,
      PathRates rates,
      OrientationControl orientation,
      ApproximationZone approximation)
      implements MotionCommand {
    public Circular {
      if (angle.isPresent() && !Double.isFinite(angle.getAsDouble())) {
        throw new IllegalArgumentException(
            "the circular angle must be finite, is " + angle.getAsDouble());
      }
    }
  }

  /**
   * A section at constant speed ({@code CONST_VEL}).
   *
   * @param from where it starts
   * @param to where it ends
   */
  record ConstantSpeed(PathPoint from, PathPoint to) {}

  /**
   * A section that takes some time ({@code TIME_BLOCK}).
   *
   * @param from the point at which it starts
   * @param to the point at which it ends
   * @param seconds the time at 100 % override; more if the robot is not that fast
   */
  record Timed(int from, int to, double seconds) {}

  /**
   * The sections of a spline block whose speed is determined otherwise.
   *
   * @param times planned first
   * @param constants planned with the times of {@code times}
   */
  record Sections(List<Timed> times, List<ConstantSpeed> constants) {
    /** No section. */
    static final Sections NONE = new Sections(List.of(), List.of());

    /** Copies the lists. */
    public Sections {
      times = List.copyOf(times);
      constants = List.copyOf(constants);
    }
  }

  /**
   * Moves the TCP through points, as KRL's SPLINE.
   *
   * @param segments at least one
   */
  record Spline(
      long id,
      List<SplineSegment> segments,
      Sections sections,
      Frame tool,
      ApproximationZone approximation)
      implements MotionCommand {}

  /**
   * A segment of {@link AxisSpline}.
   *
   * @param target the end of the axes, degrees
   * @param rates the speeds of the axes
   * @param external the end of the external axes
   */
  record AxisSegment(Axis target, AxisRates rates, ExternalTarget external) {}

  /**
   * Moves all axes through points, as KRL's PTP_SPLINE.
   *
   * @param segments at least one
   */
  record AxisSpline(
      long id,
      List<AxisSegment> segments,
      Sections sections,
      Frame tool,
      ApproximationZone approximation)
      implements MotionCommand {}
}
