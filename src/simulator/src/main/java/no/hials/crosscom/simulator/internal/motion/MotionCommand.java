package no.hials.crosscom.simulator.internal.motion;

import no.hials.crosscom.kinematics.Frame;

/** Asks for one motion of a program, with all that the advance run has resolved. */
public sealed interface MotionCommand permits PointToPoint, Linear, Circular {
  /**
   * Gives the number by which the core knows the motion in events.
   *
   * @return any number
   */
  long id();

  /**
   * Gives the tool that is moved.
   *
   * @return the TCP in the flange ({@code $TOOL})
   */
  Frame tool();

  /**
   * Says whether the end may be cut short into the next motion.
   *
   * @return where the blend may begin
   */
  ApproximationZone approximation();
}
