package no.hials.crosscom.simulator.internal.motion;

import java.util.Arrays;

/**
 * The fastest profile within limits that change along the path: between two of its points the
 * acceleration is constant.
 */
final class SampledProfile implements Profile {
  private final double[] positions;
  private final double[] speeds;
  private final double[] times;

  private SampledProfile(double[] positions, double[] speeds, double[] times) {
    this.positions = positions;
    this.speeds = speeds;
    this.times = times;
  }

  /**
   * Creates the fastest profile from standstill to standstill, at no point above the limits.
   *
   * @param positions at least three points of the path, ascending
   * @param speeds the highest speed at each point
   * @param accelerations the highest acceleration at each point
   */
  static SampledProfile of(double[] positions, double[] speeds, double[] accelerations) {
    int last = positions.length - 1;
    double[] reached = speeds.clone();
    reached[0] = 0;
    reached[last] = 0;
    for (int i = 1; i <= last; i++) {
      reached[i] = Math.min(reached[i], after(i - 1, i, positions, reached, accelerations));
    }
    for (int i = last - 1; i >= 0; i--) {
      reached[i] = Math.min(reached[i], after(i + 1, i, positions, reached, accelerations));
    }
    double[] times = new double[positions.length];
    for (int i = 1; i <= last; i++) {
      double distance = positions[i] - positions[i - 1];
      times[i] = times[i - 1] + 2 * distance / (reached[i - 1] + reached[i]);
    }
    return new SampledProfile(positions.clone(), reached, times)
        .stretchedTo(2 * Trapezoid.SHORTEST_RAMP);
  }

  /** Returns the highest speed at a point that follows from the speed at its neighbour. */
  private static double after(
      int from, int to, double[] positions, double[] reached, double[] accelerations) {
    double distance = Math.abs(positions[to] - positions[from]);
    double acceleration = Math.min(accelerations[from], accelerations[to]);
    return Math.sqrt(reached[from] * reached[from] + 2 * acceleration * distance);
  }

  private SampledProfile stretchedTo(double shortest) {
    double factor = shortest / duration();
    return factor <= 1
        ? this
        : new SampledProfile(
            positions,
            Arrays.stream(speeds).map(speed -> speed / factor).toArray(),
            Arrays.stream(times).map(time -> time * factor).toArray());
  }

  @Override
  public double duration() {
    return times[times.length - 1];
  }

  @Override
  public double position(double time) {
    if (time >= duration()) {
      return positions[positions.length - 1];
    }
    int found = Arrays.binarySearch(times, time);
    int from = found >= 0 ? found : -found - 2;
    double inside = time - times[from];
    double acceleration = (speeds[from + 1] - speeds[from]) / (times[from + 1] - times[from]);
    return positions[from] + inside * (speeds[from] + acceleration * inside / 2);
  }

  @Override
  public double rampUp() {
    int i = 0;
    while (i < speeds.length - 1 && speeds[i + 1] > speeds[i]) {
      i++;
    }
    return Math.min(times[i], duration() / 2);
  }

  @Override
  public double rampDown() {
    int i = speeds.length - 1;
    while (i > 0 && speeds[i - 1] > speeds[i]) {
      i--;
    }
    return Math.min(duration() - times[i], duration() / 2);
  }
}
