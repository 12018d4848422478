package no.hials.crosscom.simulator.internal.path;

/** The position of a motion on its path, over the time that it takes at 100 % override. */
public sealed interface Profile permits Trapezoid, SampledProfile, Profile.Changed {
  /** Returns the time of the motion, s. */
  double duration();

  /** Returns the position after some time, in the unit of the path. */
  double position(double time);

  /** Returns the speed after some time, in the unit of the path/s. */
  double speed(double time);

  /** Returns the time at which it reaches a position, s; 0 or the duration beyond its ends. */
  double time(double position);

  /** Returns how long it only speeds up, s; at most half of the duration. */
  double rampUp();

  /** Returns how long it only slows down, s; at most half of the duration. */
  double rampDown();

  /**
   * A profile that continues in another way.
   *
   * @param time the time at which it changes, s
   */
  record Changed(Profile before, double time, Profile after) implements Profile {
    @Override
    public double duration() {
      return time + after.duration();
    }

    @Override
    public double position(double at) {
      return at < time ? before.position(at) : after.position(at - time);
    }

    @Override
    public double speed(double at) {
      return at < time ? before.speed(at) : after.speed(at - time);
    }

    @Override
    public double time(double position) {
      return position < after.position(0) ? before.time(position) : time + after.time(position);
    }

    @Override
    public double rampUp() {
      return Math.min(before.rampUp(), duration() / 2);
    }

    @Override
    public double rampDown() {
      return Math.min(after.rampDown(), duration() / 2);
    }
  }
}
