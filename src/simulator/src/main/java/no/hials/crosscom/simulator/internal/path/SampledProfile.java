package no.hials.crosscom.simulator.internal.path;

import java.util.Arrays;

/**
 * The fastest profile within limits that change along the path. Between two points it speeds up,
 * keeps a speed, and slows down; where the limit falls or rises the acceleration is constant.
 */
public final class SampledProfile implements Profile {
  private final double[] positions;
  private final double[] speeds;

  /** Of each interval: the speed between, and how long it takes to reach and to keep it, s. */
  private final double[] between;

  private final double[] reaching;
  private final double[] keeping;
  private final double[] times;

  private SampledProfile(double[] positions, double[] speeds, int intervals) {
    this.positions = positions;
    this.speeds = speeds;
    between = new double[intervals];
    reaching = new double[intervals];
    keeping = new double[intervals];
    times = new double[positions.length];
  }

  /** Creates the fastest profile from standstill to standstill, at no point above the limits. */
  public static SampledProfile of(PathLimits limits) {
    double[] speeds = limits.highest(0);
    speeds[speeds.length - 1] = 0;
    reach(limits, speeds);
    return through(limits, speeds, 2 * Trapezoid.SHORTEST_RAMP);
  }

  /** Lowers speeds to those that can be reached from one point to the next. */
  public static void reach(PathLimits limits, double[] speeds) {
    reachForward(limits, speeds);
    reachBackward(limits, speeds);
  }

  public static void reachForward(PathLimits limits, double[] speeds) {
    for (int i = 1; i < speeds.length; i++) {
      speeds[i] = Math.min(speeds[i], limits.reached(i - 1, speeds[i - 1]));
    }
  }

  public static void reachBackward(PathLimits limits, double[] speeds) {
    for (int i = speeds.length - 2; i >= 0; i--) {
      speeds[i] = Math.min(speeds[i], limits.reached(i, speeds[i + 1]));
    }
  }

  /**
   * Creates the fastest profile with some speeds at the points.
   *
   * @param speeds speeds that can be reached from one point to the next
   * @param shortest the shortest duration, s
   */
  public static SampledProfile through(PathLimits limits, double[] speeds, double shortest) {
    int intervals = speeds.length - 1;
    SampledProfile profile = new SampledProfile(limits.parameters(), speeds.clone(), intervals);
    for (int i = 0; i < intervals; i++) {
      profile.times[i + 1] = profile.times[i] + profile.plan(i, limits);
    }
    double factor = shortest / profile.duration();
    return factor <= 1 ? profile : profile.stretched(factor);
  }

  /** Plans an interval, and returns its duration. */
  private double plan(int i, PathLimits limits) {
    double distance = positions[i + 1] - positions[i];
    double first = speeds[i];
    double last = speeds[i + 1];
    double limit = Math.min(limits.speeds()[i], limits.speeds()[i + 1]);
    double most = limits.acceleration(i);
    if (limit < Math.max(first, last)) {
      between[i] = last;
      reaching[i] = 2 * distance / (first + last);
      return reaching[i];
    }
    double peak = Math.min(limit, Math.sqrt(most * distance + (first * first + last * last) / 2));
    between[i] = Math.max(peak, Math.max(first, last));
    reaching[i] = (between[i] - first) / most;
    double slowing = (between[i] - last) / most;
    double ramps = reaching[i] * (first + between[i]) / 2 + slowing * (between[i] + last) / 2;
    keeping[i] = Math.max(0, distance - ramps) / between[i];
    return reaching[i] + keeping[i] + slowing;
  }

  private SampledProfile stretched(double factor) {
    SampledProfile longer = new SampledProfile(positions, divided(speeds, factor), between.length);
    copy(divided(between, factor), longer.between);
    copy(divided(reaching, 1 / factor), longer.reaching);
    copy(divided(keeping, 1 / factor), longer.keeping);
    copy(divided(times, 1 / factor), longer.times);
    return longer;
  }

  private static double[] divided(double[] values, double by) {
    return Arrays.stream(values).map(value -> value / by).toArray();
  }

  private static void copy(double[] from, double[] to) {
    System.arraycopy(from, 0, to, 0, to.length);
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
    int i = interval(times, time);
    double inside = Math.max(0, time - times[i]);
    double kept = inside - reaching[i];
    if (kept < 0) {
      double acceleration = (between[i] - speeds[i]) / reaching[i];
      return positions[i] + inside * (speeds[i] + acceleration * inside / 2);
    }
    double left = times[i + 1] - time;
    if (kept < keeping[i]) {
      return positions[i] + reaching[i] * (speeds[i] + between[i]) / 2 + kept * between[i];
    }
    return left <= 0
        ? positions[i + 1]
        : positions[i + 1] - left * (speeds[i + 1] + slowing(i) * left / 2);
  }

  @Override
  public double speed(double time) {
    if (time >= duration()) {
      return speeds[speeds.length - 1];
    }
    int i = interval(times, time);
    double inside = Math.max(0, time - times[i]);
    if (inside < reaching[i]) {
      return speeds[i] + (between[i] - speeds[i]) * inside / reaching[i];
    }
    double left = times[i + 1] - time;
    return inside - reaching[i] < keeping[i]
        ? between[i]
        : speeds[i + 1] + slowing(i) * Math.max(0, left);
  }

  @Override
  public double time(double position) {
    if (position <= positions[0]) {
      return 0;
    }
    if (position >= positions[positions.length - 1]) {
      return duration();
    }
    int i = interval(positions, position);
    double way = position - positions[i];
    double ramp = reaching[i] * (speeds[i] + between[i]) / 2;
    if (way < ramp) {
      return times[i] + solve(way, speeds[i], (between[i] - speeds[i]) / reaching[i]);
    }
    double left = positions[i + 1] - position;
    double last = times[i + 1] - times[i] - reaching[i] - keeping[i];
    double slowed = last * (between[i] + speeds[i + 1]) / 2;
    return left < slowed
        ? times[i + 1] - solve(left, speeds[i + 1], slowing(i))
        : times[i] + reaching[i] + (way - ramp) / between[i];
  }

  /** Returns the time of a way that starts with a speed. */
  private static double solve(double way, double speed, double acceleration) {
    return way <= 0
        ? 0
        : 2 * way / (speed + Math.sqrt(Math.max(0, speed * speed + 2 * acceleration * way)));
  }

  private double slowing(int i) {
    double time = times[i + 1] - times[i] - reaching[i] - keeping[i];
    return time <= 0 ? 0 : (between[i] - speeds[i + 1]) / time;
  }

  private static int interval(double[] ascending, double value) {
    int found = Arrays.binarySearch(ascending, value);
    return Math.max(0, Math.min(ascending.length - 2, found >= 0 ? found : -found - 2));
  }

  @Override
  public double rampUp() {
    int i = 0;
    while (i < between.length
        && keeping[i] == 0
        && speeds[i + 1] > speeds[i]
        && between[i] <= speeds[i + 1]) {
      i++;
    }
    double more = i < between.length && between[i] > speeds[i] ? reaching[i] : 0;
    return Math.min(times[i] + more, duration() / 2);
  }

  @Override
  public double rampDown() {
    int i = between.length;
    while (i > 0
        && keeping[i - 1] == 0
        && speeds[i - 1] > speeds[i]
        && between[i - 1] <= speeds[i - 1]) {
      i--;
    }
    double more = i > 0 ? times[i] - times[i - 1] - reaching[i - 1] - keeping[i - 1] : 0;
    return Math.min(duration() - times[i] + more, duration() / 2);
  }
}
