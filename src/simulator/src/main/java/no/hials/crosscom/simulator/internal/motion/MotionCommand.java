package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Frame;

/** One motion of a program, as the advance run has resolved it. */
public sealed interface MotionCommand permits PointToPoint, Linear, Circular {
  /** Returns the number of the motion, by which events name it. */
  long id();

  /** Returns the TCP in the flange ({@code $TOOL}). */
  Frame tool();

  /** Returns where the blend into the next motion can start. */
  ApproximationZone approximation();
}
