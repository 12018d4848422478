package no.hials.crosscom.simulator.internal.motion;

/** How far a motion is on its path, over the time that it takes at 100 % override. */
sealed interface Profile permits Trapezoid, SampledProfile {
  /** Gives how long the motion takes, s. */
  double duration();

  /** Gives how far it is after some time, in the unit of the path. */
  double position(double time);

  /** Gives how long it does nothing but speed up, s; at most half of the duration. */
  double rampUp();

  /** Gives how long it does nothing but slow down, s; at most half of the duration. */
  double rampDown();
}
