package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Frames;
import no.hials.crosscom.protocol.value.Frame;
import no.hials.crosscom.simulator.internal.path.ArcLength;
import no.hials.crosscom.simulator.internal.path.Point;

/** The path of the TCP: frames over a parameter that runs evenly from 0 to 1. */
sealed interface Curve permits Curve.Line, Curve.Carried, Curve.Blended, Arc, SplineCurve {
  /** Returns the TCP in {@code $ROBROOT}. */
  Frame at(double parameter);

  /** Returns the length, mm. */
  double length();

  /** Returns the turn of the orientation, degrees. */
  double angle();

  /** Returns whether an angle changes; if not, there is less to compute. */
  static boolean isTurn(Frame start, Frame end) {
    return start.a() != end.a() || start.b() != end.b() || start.c() != end.c();
  }

  /**
   * A path at which the robot's root moves evenly.
   *
   * @param curve the path, in the root at its start
   * @param way the way of the root, mm
   */
  record Carried(Curve curve, Point way) implements Curve {
    @Override
    public Frame at(double parameter) {
      Frame frame = curve.at(parameter);
      return Point.of(frame).minus(way.times(parameter)).turnedAs(frame);
    }

    @Override
    public double length() {
      return curve.length();
    }

    @Override
    public double angle() {
      return curve.angle();
    }
  }

  /**
   * The end of a path and the start of the next, summed up.
   *
   * @param leave where the path is left
   * @param join where the next one is joined
   * @param lengths from the part of the curve to the part of the sum
   */
  record Blended(Curve first, double leave, Curve second, double join, ArcLength lengths)
      implements Curve {
    static Frame sum(Curve first, double leave, Curve second, double join, double part) {
      return Blend.sum(
          first.at(Corner.first(leave, part)), second.at(Corner.second(join, part)), second.at(0));
    }

    @Override
    public Frame at(double parameter) {
      return sum(first, leave, second, join, lengths.parameter(parameter));
    }

    @Override
    public double length() {
      return lengths.length();
    }

    @Override
    public double angle() {
      return (1 - leave) * first.angle() + join * second.angle();
    }
  }

  /** A straight line. */
  record Line(Frame start, Frame end) implements Curve {
    @Override
    public Frame at(double parameter) {
      return Curve.isTurn(start, end)
          ? Frames.interpolate(start, end, parameter)
          : new Frame(
              start.x() + parameter * (end.x() - start.x()),
              start.y() + parameter * (end.y() - start.y()),
              start.z() + parameter * (end.z() - start.z()),
              start.a(),
              start.b(),
              start.c());
    }

    @Override
    public double length() {
      return start.distance(end);
    }

    @Override
    public double angle() {
      return Frames.angle(start, end);
    }
  }
}
