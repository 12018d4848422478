package no.hials.crosscom.simulator.internal.path;

/**
 * Speeds up evenly, keeps one speed, and slows down as it sped up; a short motion leaves out the
 * middle.
 */
public record Trapezoid(double length, double speed, double ramp, double duration)
    implements Profile {
  /**
   * The shortest ramp, s: longer than a cycle, so that in a chain of the smallest motions the core
   * has a cycle to plan each one. Assumed.
   */
  public static final double SHORTEST_RAMP = 0.015;

  /**
   * Creates the profile of a path.
   *
   * @param length the length of the path; without a length the profile has no duration
   * @param speed the highest speed, in lengths/s
   * @param acceleration the highest acceleration, in lengths/s²
   */
  public static Trapezoid of(double length, double speed, double acceleration) {
    if (length == 0) {
      return new Trapezoid(0, 0, 0, 0);
    }
    double fastest = Math.min(speed, Math.sqrt(length * acceleration));
    double ramp = Math.max(SHORTEST_RAMP, fastest / acceleration);
    double reached = Math.min(speed, length / ramp);
    return new Trapezoid(length, reached, ramp, length / reached + ramp);
  }

  @Override
  public double position(double time) {
    double left = duration - time;
    if (left <= 0) {
      return length;
    }
    if (time < ramp) {
      return speed / ramp / 2 * time * time;
    }
    return left < ramp ? length - speed / ramp / 2 * left * left : speed * (time - ramp / 2);
  }

  @Override
  public double speed(double time) {
    double left = duration - time;
    return left <= 0 || time <= 0 ? 0 : speed * Math.min(1, Math.min(time, left) / ramp);
  }

  @Override
  public double time(double position) {
    double way = Math.max(0, Math.min(length, position));
    double inRamp = speed * ramp / 2;
    if (length == 0) {
      return 0;
    }
    if (way < inRamp) {
      return Math.sqrt(2 * way * ramp / speed);
    }
    double left = length - way;
    return left < inRamp ? duration - Math.sqrt(2 * left * ramp / speed) : way / speed + ramp / 2;
  }

  @Override
  public double rampUp() {
    return ramp;
  }

  @Override
  public double rampDown() {
    return ramp;
  }
}
