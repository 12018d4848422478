package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Frame;

/** The way of the TCP: frames over a parameter that goes evenly from 0 to 1. */
sealed interface Curve permits Curve.Line, Arc {
  /** Gives the TCP in {@code $ROBROOT}. */
  Frame at(double parameter);

  /** Gives the length of the way, mm. */
  double length();

  /** Gives by how much the orientation turns, degrees. */
  double angle();

  /** Says whether one of the angles differs; if none does, there is less to reckon. */
  static boolean isTurn(Frame start, Frame end) {
    return start.a() != end.a() || start.b() != end.b() || start.c() != end.c();
  }

  /** The straight line. */
  record Line(Frame start, Frame end) implements Curve {
    @Override
    public Frame at(double parameter) {
      return Curve.isTurn(start, end)
          ? start.interpolate(end, parameter)
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
      return start.angle(end);
    }
  }
}
