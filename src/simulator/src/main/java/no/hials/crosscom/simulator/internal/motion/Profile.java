package no.hials.crosscom.simulator.internal.motion;

/** The position of a motion on its path, over the time that it takes at 100 % override. */
sealed interface Profile permits Trapezoid, SampledProfile {
  /** Returns the time of the motion, s. */
  double duration();

  /** Returns the position after some time, in the unit of the path. */
  double position(double time);

  /** Returns how long it only speeds up, s; at most half of the duration. */
  double rampUp();

  /** Returns how long it only slows down, s; at most half of the duration. */
  double rampDown();
}
